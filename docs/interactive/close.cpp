// Chapter 06: errors of the trapezoid rule, interpolation and the Cauchy scheme near an ellipse.
#include <cmath>
#include <complex>
#include <numbers>

#include "double_layer/stresslet_sum.hpp"
#include "interactive/numbers.hpp"
#include "near_singular/cauchy.hpp"
#include "near_singular/interpolation.hpp"

namespace {

using stokesbook::Complex;

stokesbook::Curve ellipse_with_nodes(Eigen::Index n) {
  return stokesbook::sample(stokesbook::Ellipse{1.0, 0.5}, n, stokesbook::Side::fluid_outside);
}

stokesbook::ComplexVector density_on_ellipse(Eigen::Index n) {
  stokesbook::ComplexVector density(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    const double peak = 0.75 / (1.25 - std::cos(t - 1.0));
    density[j] = {std::cos(t) + peak, std::sin(2.0 * t) + peak};
  }
  return density;
}

Complex velocity_by_cauchy(Complex target, Eigen::Index n) {
  const stokesbook::CauchyCurve curve(ellipse_with_nodes(n));
  return curve.velocity(curve.data(density_on_ellipse(n)), 0,
                        stokesbook::ComplexVector::Constant(1, target))[0];
}

}  // namespace

std::vector<interactive::Case> interactive::close() {
  using namespace stokesbook;
  std::vector<Case> cases;
  struct Settings {
    double x, y;
    int n, sigma, degree;
  };
  for (const auto& [x, y, n, sigma, degree] :
       {Settings{0.4, 0.5, 32, 3, 6}, {1.03, 0.02, 48, 2, 4}, {-0.6, -0.55, 40, 1, 3}}) {
    const Complex target{x, y}, exact = velocity_by_cauchy(target, 256);
    const ComplexVector targets = ComplexVector::Constant(1, target),
                        density = density_on_ellipse(n);
    const Curve curve = ellipse_with_nodes(n);
    const InterpolationCurve scheme(curve, {.degree = degree, .step = 1.0, .upsampling = sigma});
    const Complex interpolated = scheme.velocity(scheme.data(density), 0, targets)[0];
    // The preimage of z = (3 w + 1 / w) / 4 with w = e^{i tau} in the unit of both semi-axes
    const Complex root = std::sqrt(target * target - 0.75);
    const double w = std::max(std::abs(target + root), std::abs(target - root)) / 1.5;
    cases.push_back(
        {.settings = {{"x", x}, {"y", y}, {"N", n}, {"sigma", sigma}, {"degree", degree}},
         .numbers = {{"predicted", std::pow(w, -n)},
                     {"rule", std::abs(StressletSum({curve})(targets, density)[0] - exact)},
                     {"interpolation", std::abs(interpolated - exact)},
                     {"cauchy", std::abs(velocity_by_cauchy(target, n) - exact)}}});
  }
  return cases;
}
