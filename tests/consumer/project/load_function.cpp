// Drags a disk of radius 1 along a circle by an optical trap, whose centre c(t) = R e^{i w t} no
// key of a scene describes. The trap is a load function. The disk follows on a circle,
// z(t) = R e^{i w t} / (1 + i w / r), where r is the disk's mobility times the trap's stiffness.

#include <cmath>
#include <iostream>
#include <numbers>

#include "suspension/motion/simulation.hpp"

int main() {
  using namespace stokesbook;
  const double gauge = 100.0, stiffness = 5.0, radius = 3.0, turns_per_time = 0.1;
  const auto centre = [=](double t) {
    return std::polar(radius, 2.0 * std::numbers::pi * turns_per_time * t);
  };
  const double rate = stiffness * (std::log(gauge) + 0.5) / (4.0 * std::numbers::pi);
  const auto exact = [=](double t) {
    return centre(t) / Complex{1.0, 2.0 * std::numbers::pi * turns_per_time / rate};
  };

  Scene scene;
  scene.gauge_length = gauge;
  scene.bodies = {{.shape = Circle{1.0}, .position = exact(0.0)}};
  scene.time = TimeSettings{.t_final = 4.0};
  scene.output.dt_write = 1.0;

  // A load function returns the load on each body at a time, in a configuration.
  const LoadFunction trap = [=](double t, const Configuration& configuration, const auto&) {
    return std::vector<Load>{{stiffness * (centre(t) - configuration[0].position)}};
  };

  double error = 0.0;
  Observer observer;
  observer.frame = [&](const Frame& frame) {
    std::cout << frame.t << ' ' << frame.bodies[0].position << '\n';
    error = std::max(error, std::abs(frame.bodies[0].position - exact(frame.t)));
  };
  const SuspensionSolver solver(scene);
  Simulation(solver, observer, trap).run();
  std::cout << "error " << error << '\n';
  return error < 1e-5 ? 0 : 1;
}
