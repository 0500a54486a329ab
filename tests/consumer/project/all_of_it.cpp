// A disk in the shear flow (y, 0) turns with half the flow's vorticity: omega = -1/2.

#include <cmath>
#include <iostream>

#include "suspension/solver.hpp"

int main() {
  using namespace stokesbook;
  Scene scene;
  scene.flow = ShearFlow{.rate = 1.0};
  Body disk;
  disk.shape = Circle{.radius = 1.0};
  disk.n_nodes = 32;
  scene.bodies.push_back(disk);

  const SuspensionSolver solver(scene);
  const Solution solution = solver.solve(solver.initial_configuration());
  const double error = std::abs(solution.motions.at(0).omega + 0.5);
  std::cout << "error " << error << '\n';
  return error < 1e-12 ? 0 : 1;
}
