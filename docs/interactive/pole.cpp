// Chapter 01: the error of the trapezoid rule for a function with a pole at t = i d.
#include <cmath>
#include <numbers>

#include "interactive/numbers.hpp"
#include "trapezoid/curve.hpp"

std::vector<interactive::Case> interactive::pole() {
  std::vector<Case> cases;
  for (const auto& [d, n] : {std::pair{0.5, 16}, {1.2, 8}, {0.13, 50}}) {
    const auto circle =
        stokesbook::sample(stokesbook::Circle{}, n, stokesbook::Side::fluid_outside);
    const Eigen::VectorXd f = (std::cosh(d) - circle.x.real().array()).inverse();
    const double rule = stokesbook::weights(circle).dot(f);
    const double integral = 2 * std::numbers::pi / std::sinh(d);
    cases.push_back({.settings = {{"d", d}, {"N", n}},
                     .numbers = {{"rule", rule},
                                 {"integral", integral},
                                 {"error", std::abs(rule / integral - 1)},
                                 {"predicted", 2 / std::expm1(d * n)},
                                 {"factor", std::exp(-d)}}});
  }
  return cases;
}
