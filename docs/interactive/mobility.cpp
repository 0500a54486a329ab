// Chapter 03: the velocity of an ellipse under a weight, for a gauge length.
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "closure/bordered_system.hpp"
#include "interactive/numbers.hpp"
#include "trapezoid/curve.hpp"

namespace {

using namespace stokesbook;

// Returns the velocity of an ellipse with half axes of the sum 2 under a force of 4 pi.
Complex ellipse_velocity(double ratio, double orientation, Complex direction, double gauge_length) {
  const Curve reference =
      sample(Ellipse{2 / (1 + ratio), 2 * ratio / (1 + ratio)}, 160, Side::fluid_outside);
  const Component body{.kind = ComponentKind::free_body,
                       .curve = place(reference, 0.0, orientation),
                       .centre = 0.0,
                       .force = 4 * std::numbers::pi * direction,
                       .velocity = {}};
  const StokesProblem problem{.components = {body}, .background = {}, .gauge_length = gauge_length};
  const DenseSystem system = assemble(problem, ClosureForm::reduced);
  const Eigen::VectorXd solution = system.matrix.partialPivLu().solve(system.rhs);
  return complete_dense(problem, ClosureForm::reduced, solution).motions[0].velocity;
}

}  // namespace

std::vector<interactive::Case> interactive::mobility() {
  constexpr double degree = std::numbers::pi / 180;
  struct Sinking {
    double angle, ratio, log_gauge;
  };
  std::vector<Case> cases;
  for (const auto& [angle, ratio, log_gauge] :
       {Sinking{30, 0.3, 0.5}, Sinking{-65, 0.45, -0.4}, Sinking{140, 0.8, 1.2}}) {
    const double gauge = std::pow(10.0, log_gauge);
    const Complex sinking = ellipse_velocity(ratio, angle * degree, -imaginary, gauge);
    cases.push_back(
        {.settings = {{"angle", angle}, {"ratio", ratio}, {"logGauge", log_gauge}},
         .numbers = {{"sideways", sinking.real()},
                     {"up", sinking.imag()},
                     {"drift", std::atan2(sinking.real(), -sinking.imag()) / degree},
                     {"along", ellipse_velocity(ratio, 0.0, 1.0, gauge).real()},
                     {"across", ellipse_velocity(ratio, 0.0, imaginary, gauge).imag()}}});
  }
  return cases;
}
