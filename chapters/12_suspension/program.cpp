// Chapter 12: one scene through the whole solver. What it needs; one instant at several tolerances,
// with what their errors are; its way to the floor, step by step, with the
// forces that keep it apart.
//
//   chapter_12    prints tables
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "suspension/motion/describe.hpp"
#include "suspension/motion/simulation.hpp"

using namespace stokesbook;

namespace {

// [scene]
/// A disk, an ellipse and a lobed body, heavy, in a round container.
Scene settling() {
  Scene scene;
  scene.title = "Three bodies settle";
  scene.walls = {{.role = WallRole::outer, .shape = Circle{2.0}}};
  scene.bodies = {{.shape = Circle{0.4}, .position = {-0.7, 0.2}},
                  {.shape = Ellipse{0.6, 0.3}, .position = {0.3, -0.5}, .orientation = 0.4},
                  {.shape = Star{0.4, 0.2, 5}, .position = {0.4, 0.7}}};
  for (Body& body : scene.bodies) body.force = {0.0, -20.0};
  scene.solver.tolerance = 1e-3;
  scene.contact = ContactSettings{.minimum_separation = 0.05};
  scene.time = TimeSettings{.t_final = 12.0, .dt = 0.2, .method = SteppingMethod::heun};
  scene.output.dt_write = 2.0;
  return scene;
}
// [scene]

// [plan]
void print_plan(const SuspensionSolver& solver) {
  for (const std::string& line : describe(solver)) std::printf("  %s\n", line.c_str());
}
// [plan]

// [instant]
Solution solved(Scene scene, double tolerance) {
  scene.solver.tolerance = tolerance;
  const SuspensionSolver solver(scene);
  return solver.solve(solver.start());
}

/// Largest difference of a velocity, over the largest velocity of the data.
double difference(const Solution& solution, const Solution& reference) {
  double largest = 0.0;
  for (std::size_t k = 0; k < solution.motions.size(); ++k) {
    const Complex change = solution.motions[k].velocity - reference.motions[k].velocity;
    largest = std::max(largest, std::abs(change));
  }
  return largest / reference.velocity_scale;
}

void print_tolerances(const Scene& scene) {
  std::puts("\nThe first instant\n");
  std::puts("  tolerance   nodes   iterations   estimate   difference from 1e-11");
  const Solution reference = solved(scene, 1e-11);
  for (const double tolerance : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9}) {
    const Solution solution = solved(scene, tolerance);
    std::printf("%11.0e%8d%13d%11.1e%24.1e\n", tolerance, static_cast<int>(solution.density.size()),
                solution.gmres.iterations, solution.error_estimate,
                difference(solution, reference));
  }
}
// [instant]

// [forces]
/// The weight is carried by contact, and through the fluid.
void print_forces(const Frame& frame) {
  std::puts("\nForces at the end\n");
  const auto name = [](const ContactParty& party) {
    return (party.is_wall ? "wall " : "body ") + std::to_string(party.number);
  };
  Complex support{};
  for (const ContactForce& contact : frame.contacts) {
    const Complex force = contact.force * contact.normal;  // on a
    if (contact.b.is_wall) support += force;
    std::printf("  on %s by %s: (%8.4f, %8.4f), gap %.5f\n", name(contact.a).c_str(),
                name(contact.b).c_str(), force.real(), force.imag(), contact.gap);
  }
  const Complex through_fluid = frame.walls[0].force, together = support + through_fluid;
  std::printf("  by the wall in contact (%.4f, %.4f), through the fluid (%.4f, %.4f)\n",
              support.real(), support.imag(), through_fluid.real(), through_fluid.imag());
  std::printf("  together (%.4f, %.4f)\n", together.real(), together.imag());
}
// [forces]

// [run]
void print_run(const SuspensionSolver& solver) {
  std::puts("\nThe way down\n");
  std::puts("    t     dt   iterations   pairs   problems   least gap   net force   estimate");
  Observer observer;
  int count = 0;
  observer.step = [&](const StepInfo& step) {
    if (++count % 4 != 0) return;
    std::printf("%5.2f%7.2f%13d%8d%11d%12.5f%12.0e%11.0e\n", step.t, step.dt, step.gmres_iterations,
                step.contacts, step.ncp_iterations, step.min_gap, step.force_imbalance,
                step.velocity_error);
  };
  Frame last;
  observer.frame = [&](const Frame& frame) { last = frame; };
  Simulation simulation(solver, observer);
  simulation.run();
  print_forces(last);
}
// [run]

}  // namespace

int main() {
  const Scene scene = settling();
  const SuspensionSolver solver(scene);
  print_plan(solver);
  print_tolerances(scene);
  print_run(solver);
}
