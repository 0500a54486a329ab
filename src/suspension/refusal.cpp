#include "suspension/refusal.hpp"

#include <algorithm>
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "near_singular/near_test.hpp"
#include "record/number_text.hpp"

namespace stokesbook {

namespace {

// Curves that are apart by no more than rounding of their positions touch.
bool overlaps(const Gap& gap, const Configuration& configuration) {
  const Complex point = gap.points.point_a;
  const double size = std::abs(point) + std::abs(point - configuration[gap.a].position);
  return gap.points.gap <= 1e-14 * size;
}

std::string overlap_message(const Scene& scene, const Gap& gap) {
  return component_name(scene, gap.a) + " and " + component_name(scene, gap.b) +
         " overlap, touch or lie on the wrong side of each other, by about " +
         short_number(-gap.points.gap) + " near (" + short_number(gap.points.point_a.real()) +
         ", " + short_number(gap.points.point_a.imag()) +
         "): move them apart, or take smaller steps if this happened during a run";
}

std::string shape_message(const Scene& scene, std::size_t component, const Reference& reference) {
  const int nodes =
      nodes_for_shape(reference, scene.solver.tolerance, static_cast<int>(reference.curve.size()));
  return component_name(scene, component) + ": " + std::to_string(reference.curve.size()) +
         " nodes resolve its shape to " + short_number(reference.rigid_motion_residual) +
         " only, solver.tolerance = " + short_number(scene.solver.tolerance) +
         (nodes > 0
              ? "; give it n_nodes = " + std::to_string(nodes) + " at least"
              : "; even 4096 nodes do not resolve it: smooth the curve or raise the tolerance");
}

// Without near corrections the trapezoid rule of either curve must do at the other's nearest point.
std::string plain_rule_message(const Scene& scene, const Gap& gap, const SmoothCurve& a,
                               const SmoothCurve& b) {
  const auto error = [](const Curve& curve, Complex target) {
    const Complex s = preimage(curve, nearest_node(curve, target), target);
    return 150.0 * std::exp(-static_cast<double>(curve.size()) * std::abs(s.imag()));
  };
  const double worst =
      std::max(error(a.nodes, gap.points.point_b), error(b.nodes, gap.points.point_a));
  if (worst <= scene.solver.tolerance) return {};
  return component_name(scene, gap.a) + " and " + component_name(scene, gap.b) + " are " +
         short_number(gap.points.gap) +
         " apart, too close for the plain trapezoid rule: estimated error " + short_number(worst) +
         ", solver.tolerance = " + short_number(scene.solver.tolerance) +
         "; set solver.near_singular = \"auto\"";
}

std::string gap_message(const Scene& scene, const Gap& gap, const GapResolution& resolution) {
  const double tolerance = scene.solver.tolerance;
  const auto advice = [&](std::size_t component, double decay) {
    return component_name(scene, component) +
           " n_nodes = " + std::to_string(recommended_nodes(decay, tolerance));
  };
  return component_name(scene, gap.a) + " and " + component_name(scene, gap.b) + " are " +
         short_number(gap.points.gap) + " apart, too close for their nodes: estimated error " +
         short_number(resolution.error) +
         " of the velocities, solver.tolerance = " + short_number(tolerance) + "; give " +
         advice(gap.a, resolution.decay.a) + " and " + advice(gap.b, resolution.decay.b) +
         " at least";
}

}  // namespace

std::string density_refusal(const Scene& scene, std::size_t component, Eigen::Index n_nodes,
                            const TailEstimate& tail, const std::vector<Gap>& gaps) {
  const double tolerance = scene.solver.tolerance;
  // At the measured rate of decay; a spectrum that hardly falls asks for half as many nodes again.
  const auto nodes = static_cast<double>(n_nodes);
  const double missing = std::log(tail.error / tolerance) /
                         std::max(tail.decay, 2.0 * std::log(tail.error / tolerance) / nodes);
  const int advice = 16 * static_cast<int>(std::ceil((nodes + missing) / 16.0));
  const auto nearest = std::find_if(gaps.begin(), gaps.end(), [&](const Gap& gap) {
    return gap.a == component || gap.b == component;
  });
  std::string neighbour;
  if (nearest != gaps.end()) {
    const std::size_t other = nearest->a == component ? nearest->b : nearest->a;
    neighbour = " (nearest: " + component_name(scene, other) + ", " +
                short_number(nearest->points.gap) + " apart)";
  }
  return "the density on " + component_name(scene, component) + " is not resolved" + neighbour +
         ": estimated error " + short_number(tail.error) + " of the velocities with its " +
         std::to_string(n_nodes) + " nodes, solver.tolerance = " + short_number(tolerance) +
         "; give it n_nodes = " + std::to_string(advice) + " or so";
}

int nodes_for_shape(const Reference& reference, double tolerance, int at_least) {
  for (int n = 16 * ((at_least + 15) / 16); n <= 4096; n += std::max(16, n / 4 / 16 * 16)) {
    if (rigid_motion_residual(sample(reference.shape, n, reference.curve.side)) <= tolerance) {
      return n;
    }
  }
  return 0;
}

std::string geometry_refusal(const Scene& scene, const std::vector<Gap>& gaps,
                             const Configuration& configuration, const References& references) {
  if (!gaps.empty() && overlaps(gaps.front(), configuration)) {
    return overlap_message(scene, gaps.front());
  }
  const double tolerance = scene.solver.tolerance;
  for (std::size_t k = 0; k < references.size(); ++k) {
    if (references[k]->rigid_motion_residual > tolerance) {
      return shape_message(scene, k, *references[k]);
    }
  }
  for (const Gap& gap : gaps) {
    const GapResolution resolution = gap_resolution(gap, configuration, references);
    if (resolution.error > tolerance) return gap_message(scene, gap, resolution);
    if (scene.solver.near_singular == NearSingular::off) {
      const std::string message =
          plain_rule_message(scene, gap, smooth_curve(*references[gap.a], configuration[gap.a]),
                             smooth_curve(*references[gap.b], configuration[gap.b]));
      if (!message.empty()) return message;
    }
  }
  return {};
}

}  // namespace stokesbook
