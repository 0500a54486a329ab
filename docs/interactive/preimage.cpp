// Chapter 02: the error of the double layer at a target with a given preimage.
#include <cmath>
#include <complex>
#include <numbers>

#include "double_layer/stresslet_sum.hpp"
#include "interactive/numbers.hpp"
#include "trapezoid/curve.hpp"

std::vector<interactive::Case> interactive::preimage() {
  using stokesbook::Complex;
  struct Target {
    Complex t;  // the preimage: Im t < 0 outside the ellipse
    double b;
    Eigen::Index n;
  };
  std::vector<Case> cases;
  for (const auto& [t, b, n] : {Target{{0.7, -0.35}, 0.5, 48}, Target{{2.5, -0.12}, 0.3, 128},
                                Target{{-1.1, 0.2}, 0.8, 64}}) {
    // The continued ellipse: the first operand of the sum is not the real part of the point.
    const Complex z = std::cos(t) + stokesbook::imaginary * b * std::sin(t);
    const auto body =
        stokesbook::sample(stokesbook::Ellipse{1.0, b}, n, stokesbook::Side::fluid_outside);
    const stokesbook::ComplexVector velocity = stokesbook::StressletSum({body})(
        stokesbook::ComplexVector::Constant(1, z), stokesbook::ComplexVector::Ones(n));
    const double d = std::abs(t.imag()), nodes = static_cast<double>(n);
    cases.push_back({.settings = {{"x", z.real()}, {"y", z.imag()}, {"b", b}, {"N", nodes}},
                     .numbers = {{"d", d},
                                 {"spacings", d * nodes / (2 * std::numbers::pi)},
                                 {"predicted", nodes * std::exp(-d * nodes)},
                                 {"error", std::abs(velocity[0] - (t.imag() > 0 ? 1.0 : 0.0))}}});
  }
  return cases;
}
