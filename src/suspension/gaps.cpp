#include "suspension/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "near_singular/near_test.hpp"

namespace stokesbook {

namespace {

// Bounding circles of all components and the reach of their trapezoid rules.
class BroadPhase {
 public:
  BroadPhase(const Configuration& configuration, const References& references, double tolerance)
      : configuration_(configuration) {
    for (const auto& reference : references) {
      radius_.push_back(bounding_radius(reference->curve, 0.0));
      reach_.push_back(near_reach(reference->curve, tolerance));
      encloses_.push_back(reference->curve.side == Side::fluid_inside);
    }
  }

  // Lower bound of a gap; an enclosing wall need not be convex, its bounding circle says nothing.
  double least_gap(std::size_t a, std::size_t b) const {
    if (encloses_[a] || encloses_[b]) return 0.0;
    return std::abs(configuration_[a].position - configuration_[b].position) - radius_[a] -
           radius_[b];
  }

  bool in_reach(std::size_t a, std::size_t b) const {
    return least_gap(a, b) < std::max(reach_[a], reach_[b]);
  }

 private:
  const Configuration& configuration_;
  std::vector<double> radius_, reach_;
  std::vector<bool> encloses_;
};

}  // namespace

std::string component_name(const Scene& scene, std::size_t component) {
  const std::size_t bodies = scene.bodies.size();
  return component < bodies ? "body " + std::to_string(component)
                            : "wall " + std::to_string(component - bodies);
}

int given_nodes(const Scene& scene, std::size_t component) {
  const std::size_t bodies = scene.bodies.size();
  return component < bodies ? scene.bodies[component].n_nodes
                            : scene.walls[component - bodies].n_nodes;
}

SmoothCurve smooth_curve(const Reference& reference, const Placement& placement) {
  return {place(reference.curve, placement.position, placement.orientation), reference.interpolant,
          placement.position, placement.orientation};
}

std::vector<Gap> find_gaps(const Configuration& configuration, const References& references,
                           double tolerance) {
  const BroadPhase broad(configuration, references, tolerance);
  const std::size_t count = configuration.size();
  std::vector<SmoothCurve> curves;
  std::vector<Gap> gaps;
  for (std::size_t a = 0; a < count; ++a) {
    curves.push_back(smooth_curve(*references[a], configuration[a]));
    for (std::size_t b = a + 1; b < count; ++b) {
      if (broad.in_reach(a, b)) gaps.push_back({a, b, {}});
    }
  }
  const auto close_pairs = static_cast<std::ptrdiff_t>(gaps.size());
#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t i = 0; i < close_pairs; ++i) {
    Gap& gap = gaps[static_cast<std::size_t>(i)];
    gap.points = closest_points(curves[gap.a], curves[gap.b]);
  }
  const auto by_gap = [](const Gap& p, const Gap& q) { return p.points.gap < q.points.gap; };
  std::sort(gaps.begin(), gaps.end(), by_gap);
  // A pair out of reach matters only where it is the closest of all.
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      const bool may_be_closest = gaps.empty() || broad.least_gap(a, b) < gaps.front().points.gap;
      if (broad.in_reach(a, b) || !may_be_closest) continue;
      const Gap gap{a, b, closest_points(curves[a], curves[b])};
      if (gaps.empty() || by_gap(gap, gaps.front())) gaps.insert(gaps.begin(), gap);
    }
  }
  return gaps;
}

GapResolution gap_resolution(const Gap& gap, const Configuration& configuration,
                             const References& references) {
  const Reference& a = *references[gap.a];
  const Reference& b = *references[gap.b];
  const DensityDecay decay = density_decay(smooth_curve(a, configuration[gap.a]),
                                           smooth_curve(b, configuration[gap.b]), gap.points);
  const auto error = [](const Reference& reference, double parameter, double depth) {
    if (std::isinf(depth)) return 0.0;
    const Resolution& nodes = reference.resolution;
    return resolution_error(graded_depth(nodes.grading, parameter, depth), nodes.n_nodes);
  };
  return {decay, std::max(error(a, gap.points.parameter_a, decay.a),
                          error(b, gap.points.parameter_b, decay.b))};
}

}  // namespace stokesbook
