// Chapter 02: the flow of a force, a torque or a stresslet at a point, and its flux.
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "double_layer/kernels.hpp"
#include "interactive/numbers.hpp"
#include "trapezoid/curve.hpp"

std::vector<interactive::Case> interactive::push() {
  using stokesbook::Complex;
  struct Push {
    int kind;  // the button
    Complex vector;
    double angle, gauge;
    Complex target;
  };
  std::vector<Case> cases;
  for (const auto& [kind, vector, angle, gauge, target] :
       {Push{0, {1.0, 0.4}, 0, 10, {-1.05, 0.75}}, Push{0, {-0.3, 1.2}, 0, 2.5, {0.4, 0.5}},
        Push{1, {0.2, -0.9}, 0, 10, {0.8, -0.35}}, Push{2, {0.7, 1.1}, 35, 10, {1.3, 0.6}},
        Push{2, {0.7, 1.1}, -145, 10, {-0.5, 0.6}}}) {
    const Complex normal = std::polar(1.0, angle * std::numbers::pi / 180);
    const std::array<std::function<Complex(Complex)>, 3> flows{
        [&](Complex r) { return stokesbook::stokeslet(r, vector, 1.0, gauge); },
        [&](Complex r) { return stokesbook::rotlet(r, vector.imag(), 1.0); },
        [&](Complex r) { return stokesbook::stresslet(r, normal, vector); }};
    const auto& flow = flows[kind];
    const Complex u = flow(target);
    // A force and a torque have no outflow, that of a stresslet is n . eta.
    const double flux = kind == 2 ? stokesbook::dot(normal, vector) : 0.0;
    cases.push_back({.settings = {{"kind", kind},
                                  {"f", vector.real()},
                                  {"g", vector.imag()},
                                  {"angle", angle},
                                  {"gauge", gauge},
                                  {"x", target.real()},
                                  {"y", target.imag()}},
                     .numbers = {{"u", u.real()},
                                 {"v", u.imag()},
                                 {"ratio", std::abs(flow(2.0 * target)) / std::abs(u)},
                                 {"flux", flux}}});
  }
  return cases;
}
