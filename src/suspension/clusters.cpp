#include "suspension/clusters.hpp"

#include <algorithm>
#include <map>

#include "closure/rigid_modes.hpp"
#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "near_singular/near_test.hpp"
#include "suspension/gaps.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// Of the layers between components, relative: a preconditioner may err as much.
constexpr double layer_tolerance = 1e-3;

// In mean radii of gyration: gaps within a cluster, those of contacts that may make a rigid network,
// and those that slow GMRES down, in few bodies and in many.
constexpr double cluster_reach = 2.0, contact = 0.05, tight = 0.003, tight_in_crowd = 0.005;

// As many bodies are a crowd.
constexpr std::size_t crowd = 150;

// The double layer of a curve at targets, near ones by its scheme of close evaluation.
MatrixXd layer_matrix(const Curve& source, const PlacedCurve* placed,
                      const ComplexVector& targets) {
  MatrixXd matrix = StressletSum({source}).matrix(targets);
  if (placed == nullptr) return matrix;
  const double reach = near_reach(source, layer_tolerance);
  std::vector<Index> near;
  for (Index i = 0; i < targets.size(); ++i) {
    if ((source.x.array() - targets[i]).abs2().minCoeff() < reach * reach &&
        is_near(source, targets[i], layer_tolerance)) {
      near.push_back(i);
    }
  }
  if (near.empty()) return matrix;
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

// Neighbours of each component with gaps below `reach` mean radii of gyration.
std::vector<std::vector<Neighbour>> neighbours_within(double reach,
                                                      const Configuration& configuration,
                                                      const References& references) {
  const std::size_t count = references.size();
  const auto encloses = [&](std::size_t k) {
    return references[k]->kind == ComponentKind::enclosing_wall;
  };
  std::vector<double> radius;
  std::vector<Rectangle> rectangles;
  std::vector<SmoothCurve> curves;
  double largest = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    radius.push_back(RigidModes(references[k]->curve, {}).gyration_radius());
    curves.push_back(smooth_curve(*references[k], configuration[k]));
    rectangles.push_back(bounding_rectangle(curves[k].nodes.x));
    if (!encloses(k)) largest = std::max(largest, radius[k]);
  }
  const RectangleIndex index(rectangles);
  // At least what curves may bulge out of the rectangles of their nodes.
  const double widening = 0.5 * std::max(reach, 0.1);
  std::vector<std::vector<Neighbour>> neighbours(count);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t a = 0; a < count; ++a) {
    if (encloses(a)) continue;
    for (const std::size_t b :
         index.meeting(widened(rectangles[a], widening * (radius[a] + largest)))) {
      if (b == a || encloses(b)) continue;
      const double mean = 0.5 * (radius[a] + radius[b]);
      // In one order, so that both find the same gap.
      const double gap = closest_points(curves[std::min(a, b)], curves[std::max(a, b)]).gap;
      if (gap < reach * mean) neighbours[a].push_back({b, gap / mean});
    }
  }
  return neighbours;
}

// Pairs with gaps below `reach`, every one twice.
std::size_t twice_the_pairs(const std::vector<std::vector<Neighbour>>& neighbours, double reach) {
  std::size_t count = 0;
  for (const std::vector<Neighbour>& of_one : neighbours) {
    count += static_cast<std::size_t>(
        std::ranges::count_if(of_one, [=](const Neighbour& other) { return other.gap < reach; }));
  }
  return count;
}

}  // namespace

std::vector<std::vector<Neighbour>> cluster_neighbours(const Configuration& configuration,
                                                       const References& references) {
  return neighbours_within(cluster_reach, configuration, references);
}

bool clusters_pay(const Configuration& configuration, const References& references) {
  const auto is_fine = [](const auto& reference) {
    return reference->kind != ComponentKind::enclosing_wall && reference->curve.size() > 256;
  };
  if (std::ranges::any_of(references, is_fine)) return false;
  const std::size_t count = references.size();
  const auto neighbours = neighbours_within(tight_in_crowd, configuration, references);
  if (count >= crowd && twice_the_pairs(neighbours, tight_in_crowd) > 0) return true;
  return 3 * twice_the_pairs(neighbours, tight) >= 2 * count;
}

ClusterForm cluster_form(const std::vector<std::vector<Neighbour>>& neighbours) {
  const std::size_t count = neighbours.size();
  const bool rigid = twice_the_pairs(neighbours, contact) >= 2 * count;
  return count < crowd || rigid ? ClusterForm::resistance : ClusterForm::mobility;
}

ClusterPreconditioner cluster_preconditioner(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const References& references,
                                             const std::vector<PlacedCurve>& placed,
                                             std::optional<ClusterForm> given_form) {
  const auto neighbours = cluster_neighbours(configuration, references);
  const ClusterForm form = given_form.value_or(cluster_form(neighbours));
  const double gauge = held_gauge(problem);
  std::map<const Reference*, std::shared_ptr<const MatrixXd>> inverses;
  for (const auto& reference : references) inverses[reference.get()];
  std::vector<const Reference*> distinct;
  for (const auto& [reference, inverse] : inverses) distinct.push_back(reference);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < distinct.size(); ++k) {
    const Reference& reference = *distinct[k];
    inverses.at(&reference) = std::make_shared<const MatrixXd>(invert_block(
        cluster_block({reference.kind, reference.curve, {}, {}, 0.0, {}}, form, gauge)));
  }
  std::vector<BlockDiagonalPreconditioner::Member> alone;
  for (std::size_t k = 0; k < references.size(); ++k) {
    alone.push_back({inverses.at(references[k].get()), configuration[k].orientation});
  }
  const LayerBlock layer = [&](std::size_t target, std::size_t source) {
    return layer_matrix(problem.components[source].curve,
                        placed.empty() ? nullptr : &placed[source],
                        problem.components[target].curve.x);
  };
  return {problem, form, std::move(alone), neighbours, layer};
}

}  // namespace stokesbook
