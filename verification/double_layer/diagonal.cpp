// Measures the error of D for the kernel's limit on its own node, with the curvature (02.9), and
// for other values. The exact action of D on the Fourier modes of an ellipse is known in closed
// form.
#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/vectors.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

constexpr Index highest_mode = 4;

/// The density has random Fourier coefficients for |k| <= highest_mode; the coefficient of k is
/// entry k + highest_mode.
const ComplexVector modes = test::random_vector(2 * highest_mode + 1, 1);

/// Returns the node values of the series with these coefficients.
ComplexVector series(const ComplexVector& coefficients, Index n) {
  ComplexVector c = ComplexVector::Zero(n);
  for (Index k = -highest_mode; k <= highest_mode; ++k) {
    c[(k + n) % n] = coefficients[k + highest_mode];
  }
  return fourier_values(c);
}

/// Returns the coefficients of D eta in closed form, for fluid inside:
/// (D eta)_k = -(m^|k| eta_{-k} - c_k conj(eta_k)) / 2
/// with c_k = (1 - m^2) k m^{k-1} for k >= 1, else 0.
ComplexVector exact_modes() {
  const double m = std::exp(-kernel_distance(two_to_one));
  ComplexVector result(modes.size());
  for (Index k = -highest_mode; k <= highest_mode; ++k) {
    const auto order = static_cast<double>(k);
    Complex sum = std::pow(m, std::abs(order)) * modes[highest_mode - k];
    if (k >= 1) {
      sum -= (1.0 - m * m) * order * std::pow(m, order - 1.0) * std::conj(modes[k + highest_mode]);
    }
    result[k + highest_mode] = -0.5 * sum;
  }
  return result;
}

/// Measures the error of D eta if the diagonal is multiplied by a factor.
Measure errors_with(double factor) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index n = 12; n <= (size == Size::full ? 256 : 96); n = n * 5 / 4 / 2 * 2) {
      const Curve curve = sample(two_to_one, n, Side::fluid_inside);
      const ComplexVector density = series(modes, n);
      const Eigen::VectorXd velocity = double_layer_matrix(curve) * interleaved(density);
      const ComplexVector got =
          deinterleaved(velocity) + (factor - 1.0) * diagonal_velocity(curve, density);
      measurements.push_back({.x = static_cast<double>(n),
                              .error = relative_error(got, series(exact_modes(), n)),
                              .unknowns = 2.0 * static_cast<double>(n)});
    }
    return measurements;
  };
}

}  // namespace

Experiment diagonal() {
  return {
      .key = "diagonal",
      .title = "The diagonal of the kernel, ellipse 2:1",
      .x = "nodes N",
      .error = "error of Dη, relative to its largest value",
      .lines = {
          {.key = "limit",
           .label = "the limit, -s κ τ τᵀ / 2π",
           .measure = errors_with(1.0),
           .claim =
               Claim{.id = "02_15",
                     .statement = "With the limit as its diagonal the rule converges on the "
                                  "curve as N m^N, m = (a - b) / (a + b).",
                     .law = Geometric{kernel_distance(two_to_one), 0.03, 1.0},
                     .window = {.from = 16.0, .floor = 1e-14},
                     .reason = "the kernel is analytic, with a double pole at the distance "
                               "ln(1/m); floor: rounding of nodes over their spacing",
                     .api = {"stokesbook::double_layer_matrix", "stokesbook::diagonal_velocity"}},
           .control = Control{"the other sign of the curvature", errors_with(-1.0)}},
          {.key = "zero",
           .label = "zero",
           .measure = errors_with(0.0),
           .claim = Claim{.id = "02_16",
                          .statement = "Without its diagonal the rule converges with order 1.",
                          .law = Algebraic{1.0, 0.02},
                          .window = {.from = 24.0},
                          .reason = "one of N terms is missing, kappa w t (t.eta) / 2 pi",
                          .api = {"stokesbook::diagonal_velocity"}},
           .control = Control{"none: the diagonal is there", errors_with(1.0)}},
          {.key = "sign",
           .label = "the other sign of the curvature",
           .measure = errors_with(-1.0)}}};
}

}  // namespace stokesbook::verification::double_layer
