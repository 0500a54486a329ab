#include "suspension/nodes/density_decay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trapezoid/fourier.hpp"

namespace stokesbook {

namespace {

// Factor of alpha e^{-alpha n}: the largest measured on pairs of circles, ellipses and stars.
constexpr double error_factor = 150.0;

// What recommendations ask beyond that: densities of loaded bodies can be larger than velocities,
// and the estimate of a computed solution has the last word.
constexpr double margin = 10.0;

double signed_curvature(const SmoothCurve& curve, double t) {
  const TrigonometricPolynomial::Jet jet = curve.at(t);
  return -curve.nodes.sign() * cross(jet.first, jet.second) / std::pow(std::abs(jet.first), 3);
}

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
  const double c2 = g * (2.0 + g * k1) * (2.0 + g * k2) * (k1 + k2 + sum) / (4.0 * sum * sum);
  if (!(c2 > 0.0) || !std::isfinite(c2)) {
    // Curves that bend away from each other's reflections: nothing piles up.
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
  const double needed = std::log(margin * error_factor * decay / tolerance) / decay;
  // Gaps of rounding would ask for anything, and the error of their few nodes is underestimated: no
  // more than an int holds, and none at least.
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
  const double early = largest_mode(std::max<Eigen::Index>(1, 3 * n / 16 - window / 2));
  const double late = largest_mode(3 * n / 8 - window / 2);
  const double last = largest_mode(n / 2 - window);
  const double decay = std::max(0.0, std::log(early / late) / (0.1875 * static_cast<double>(n)));
  // A spectrum that does not fall counts as one that falls over its whole length.
  const double rate = std::max(decay, 2.0 / static_cast<double>(n));
  const double beyond =
      late * std::exp(-0.125 * rate * static_cast<double>(n)) / -std::expm1(-rate);
  const double sum = std::max(beyond, 3.0 * last);
  return {sum / scale * std::min(60.0 * sum / largest, 10.0), decay};
}

}  // namespace stokesbook
