// Chooses and builds the preconditioner that takes the least time for a configuration, by its
// number of nodes and its narrow gaps (chapter 13, section "When it pays"): blocks of single
// components, a tree of groups, clusters of neighbours, or a factorisation. The last three assemble
// the double layer between components (02.6); at near nodes a scheme of close evaluation replaces
// the trapezoid rule (06.17).
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
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// Wide, narrow and tight gaps are at most that large, over the smaller radius of gyration.
constexpr double wide = 0.5, narrow = 0.05, tight = 0.005;

// Tolerance of the layers between components: a preconditioner may have errors of this size.
constexpr double layer_tolerance = 1e-3;

using Inverses = std::map<const DiscretisedShape*, std::shared_ptr<const MatrixXd>>;

bool is_enclosing_wall(const std::shared_ptr<const DiscretisedShape>& discretised) {
  return discretised->kind == ComponentKind::enclosing_wall;
}

bool is_inner(const std::shared_ptr<const DiscretisedShape>& discretised) {
  return !is_enclosing_wall(discretised);
}

bool is_prescribed(const std::shared_ptr<const DiscretisedShape>& discretised) {
  return discretised->kind == ComponentKind::prescribed;
}

// Returns whether the farthest point of a body is more than 2.5 times as far from its centre as the
// nearest one.
bool is_elongated(const std::shared_ptr<const DiscretisedShape>& discretised) {
  const Eigen::ArrayXd distances = discretised->curve.x.cwiseAbs();
  return is_inner(discretised) && distances.maxCoeff() > 2.5 * distances.minCoeff();
}

// Counts the pairs whose gap is less than `reach` times the smaller radius of gyration.
std::size_t pairs_within(double reach, const std::vector<Gap>& gaps,
                         const Discretisation& discretisation) {
  return static_cast<std::size_t>(std::ranges::count_if(gaps, [&](const Gap& gap) {
    const double radius =
        std::min(discretisation[gap.a]->gyration_radius, discretisation[gap.b]->gyration_radius);
    return gap.points.gap < reach * radius;
  }));
}

// Returns the gaps without those at an enclosing wall.
std::vector<Gap> inner_gaps(std::vector<Gap> gaps, const Discretisation& discretisation) {
  std::erase_if(gaps, [&](const Gap& gap) {
    return is_enclosing_wall(discretisation[gap.a]) || is_enclosing_wall(discretisation[gap.b]);
  });
  return gaps;
}

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

// Inverts the cluster_block() of each distinct inner shape, and returns the inverse of every inner
// component. Enclosing walls have none.
std::vector<BlockDiagonalPreconditioner::Member> components_alone(
    const Configuration& configuration, const Discretisation& discretisation, ClusterForm form,
    double gauge) {
  Inverses inverses;
  std::vector<const DiscretisedShape*> distinct;
  for (const auto& discretised : discretisation) {
    if (inverses.try_emplace(discretised.get()).second && is_inner(discretised)) {
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

bool direct_pays(const Plan& plan, const std::vector<Gap>& gaps,
                 const Discretisation& discretisation, double separation) {
  constexpr Index most_nodes = 1000, most_nodes_a_contact = 400;
  // A tree of groups of free bodies takes less time for more nodes than this. Where there is one,
  // only tighter gaps, over the smaller radius of gyration, slow GMRES down so much that a
  // factorisation pays.
  const bool has_tree = plan.tree_allowed && std::ranges::none_of(discretisation, is_prescribed);
  const Index most_nodes_at_gaps = has_tree ? 400 : most_nodes;
  const double largest_gap = has_tree ? 0.003 : 0.02;
  constexpr double in_contact = 1.1;  // gaps of pairs that a step may press together / separation
  Index nodes = 0;
  for (const auto& discretised : discretisation) nodes += discretised->curve.size();
  if (nodes > most_nodes) return false;
  const auto contacts = std::ranges::count_if(
      gaps, [&](const Gap& gap) { return gap.points.gap < in_contact * separation; });
  return nodes <= most_nodes_a_contact * contacts ||
         (nodes <= most_nodes_at_gaps &&
          3 * pairs_within(largest_gap, gaps, discretisation) >= discretisation.size());
}

bool tree_pays(const Plan& plan, const std::vector<Gap>& gaps,
               const Discretisation& discretisation) {
  constexpr Index most_nodes = 256;
  // Tight or narrow gaps slow GMRES down so much that a tree pays, if there is one for this number
  // of components. With few digits, narrow gaps do so between elongated bodies alone.
  constexpr std::size_t components_a_tight_gap = 60, components_a_narrow_gap = 12;
  constexpr double few_digits = 5.5;
  // Many wide gaps between many components do so, too, unless most components are far from all
  // others. The number of iterations and the time of each grow with the number of digits.
  constexpr std::size_t components_a_wide_gap = 10;
  constexpr double many = 245e3;
  // Within a wall, many bodies move little under smooth loads, and GMRES takes few iterations
  // without a tree, unless elongated bodies lock each other.
  constexpr double many_within_wall = 3.0;
  const double digits = -std::log10(plan.gmres_tolerance);
  if (std::ranges::any_of(discretisation, [](const auto& discretised) {
        return is_inner(discretised) && discretised->curve.size() > most_nodes;
      })) {
    return false;
  }
  const std::vector<Gap> inner = inner_gaps(gaps, discretisation);
  const std::size_t count = discretisation.size(),
                    n_narrow = pairs_within(narrow, inner, discretisation),
                    n_wide = pairs_within(wide, inner, discretisation);
  const bool has_elongated = std::ranges::any_of(discretisation, is_elongated);
  if (std::ranges::any_of(discretisation, is_enclosing_wall) &&
      static_cast<double>(count) > many_within_wall * digits * digits) {
    return has_elongated && 2 * n_narrow >= 3 * count;
  }
  return components_a_tight_gap * pairs_within(tight, inner, discretisation) >= count ||
         (components_a_narrow_gap * n_narrow >= count && (digits > few_digits || has_elongated)) ||
         (components_a_wide_gap * n_wide >= count &&
          digits * digits * static_cast<double>(count * n_wide) >= many);
}

bool is_crystal(const std::vector<Gap>& gaps, const Discretisation& discretisation) {
  constexpr std::size_t most_in_tree = 30;
  const std::size_t count = discretisation.size();
  return count > most_in_tree && std::ranges::none_of(discretisation, is_prescribed) &&
         pairs_within(tight, inner_gaps(gaps, discretisation), discretisation) >= 2 * count;
}

PreconditionerKind chosen_preconditioner(const Plan& plan, const std::vector<Gap>& gaps,
                                         const Discretisation& discretisation, double separation) {
  if (plan.direct_allowed && direct_pays(plan, gaps, discretisation, separation)) {
    return PreconditionerKind::direct;
  }
  if (plan.tree_allowed && tree_pays(plan, gaps, discretisation)) {
    return is_crystal(gaps, discretisation) ? PreconditionerKind::clusters
                                            : PreconditionerKind::hierarchical;
  }
  return plan.preconditioner;
}

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
    if (is_inner(discretisation[k])) largest = std::max(largest, radius[k]);
  }
  const RectangleIndex index(rectangles);
  std::vector<std::vector<Neighbour>> neighbours(count);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t a = 0; a < count; ++a) {
    if (!is_inner(discretisation[a])) continue;
    // Rectangles are widened by the largest gap of a neighbour, which exceeds the distance by which
    // a curve can leave the bounding rectangle of its nodes.
    const double widening = 0.5 * cluster_reach * (radius[a] + largest);
    for (const std::size_t b : index.meeting(widened(rectangles[a], widening))) {
      if (b == a || !is_inner(discretisation[b])) continue;
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
    if (is_enclosing_wall(discretisation[k])) {
      alone[k].inverse = discretisation[k]->inverse_block.get();
    }
  }
  return {problem, form, std::move(alone), cluster_neighbours(configuration, discretisation),
          layer_blocks(problem, placed, layer_tolerance)};
}

HierarchySettings hierarchy_settings(const std::vector<Gap>& gaps,
                                     const Discretisation& discretisation) {
  const std::vector<Gap> inner = inner_gaps(gaps, discretisation);
  const std::size_t count = discretisation.size();
  if (pairs_within(narrow, inner, discretisation) >= count) {
    return {.tolerance = 0.55, .group_tolerance = 0.33, .reach = 1.5};
  }
  // A chain with tight gaps amplifies what is left out, and few directions couple its groups.
  if (2 * pairs_within(tight, inner, discretisation) >= count &&
      pairs_within(wide, inner, discretisation) < count) {
    // The last inverse is large, as no further level is accurate enough, but takes less than 0.25 MB
    // for each component.
    const double root = std::min(2500.0, 350.0 * std::sqrt(static_cast<double>(count)));
    return {.tolerance = 0.2, .group_tolerance = 0.06, .root = static_cast<Index>(root)};
  }
  // With the same tolerances, iterations would grow with the number of components.
  constexpr double few = 500.0;
  const double times = std::max(1.0, static_cast<double>(count) / few);
  const double fall = std::pow(times, -0.1);
  HierarchySettings settings;
  settings.tolerance *= fall;
  settings.group_tolerance *= fall;
  return settings;
}

HierarchicalPreconditioner hierarchical_preconditioner(const StokesProblem& problem,
                                                       const Configuration& configuration,
                                                       const Discretisation& discretisation,
                                                       const std::vector<PlacedCurve>& placed,
                                                       const HierarchySettings& settings) {
  return {
      problem,
      components_alone(configuration, discretisation, ClusterForm::mobility, held_gauge(problem)),
      layer_blocks(problem, placed, layer_tolerance), settings};
}

LinearMap make_preconditioner(PreconditionerKind kind, const Plan& plan, const Scene& scene,
                              const StokesProblem& problem, const Configuration& configuration,
                              const std::vector<Gap>& gaps, const Discretisation& discretisation,
                              const std::vector<PlacedCurve>& placed) {
  if (kind == PreconditionerKind::none) return {};
  if (kind == PreconditionerKind::direct) {
    return DirectPreconditioner(problem, layer_blocks(problem, placed, plan.near_tolerance));
  }
  try {
    if (kind == PreconditionerKind::clusters) {
      return cluster_preconditioner(problem, configuration, discretisation, placed);
    }
    if (kind == PreconditionerKind::hierarchical) {
      return hierarchical_preconditioner(problem, configuration, discretisation, placed,
                                         hierarchy_settings(gaps, discretisation));
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
    if (is_iterated && is_enclosing_wall(discretisation[k]) &&
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
  return BlockDiagonalPreconditioner(std::move(members));
}

}  // namespace stokesbook
