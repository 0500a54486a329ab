// Two disks of radius a in a quiescent fluid are pulled apart by the forces F and -F. The program
// computes their velocities and compares them with the closed form,
// F / (4 pi mu) (alpha - tanh(2 alpha) / 2) for centres at the distance 2 a cosh(alpha).

#include <cmath>
#include <iostream>
#include <numbers>

#include "suspension/solver/solver.hpp"

int main() {
  using namespace stokesbook;
  const double a = 1.0, distance = 2.5, force = 3.0;
  Scene scene;
  scene.viscosity = 0.5;
  for (const double side : {-0.5, 0.5}) {
    Body disk;  // free; the solver chooses the number of its nodes
    disk.shape = Circle{.radius = a};
    disk.position = side * distance;
    disk.force = 2.0 * side * force;
    scene.bodies.push_back(disk);
  }

  const SuspensionSolver solver(scene);
  const Solution solution = solver.solve(solver.start());
  for (const RigidMotion& motion : solution.motions) {
    std::cout << "velocity " << motion.velocity << ", angular velocity " << motion.omega << '\n';
  }

  const double alpha = std::acosh(0.5 * distance / a);
  const double speed =
      force / (4.0 * std::numbers::pi * scene.viscosity) * (alpha - 0.5 * std::tanh(2.0 * alpha));
  const double error = std::abs(solution.motions[1].velocity - speed);
  std::cout << "error " << error << ", estimated " << solution.error_estimate << '\n';
  return error < scene.solver.tolerance ? 0 : 1;
}
