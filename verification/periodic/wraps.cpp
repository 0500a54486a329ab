// Measures the orders of Heun's method and of the classical Runge-Kutta method for two disks in a
// moving lattice, where disks leave the cell and the basis of the lattice changes.
#include <numbers>

#include "experiments.hpp"
#include "support/cells.hpp"
#include "support/once.hpp"
#include "time_stepping/runge_kutta.hpp"

namespace stokesbook::verification::periodic {

using namespace study;
using Eigen::VectorXd;
using test::Cell;

namespace {

// Whose velocities move the disks: those on the paths, which do not jump, or those of the images
// in the cell (a planted defect).
enum class Velocities { of_paths, of_images };

// Returns the rates of two disks in the shear u = (y, 0), whose state is x, y and angle of each.
VectorXd rates(double t, const VectorXd& state, Velocities velocities) {
  const Lattice lattice(2.0, {2.0 * t, 2.0});
  Cell cell{lattice, {}};
  set_shear(cell);
  for (const int k : {0, 1}) {
    const Complex path{state[3 * k], state[3 * k + 1]};
    cell.bodies.push_back(test::cell_body(Circle{k == 0 ? 0.45 : 0.3}, lattice.wrap(path, 0.0),
                                          state[3 * k + 2], 32));
  }
  const test::CellSolution solution = solve(cell, {36, 100000});
  VectorXd result(6);
  for (const int k : {0, 1}) {
    const auto i = static_cast<std::size_t>(k);
    Complex velocity = solution.bodies[i].velocity;
    if (velocities == Velocities::of_paths) {
      const Complex path{state[3 * k], state[3 * k + 1]};
      velocity += cell.linear_velocity(path - cell.bodies[i].centre);
    }
    result.segment(3 * k, 3) << velocity.real(), velocity.imag(), solution.bodies[i].omega;
  }
  return result;
}

// Follows the disks for two units of time, through a whole period of the lattice.
VectorXd follow(const Tableau& tableau, int steps, Velocities velocities) {
  VectorXd state{{-0.4, 0.535, 0.0, 0.45, 0.985, 0.0}};
  const Rate rate = [&](double t, const VectorXd& q) { return rates(t, q, velocities); };
  const double dt = 2.0 / steps;
  for (int n = 0; n < steps; ++n) {
    const double t = n * dt;
    state += dt * runge_kutta_stages(tableau, rate, {t, state, rate(t, state)}, dt) * tableau.b;
  }
  return state;
}

using Scheme = const Tableau& (*)();

Measure over_steps(Scheme scheme, int fewest, Velocities velocities) {
  return [=](Size size) {
    static test::Once<int, VectorXd> once;
    const VectorXd& exact =
        once(0, [] { return follow(runge_kutta4(), 96, Velocities::of_paths); });
    std::vector<Measurement> measurements;
    for (int steps = fewest; steps <= (size == Size::full ? 8 : 4) * fewest; steps *= 2) {
      const VectorXd found = follow(scheme(), steps, velocities);
      measurements.push_back(
          {.x = static_cast<double>(steps), .error = (found - exact).cwiseAbs().maxCoeff()});
    }
    return measurements;
  };
}

Line order_line(const std::string& key, const std::string& id, const std::string& label,
                Scheme scheme, int fewest, double order) {
  return {.key = key,
          .label = label,
          .measure = over_steps(scheme, fewest, Velocities::of_paths),
          .claim = Claim{.id = id,
                         .statement = "The order of " + label +
                                      " is that of chapter 09, also where "
                                      "disks leave the cell and the lattice is reduced anew.",
                         .law = Algebraic{order, 0.2},
                         .reason = "an image moves with the velocity of the mean flow beside the "
                                   "body, so that paths do not jump",
                         .api = {"stokesbook::Lattice::wrap", "stokesbook::path_motions"}},
          .control = Control{"disks move with the velocities of their images",
                             over_steps(scheme, fewest, Velocities::of_images)}};
}

}  // namespace

Experiment wraps() {
  return {.key = "wraps",
          .title = "Two disks in a lattice that moves through a period",
          .x = "steps n",
          .error = "largest error of places and angles",
          .lines = {order_line("heun", "14_20", "Heun's method", heun, 16, 2.0),
                    order_line("rk4", "14_21", "the classical Runge-Kutta method", runge_kutta4, 8,
                               4.0)}};
}

}  // namespace stokesbook::verification::periodic
