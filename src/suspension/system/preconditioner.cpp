// Builds the preconditioner of a configuration (chapter 13): blocks of single components, a tree of
// groups, clusters of neighbours, or a factorisation. The last three assemble the double layer
// between components (02.6); at near nodes a scheme of close evaluation replaces the trapezoid rule
// (06.17).
#include "suspension/system/preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <utility>

#include "double_layer/stresslet_sum.hpp"
#include "krylov/direct.hpp"
#include "near_singular/near_field.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/system/preconditioner_choice.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// Tolerance of the layers between components: a preconditioner may have errors of this size.
constexpr double layer_tolerance = 1e-3;

using Inverses = std::map<const DiscretisedShape*, std::shared_ptr<const MatrixXd>>;

// Assembles the double layer of a curve at targets: rows of near targets by the scheme of close
// evaluation, all others by the trapezoid rule.
MatrixXd layer_matrix(const Curve& source, const PlacedCurve* placed, const ComplexVector& targets,
                      double tolerance) {
  MatrixXd matrix = StressletSum({source}).matrix(targets);
  if (placed == nullptr) return matrix;
  const double reach = near_reach(source, tolerance);
  std::vector<Index> near;
  for (Index i = 0; i < targets.size(); ++i) {
    if ((source.x.array() - targets[i]).abs2().minCoeff() < reach * reach &&
        is_near(source, targets[i], tolerance)) {
      near.push_back(i);
    }
  }
  if (near.empty()) return matrix;
  // Rows of the scheme are in the frame of the curve: R rows R^T in the plane, with the rotation R.
  const Complex turn = std::polar(1.0, placed->orientation);
  const ComplexVector local = (targets(near).array() - placed->position) / turn;
  const MatrixXd rows =
      std::visit([&](const auto& scheme) { return scheme->velocity_rows(local); }, placed->scheme);
  Eigen::Matrix2d rotation;
  rotation << turn.real(), -turn.imag(), turn.imag(), turn.real();
  for (std::size_t k = 0; k < near.size(); ++k) {
    for (Index j = 0; j < source.size(); ++j) {
      matrix.block<2, 2>(2 * near[k], 2 * j) =
          rotation * rows.block<2, 2>(2 * static_cast<Index>(k), 2 * j) * rotation.transpose();
    }
  }
  return matrix;
}

// Returns the double layer of any component at nodes of others. The arguments must outlive the
// result.
LayerBlock layer_blocks(const StokesProblem& problem, const std::vector<PlacedCurve>& placed,
                        double tolerance) {
  return [&, tolerance](const ComplexVector& targets, std::size_t source) {
    return layer_matrix(problem.components[source].curve,
                        placed.empty() ? nullptr : &placed[source], targets, tolerance);
  };
}

// Makes the schemes of enclosing walls keep their matrices, since the layer of a wall is assembled
// for a few bodies at a time. The scheme of equidistant nodes keeps them already.
std::vector<PlacedCurve> keep_matrices_of_walls(std::vector<PlacedCurve> placed,
                                                const Discretisation& discretisation) {
  for (std::size_t k = 0; k < placed.size(); ++k) {
    auto* scheme = std::get_if<std::shared_ptr<const CauchyCurve>>(&placed[k].scheme);
    const DiscretisedShape& discretised = *discretisation[k];
    if (!scheme || is_inner(discretised) || !discretised.resolution.is_graded()) continue;
    *scheme = std::make_shared<CauchyCurve>((*scheme)->curve(), KernelStorage::stored);
  }
  return placed;
}

// Inverts the cluster_block() of each distinct inner shape, and returns the inverse of every inner
// component. Enclosing walls have none.
std::vector<BlockDiagonalPreconditioner::Member> components_alone(
    const Configuration& configuration, const Discretisation& discretisation, ClusterForm form,
    double gauge) {
  Inverses inverses;
  std::vector<const DiscretisedShape*> distinct;
  for (const auto& discretised : discretisation) {
    if (inverses.try_emplace(discretised.get()).second && is_inner(*discretised)) {
      distinct.push_back(discretised.get());
    }
  }
  // An exception must not leave a parallel loop. If several shapes fail, the exception of the first
  // one is thrown.
  std::vector<std::exception_ptr> failures(distinct.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < distinct.size(); ++k) {
    const DiscretisedShape& discretised = *distinct[k];
    try {
      inverses.at(&discretised) = std::make_shared<const MatrixXd>(invert_block(
          cluster_block({discretised.kind, discretised.curve, {}, {}, 0.0, {}}, form, gauge)));
    } catch (...) {
      failures[k] = std::current_exception();
    }
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  std::vector<BlockDiagonalPreconditioner::Member> alone;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    alone.push_back({inverses.at(discretisation[k].get()), configuration[k].orientation});
  }
  return alone;
}

}  // namespace

std::vector<std::vector<Neighbour>> cluster_neighbours(const Configuration& configuration,
                                                       const Discretisation& discretisation) {
  // Largest gap of neighbours in a cluster, over the mean radius of gyration of the pair.
  constexpr double cluster_reach = 2.0;
  const std::size_t count = discretisation.size();
  std::vector<double> radius;
  std::vector<Rectangle> rectangles;
  std::vector<SmoothCurve> curves;
  double largest = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    radius.push_back(discretisation[k]->gyration_radius);
    curves.push_back(smooth_curve(*discretisation[k], configuration[k]));
    rectangles.push_back(bounding_rectangle(curves[k].nodes.x));
    if (is_inner(*discretisation[k])) largest = std::max(largest, radius[k]);
  }
  const RectangleIndex index(rectangles);
  std::vector<std::vector<Neighbour>> neighbours(count);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t a = 0; a < count; ++a) {
    if (!is_inner(*discretisation[a])) continue;
    // Rectangles are widened by the largest gap of a neighbour, which exceeds the distance by which
    // a curve can leave the bounding rectangle of its nodes.
    const double widening = 0.5 * cluster_reach * (radius[a] + largest);
    for (const std::size_t b : index.meeting(widened(rectangles[a], widening))) {
      if (b == a || !is_inner(*discretisation[b])) continue;
      const double mean = 0.5 * (radius[a] + radius[b]);
      // The smaller number comes first, so that both components find exactly the same gap.
      const double gap = closest_points(curves[std::min(a, b)], curves[std::max(a, b)]).gap;
      if (gap < cluster_reach * mean) neighbours[a].push_back({b, gap / mean});
    }
  }
  return neighbours;
}

ClusterPreconditioner cluster_preconditioner(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const Discretisation& discretisation,
                                             const std::vector<PlacedCurve>& placed,
                                             ClusterForm form) {
  auto alone = components_alone(configuration, discretisation, form, held_gauge(problem));
  for (std::size_t k = 0; k < alone.size(); ++k) {
    if (!is_inner(*discretisation[k])) {
      alone[k].inverse = discretisation[k]->inverse_block.get();
    }
  }
  return {problem, form, std::move(alone), cluster_neighbours(configuration, discretisation),
          layer_blocks(problem, placed, layer_tolerance)};
}

HierarchicalPreconditioner hierarchical_preconditioner(const StokesProblem& problem,
                                                       const Configuration& configuration,
                                                       const Discretisation& discretisation,
                                                       const std::vector<PlacedCurve>& placed,
                                                       const HierarchySettings& settings) {
  const std::vector<PlacedCurve> with_matrices = keep_matrices_of_walls(placed, discretisation);
  return {
      problem,
      components_alone(configuration, discretisation, ClusterForm::mobility, held_gauge(problem)),
      layer_blocks(problem, with_matrices, layer_tolerance), settings};
}

namespace {

// Returns the earlier tree of groups if it lasts, otherwise a new one.
SharedTree lasting_tree(const StokesProblem& problem, const Configuration& configuration,
                        const std::vector<Gap>& gaps, const Discretisation& discretisation,
                        const std::vector<PlacedCurve>& placed, const SharedTree& earlier) {
  std::vector<Index> offsets = node_offsets(problem);
  if (earlier && earlier->offsets == offsets &&
      tree_lasts(earlier->configuration, configuration, gaps, discretisation)) {
    return earlier;
  }
  return std::make_shared<const BuiltTree>(
      BuiltTree{hierarchical_preconditioner(problem, configuration, discretisation, placed,
                                            hierarchy_settings(gaps, discretisation)),
                std::move(offsets), configuration});
}

}  // namespace

Preconditioner make_preconditioner(PreconditionerKind kind, const Plan& plan, const Scene& scene,
                                   const StokesProblem& problem, const Configuration& configuration,
                                   const std::vector<Gap>& gaps,
                                   const Discretisation& discretisation,
                                   const std::vector<PlacedCurve>& placed,
                                   const SharedTree& earlier) {
  if (kind == PreconditionerKind::none) return {};
  if (kind == PreconditionerKind::direct) {
    return {DirectPreconditioner(problem, layer_blocks(problem, placed, plan.near_tolerance))};
  }
  try {
    if (kind == PreconditionerKind::clusters) {
      return {cluster_preconditioner(problem, configuration, discretisation, placed)};
    }
    if (kind == PreconditionerKind::hierarchical) {
      const SharedTree tree =
          lasting_tree(problem, configuration, gaps, discretisation, placed, earlier);
      return {[tree](const Eigen::VectorXd& v) { return tree->inverse(v); }, tree};
    }
  } catch (const std::domain_error& error) {
    throw SolverError("preconditioner by clusters or groups: " + std::string(error.what()) +
                      "; set solver.preconditioner = \"block_diagonal\"");
  }
  const bool is_iterated = scene.solver.coupling != Coupling::local;
  std::vector<BlockDiagonalPreconditioner::Member> members;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const DiscretisedShape& discretised = *discretisation[k];
    // The block of a circle has the eigenvalues -1 and -1/2 only: its inverse saves no iterations.
    if (is_iterated && !is_inner(*discretisation[k]) &&
        std::holds_alternative<Circle>(discretised.shape)) {
      members.push_back({{}, 0.0, discretised.curve.size()});
      continue;
    }
    try {
      members.push_back({discretised.inverse_block.get(), configuration[k].orientation});
    } catch (const std::domain_error& error) {
      throw SolverError(
          component_of(scene, k).name() + ": " + error.what() +
          "; a gauge_length close to the size of a held component is a degenerate scale");
    }
  }
  return {BlockDiagonalPreconditioner(std::move(members))};
}

}  // namespace stokesbook
