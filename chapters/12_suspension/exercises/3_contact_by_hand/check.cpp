// Check of exercise 12.3: differences and complementarity; steps of the library's simulation.
#include "chapters/check.hpp"

#include <algorithm>

#include "suspension/motion/simulation.hpp"

using namespace stokesbook;
using Eigen::VectorXd;
using exercise::expect;

VectorXd gap_gradient(Complex a, Complex b);
double contact_force(double gap, double separation, double dt, double free_rate, double response);
VectorXd velocities(const VectorXd& free, const VectorXd& by_unit_force, double force);
double contact_power(double gap, double separation, double dt, double force);

namespace {

// The distance of two points is linear along itself, and stays the same to first order across.
void check_gradient(Complex a, Complex b) {
  const VectorXd state{{a.real(), a.imag(), 0.0, b.real(), b.imag(), 0.0}};
  const auto distance = [](const VectorXd& q) { return std::hypot(q[3] - q[0], q[4] - q[1]); };
  VectorXd exact(6);
  for (Eigen::Index k = 0; k < 6; ++k) {
    // q^2 is a polynomial of degree two, whose central difference is its derivative.
    const VectorXd step = VectorXd::Unit(6, k);
    const double further = distance(state + step), nearer = distance(state - step);
    exact[k] = (further * further - nearer * nearer) / (4.0 * distance(state));
  }
  expect({.what = "centres " + exercise::text(a) + " and " + exercise::text(b),
          .got = gap_gradient(a, b),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {{VectorXd(-exact), "the gap opens as b moves away from a"},
                       {VectorXd(distance(state) * exact), "the normal is a unit vector"}}});
}

void check_force(double gap, double free_rate) {
  constexpr double separation = 0.1, dt = 0.25, response = 0.4;
  const double rest = gap - separation + dt * free_rate;
  const double pull = -rest / (dt * response);
  expect({.what = "gap " + exercise::text(gap) + ", rate " + exercise::text(free_rate) +
                  ", separation 0.1, dt 0.25, response 0.4",
          .got = contact_force(gap, separation, dt, free_rate, response),
          .expected = rest < 0.0 ? pull : 0.0,
          .tolerance = 1e-12,
          .mistakes = {{pull, "forces only push: the gap is wide enough without"},
                       {std::max(0.0, -free_rate / response),
                        "this keeps the gap as it is: a gap may close as far as the separation"},
                       {std::max(0.0, pull * dt), "this forgets the length of the step"}}});
}

void check_velocities(double force) {
  const VectorXd free{{1.0, 0.5, 0.0, -1.0, 0.25, 0.125}};
  const VectorXd unit{{-0.25, 0.0, 0.0, 0.25, 0.0, 0.0}};
  const VectorXd exact{{1.0 - 0.25 * force, 0.5, 0.0, -1.0 + 0.25 * force, 0.25, 0.125}};
  expect({.what = "force " + exercise::text(force),
          .got = velocities(free, unit, force),
          .expected = exact,
          .tolerance = 1e-14,
          .mistakes = {{VectorXd(exact - free),
                        "disks move by the force in addition to what they "
                        "do without"}}});
}

// By the rate at which the gap closes.
void check_power(double gap) {
  constexpr double separation = 0.1, dt = 0.25, force = 3.0;
  const double rate = (separation - gap) / dt;
  expect({.what = "gap " + exercise::text(gap) + ", separation 0.1, dt 0.25, force 3",
          .got = contact_power(gap, separation, dt, force),
          .expected = force * rate,
          .tolerance = 1e-12,
          .mistakes = {{-force * rate, "contact takes energy and gives none"},
                       {force * rate * dt, "this is a work, not a power"}}});
}

constexpr double radius = 0.5, separation = 0.1, dt = 0.1;

Scene pair(double distance) {
  Scene scene;
  scene.flow = ExtensionalFlow{-1.0};
  for (const double side : {-0.5, 0.5}) {
    scene.bodies.push_back({.shape = Circle{radius}, .position = side * distance});
  }
  scene.solver.tolerance = 1e-6;
  return scene;
}

VectorXd solved(const Scene& scene) {
  const SuspensionSolver solver(scene);
  const Solution solution = solver.solve(solver.start());
  const auto& [a, b] = std::pair(solution.motions[0], solution.motions[1]);
  return VectorXd{{a.velocity.real(), a.velocity.imag(), a.omega, b.velocity.real(),
                   b.velocity.imag(), b.omega}};
}

// Unit forces along the gap, away from each other, in a fluid at rest.
VectorXd by_unit_force(Scene scene, const VectorXd& gradient) {
  scene.flow = QuiescentFlow{};
  scene.gauge_length = 30.0;  // nothing depends on it: forces balance
  scene.bodies[0].force = {gradient[0], gradient[1]};
  scene.bodies[1].force = {gradient[3], gradient[4]};
  return solved(scene);
}

std::vector<Frame> simulated(Scene scene, int steps) {
  scene.contact = ContactSettings{separation};
  scene.time = TimeSettings{dt * steps, dt, SteppingMethod::euler};
  std::vector<Frame> frames;
  Observer observer;
  observer.frame = [&](const Frame& frame) { frames.push_back(frame); };
  const SuspensionSolver solver(scene);
  Simulation(solver, observer).run();
  return frames;
}

void check_experiment() {
  constexpr int steps = 5;
  double distance = 2.0 * radius + 0.2;
  const std::vector<Frame> frames = simulated(pair(distance), steps);
  for (std::size_t k = 0; k < steps; ++k) {
    const Scene scene = pair(distance);
    const VectorXd gradient = gap_gradient(scene.bodies[0].position, scene.bodies[1].position);
    const VectorXd free = solved(scene), unit = by_unit_force(scene, gradient);
    const double force = contact_force(distance - 2.0 * radius, separation, dt, gradient.dot(free),
                                       gradient.dot(unit));
    const std::string what = ", step " + std::to_string(k + 1);
    const std::vector<ContactForce>& contacts = frames[k].contacts;
    expect({.what = "force" + what,
            .got = force,
            .expected = contacts.empty() ? 0.0 : contacts[0].force,
            .tolerance = 1e-4});
    const VectorXd moved = dt * velocities(free, unit, force);
    distance += moved[3] - moved[0];
    const std::vector<BodyState>& bodies = frames[k + 1].bodies;
    expect({.what = "distance of the centres" + what,
            .got = distance,
            .expected = std::abs(bodies[1].position - bodies[0].position),
            .tolerance = 1e-5});
  }
}

}  // namespace

int main() {
  return exercise::run({{.title = "the gradient of the gap",
                         .formula = "(-n, 0, n, 0), n = (b - a)/|b - a|",
                         .hint = "the gap is |b - a| minus the radii",
                         .check =
                             [] {
                               check_gradient({0.0, 0.0}, {2.0, 0.0});
                               check_gradient({0.3, -1.0}, {-0.8, 1.5});
                             }},
                        {.title = "the force",
                         .formula = "0 <= gap - separation + dt (rate + response force), "
                                    "0 <= force, one of them 0",
                         .hint = "either no force, or the gap is the separation at the end",
                         .check =
                             [] {
                               check_force(0.1, -1.0);
                               check_force(0.15, -1.0);
                               check_force(0.5, -1.0);
                               check_force(0.1, 0.3);
                             }},
                        {.title = "velocities",
                         .formula = "U* + B J^T lambda",
                         .hint = "everything is linear in forces",
                         .check =
                             [] {
                               for (const double force : {0.0, 2.0}) check_velocities(force);
                             }},
                        {.title = "the power of contact",
                         .formula = "force times the rate of the gap",
                         .hint = "the gap goes from what it is to the separation in the time dt",
                         .check =
                             [] {
                               for (const double gap : {0.1, 0.18}) check_power(gap);
                             }},
                        {.title = "the experiment",
                         .builds_on = {1, 2, 3},
                         .formula = "steps by Euler's method, U = U* + B J^T lambda",
                         .hint = "tasks 1 to 3, with velocities of the solver",
                         .check = check_experiment}});
}
