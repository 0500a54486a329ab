// Estimates how fast densities decay on the curves of a gap, from the limit points of reflections
// between their circles of curvature (chapter 03, section "Two circles that nearly touch"), and the
// error of velocities that follows. Estimates this error also from the tail of a computed density
// (chapter 12, section "How fine").
#include "suspension/nodes/density_decay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trapezoid/fourier.hpp"

namespace stokesbook {

namespace {

// Factor of alpha e^{-alpha n} in the error: the largest one that was measured on pairs of circles,
// ellipses and stars.
constexpr double error_factor = 150.0;

// Recommended nodes meet the tolerance divided by this margin, because the densities of loaded
// bodies can be larger than velocities. The error estimate of the solution decides in the end.
constexpr double margin = 10.0;

// Curvature -s (x' x x'') / |x'|^3, positive on convex parts of bodies.
double signed_curvature(const SmoothCurve& curve, double t) {
  const TrigonometricPolynomial::Jet jet = curve.at(t);
  return -curve.nodes.sign() * cross(jet.first, jet.second) / std::pow(std::abs(jet.first), 3);
}

// alpha = asinh(c kappa) / (kappa |x'|), which tends to c / |x'| on a straight piece.
double decay_at(const SmoothCurve& curve, double t, double c) {
  const double kappa = signed_curvature(curve, t);
  const double depth = std::abs(c * kappa) < 1e-8 ? c : std::asinh(c * kappa) / kappa;
  return depth / std::abs(curve.at(t).first);
}

}  // namespace

DensityDecay density_decay(const SmoothCurve& a, const SmoothCurve& b,
                           const ClosestPoints& points) {
  const double g = points.gap;
  const double k1 = signed_curvature(a, points.parameter_a);
  const double k2 = signed_curvature(b, points.parameter_b);
  const double sum = k1 + k2 + g * k1 * k2;
  // c^2 of the circles of curvature at the closest points.
  const double c2 = g * (2.0 + g * k1) * (2.0 + g * k2) * (k1 + k2 + sum) / (4.0 * sum * sum);
  if (!(c2 > 0.0) || !std::isfinite(c2)) {
    // There are no limit points where reflections accumulate: the gap requires no nodes.
    const double none = std::numeric_limits<double>::infinity();
    return {none, none};
  }
  const double c = std::sqrt(c2);
  return {decay_at(a, points.parameter_a, c), decay_at(b, points.parameter_b, c)};
}

double resolution_error(double decay, Eigen::Index n_nodes) {
  if (std::isinf(decay)) return 0.0;
  return error_factor * decay * std::exp(-decay * static_cast<double>(n_nodes));
}

GapResolution gap_resolution(const Gap& gap, const Configuration& configuration,
                             const Discretisation& discretisation) {
  const DiscretisedShape& a = *discretisation[gap.a];
  const DiscretisedShape& b = *discretisation[gap.b];
  const DensityDecay decay = density_decay(smooth_curve(a, configuration[gap.a]),
                                           smooth_curve(b, configuration[gap.b]), gap.points);
  const auto error = [](const DiscretisedShape& discretised, double parameter, double depth) {
    if (std::isinf(depth)) return 0.0;
    const Resolution& nodes = discretised.resolution;
    return resolution_error(graded_depth(nodes.grading, parameter, depth), nodes.n_nodes);
  };
  return {decay, std::max(error(a, gap.points.parameter_a, decay.a),
                          error(b, gap.points.parameter_b, decay.b))};
}

int recommended_nodes(double decay, double tolerance) {
  if (std::isinf(decay)) return 0;
  // Solves 150 alpha e^{-alpha n} = tolerance / margin for n.
  const double needed = std::log(margin * error_factor * decay / tolerance) / decay;
  // For gaps of the size of rounding errors the formula gives huge numbers, or negative ones, since
  // it underestimates the error of few nodes. The result is limited to at least 0 and at most 1e9.
  return 16 * static_cast<int>(std::ceil(std::clamp(needed, 0.0, 1e9) / 16.0));
}

TailEstimate tail_estimate(const ComplexVector& density, double scale) {
  const double largest = density.cwiseAbs().maxCoeff();
  if (largest == 0.0) return {0.0, std::numeric_limits<double>::infinity()};
  const Eigen::Index n = density.size();
  const ComplexVector c = fourier_coefficients(density);
  const Eigen::Index window = std::max<Eigen::Index>(3, n / 16);
  const auto largest_mode = [&](Eigen::Index from) {
    double most = 0.0;
    for (Eigen::Index k = from; k < from + window; ++k) {
      most = std::max({most, std::abs(c[k]), std::abs(c[n - k])});
    }
    return most;
  };
  // The largest modes near k = 3n/16, near k = 3n/8, and at the end of the spectrum, k = n/2.
  const double early = largest_mode(std::max<Eigen::Index>(1, 3 * n / 16 - window / 2));
  const double late = largest_mode(3 * n / 8 - window / 2);
  const double last = largest_mode(n / 2 - window);
  const double decay = std::max(0.0, std::log(early / late) / (0.1875 * static_cast<double>(n)));
  // A spectrum that does not decay is treated like one that decays over its whole length, at the
  // rate 2/n.
  const double rate = std::max(decay, 2.0 / static_cast<double>(n));
  // Sum of the modes k > n/2, as a geometric series that continues the modes near 3n/8.
  const double beyond =
      late * std::exp(-0.125 * rate * static_cast<double>(n)) / -std::expm1(-rate);
  const double sum = std::max(beyond, 3.0 * last);
  // min(60 sum^2 / largest, 10 sum), relative to the scale.
  return {sum / scale * std::min(60.0 * sum / largest, 10.0), decay};
}

}  // namespace stokesbook
