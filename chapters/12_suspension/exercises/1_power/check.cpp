// Check of exercise 12.1: flows between cylinders in closed form; a cell solved by the library.
#include "chapters/check.hpp"

#include <numbers>

#include <Eigen/LU>

#include "suspension/solver/solver.hpp"

using namespace stokesbook;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using exercise::expect;
using std::numbers::pi;

double torque_about_origin(Complex force, double torque, Complex position);
double power(const VectorXcd& forces, const VectorXd& torques, const VectorXcd& velocities,
             const VectorXd& omegas);
double empty_torque(double mu, double omega, double r_inner, double r_outer);
double viscosity_by_power(double power, double mu, double omega, double r_inner, double r_outer);

namespace {

// A lever: the force a at the distance r from the origin, at an angle to it.
void check_torque(double distance, double angle) {
  const Complex position = std::polar(distance, 0.7), force = std::polar(3.0, 0.7 + angle);
  const double lever = 3.0 * distance * std::sin(angle);
  expect({.what = "force 3 at the distance " + exercise::text(distance) + ", " +
                  exercise::text(angle) + " off the radius, and torque 0.4",
          .got = torque_about_origin(force, 0.4, position),
          .expected = 0.4 + lever,
          .tolerance = 1e-13,
          .mistakes = {{0.4, "a force has a torque about other points than its own"},
                       {0.4 - lever, "it is position cross force, in this order"},
                       {lever, "the body's own torque counts too"}}});
}

// Power does not depend on the angle from which one looks.
void check_power(double turn) {
  const Complex all = std::polar(1.0, turn);
  const VectorXcd forces = all * VectorXcd{{Complex{3.0, 0.0}, Complex{0.0, 2.0}}};
  const VectorXcd velocities = all * VectorXcd{{Complex{2.0, 1.0}, Complex{5.0, -1.0}}};
  const VectorXd torques{{0.5, 4.0}}, omegas{{2.0, -0.25}};
  const double by_forces = 3.0 * 2.0 + 2.0 * -1.0;
  const double without_conjugate = std::real(all * all * Complex{6.0 + 2.0, 3.0 + 10.0});
  expect({.what = "two components, turned by " + exercise::text(turn),
          .got = power(forces, torques, velocities, omegas),
          .expected = by_forces,
          .tolerance = 1e-13,
          .mistakes = {{by_forces + 1.0, "signs of torques times angular velocities matter"},
                       {without_conjugate,
                        "the scalar product of the plane: real part of the "
                        "conjugate of one, times the other"}}});
  const VectorXd both{{2.0, 0.25}};
  expect({.what = "the same, with torques that work",
          .got = power(forces, torques, velocities, both),
          .expected = by_forces + 2.0,
          .tolerance = 1e-13,
          .mistakes = {{by_forces, "torques turn things: they work as well"},
                       {without_conjugate + 2.0,
                        "the scalar product of the plane: real part of "
                        "the conjugate of one, times the other"}}});
}

// u = A r + B / r, from its values at both cylinders.
void check_empty_torque(double omega, double r_inner, double r_outer) {
  constexpr double mu = 1.3;
  Eigen::Matrix2d values;
  values << r_inner, 1.0 / r_inner, r_outer, 1.0 / r_outer;
  const Eigen::Vector2d flow = values.inverse() * Eigen::Vector2d{0.0, omega * r_outer};
  const double torque = 4.0 * pi * mu * flow[1];
  expect({.what = "radii " + exercise::text(r_inner) + " and " + exercise::text(r_outer),
          .got = empty_torque(mu, omega, r_inner, r_outer),
          .expected = torque,
          .tolerance = 1e-12,
          .mistakes = {{-torque, "the inner cylinder holds the fluid back"},
                       {0.5 * torque, "the torque is 4 pi mu B"},
                       {torque / mu, "a torque is in proportion to the viscosity"}}});
}

// Fluid of twice the viscosity takes twice the power.
void check_viscosity(double ratio) {
  constexpr double mu = 1.3, omega = 0.7, a = 1.0, b = 3.0;
  const double empty = 4.0 * pi * mu * omega * omega * a * a * b * b / (b * b - a * a);
  expect({.what = "a fluid of " + exercise::text(ratio) + " times the viscosity",
          .got = viscosity_by_power(ratio * empty, mu, omega, a, b),
          .expected = ratio,
          .tolerance = 1e-12,
          .mistakes = {{ratio * omega,
                        "this divides by a torque: without bodies there is a power, "
                        "not a torque"},
                       {-ratio, "power is put in: it is positive"}}});
}

constexpr double mu = 1.3, omega = 0.8, r_inner = 1.0, r_outer = 3.0, accuracy = 1e-5;

// Four free ellipses between cylinders, the outer one turning; one of them may be pulled.
Scene cell(Complex pull) {
  Scene scene;
  scene.viscosity = mu;
  scene.walls = {{.role = WallRole::outer, .shape = Circle{r_outer}, .motion = RotatingWall{omega}},
                 {.role = WallRole::inner, .shape = Circle{r_inner}}};
  for (int k = 0; k < 4; ++k) {
    scene.bodies.push_back({.shape = Ellipse{0.5, 0.25},
                            .position = std::polar(2.0, 0.5 * pi * k + 0.1 * k * k),
                            .orientation = 0.6 * k});
  }
  scene.bodies[0].force = pull;
  scene.solver.tolerance = accuracy;
  return scene;
}

struct Balance {
  VectorXcd forces, velocities, positions;
  VectorXd torques, omegas;
};

Balance solved(const Scene& scene) {
  const SuspensionSolver solver(scene);
  const Solution solution = solver.solve(solver.start());
  const Configuration& start = solution.instant.configuration;
  const auto n = static_cast<Eigen::Index>(start.size());
  Balance all{VectorXcd(n), VectorXcd(n), VectorXcd(n), VectorXd(n), VectorXd(n)};
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    all.forces[k] = solution.loads[i].force;
    all.torques[k] = solution.loads[i].torque;
    all.velocities[k] = solution.motions[i].velocity;
    all.omegas[k] = solution.motions[i].omega;
    all.positions[k] = start[i].position;
  }
  return all;
}

void check_experiment() {
  for (const Complex pull : {Complex{}, Complex{2.0, 5.0}}) {
    const Balance all = solved(cell(pull));
    double torque = 0.0;
    for (Eigen::Index k = 0; k < all.forces.size(); ++k) {
      torque += torque_about_origin(all.forces[k], all.torques[k], all.positions[k]);
    }
    expect({.what = "all torques about the axis, pull " + exercise::text(pull),
            .got = torque,
            .expected = 0.0,
            .tolerance = 100.0 * accuracy});
  }
  const Balance free = solved(cell({}));
  const double put_in = power(free.forces, free.torques, free.velocities, free.omegas);
  const double by_torque = free.torques[5] / empty_torque(mu, omega, r_inner, r_outer);
  expect({.what = "viscosity of the cell, by power and by torque",
          .got = viscosity_by_power(put_in, mu, omega, r_inner, r_outer),
          .expected = by_torque,
          .tolerance = 10.0 * accuracy});
}

}  // namespace

int main() {
  return exercise::run({{.title = "torque about the origin",
                         .formula = "L + x F_y - y F_x",
                         .hint = "a lever: the part of the force across the radius counts",
                         .check =
                             [] {
                               for (const double angle : {0.3, 1.2, -2.0}) check_torque(2.5, angle);
                             }},
                        {.title = "power",
                         .formula = "sum of F.U + L omega",
                         .hint = "F.U is the real part of conj(F) U",
                         .check =
                             [] {
                               for (const double turn : {0.0, 0.4}) check_power(turn);
                             }},
                        {.title = "the torque of an empty cell",
                         .formula = "4 pi mu B, u = A r + B/r",
                         .hint = "u = 0 at the inner cylinder, omega r at the outer one",
                         .check =
                             [] {
                               check_empty_torque(0.8, 1.0, 3.0);
                               check_empty_torque(2.0, 5.0, 10.0);
                             }},
                        {.title = "viscosity by power",
                         .builds_on = {3},
                         .formula = "P / P_empty",
                         .hint = "the outer cylinder puts in omega times its torque",
                         .check =
                             [] {
                               for (const double ratio : {1.0, 2.0}) check_viscosity(ratio);
                             }},
                        {.title = "the experiment",
                         .builds_on = {1, 2, 3, 4},
                         .formula = "torques add up to 0; P = omega L_outer",
                         .hint = "free bodies put in nothing",
                         .check = check_experiment}});
}
