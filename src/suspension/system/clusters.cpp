// Builds the preconditioner by clusters (chapter 05, section "Bodies that nearly touch"): finds the
// neighbours of each component, chooses the form of the clusters, and inverts the block of each
// distinct shape.
#include "suspension/system/clusters.hpp"

#include <algorithm>
#include <exception>
#include <map>

#include "suspension/system/layer_blocks.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

using Eigen::MatrixXd;

namespace {

// Tolerance of the layers between components: a preconditioner may have errors of this size.
constexpr double layer_tolerance = 1e-3;

// Largest gaps, over the mean radius of gyration of a pair: of neighbours in a cluster, and of
// contacts, which may make a rigid network.
constexpr double cluster_reach = 2.0, touching = 0.05;

using Inverses = std::map<const DiscretisedShape*, std::shared_ptr<const MatrixXd>>;

// Inverts the cluster_block() of each distinct shape.
Inverses inverse_blocks(const Discretisation& discretisation, ClusterForm form, double gauge) {
  Inverses inverses;
  std::vector<const DiscretisedShape*> distinct;
  for (const auto& discretised : discretisation) {
    if (inverses.try_emplace(discretised.get()).second) distinct.push_back(discretised.get());
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
  return inverses;
}

}  // namespace

std::vector<std::vector<Neighbour>> cluster_neighbours(const Configuration& configuration,
                                                       const Discretisation& discretisation) {
  const std::size_t count = discretisation.size();
  const auto encloses = [&](std::size_t k) {
    return discretisation[k]->kind == ComponentKind::enclosing_wall;
  };
  std::vector<double> radius;
  std::vector<Rectangle> rectangles;
  std::vector<SmoothCurve> curves;
  double largest = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    radius.push_back(discretisation[k]->gyration_radius);
    curves.push_back(smooth_curve(*discretisation[k], configuration[k]));
    rectangles.push_back(bounding_rectangle(curves[k].nodes.x));
    if (!encloses(k)) largest = std::max(largest, radius[k]);
  }
  const RectangleIndex index(rectangles);
  // Rectangles are widened by the largest gap of a neighbour, which exceeds the distance by which a
  // curve can leave the bounding rectangle of its nodes.
  const double widening = 0.5 * cluster_reach;
  std::vector<std::vector<Neighbour>> neighbours(count);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t a = 0; a < count; ++a) {
    if (encloses(a)) continue;
    for (const std::size_t b :
         index.meeting(widened(rectangles[a], widening * (radius[a] + largest)))) {
      if (b == a || encloses(b)) continue;
      const double mean = 0.5 * (radius[a] + radius[b]);
      // The smaller number comes first, so that both components find exactly the same gap.
      const double gap = closest_points(curves[std::min(a, b)], curves[std::max(a, b)]).gap;
      if (gap < cluster_reach * mean) neighbours[a].push_back({b, gap / mean});
    }
  }
  return neighbours;
}

ClusterForm cluster_form(const std::vector<std::vector<Neighbour>>& neighbours) {
  const std::size_t count = neighbours.size();
  std::size_t contacts = 0;  // each contact is counted from both sides
  for (const std::vector<Neighbour>& of_one : neighbours) {
    contacts += static_cast<std::size_t>(
        std::ranges::count_if(of_one, [](const Neighbour& other) { return other.gap < touching; }));
  }
  const bool rigid = contacts >= 2 * count;
  return count < cluster_crowd || rigid ? ClusterForm::resistance : ClusterForm::mobility;
}

ClusterPreconditioner cluster_preconditioner(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const Discretisation& discretisation,
                                             const std::vector<PlacedCurve>& placed,
                                             std::optional<ClusterForm> given_form) {
  const auto neighbours = cluster_neighbours(configuration, discretisation);
  const ClusterForm form = given_form.value_or(cluster_form(neighbours));
  const Inverses inverses = inverse_blocks(discretisation, form, held_gauge(problem));
  std::vector<BlockDiagonalPreconditioner::Member> alone;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    alone.push_back({inverses.at(discretisation[k].get()), configuration[k].orientation});
  }
  return {problem, form, std::move(alone), neighbours,
          layer_blocks(problem, placed, layer_tolerance)};
}

}  // namespace stokesbook
