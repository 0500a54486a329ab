// Computes the speed at which four disks driven by torques circle round each other, and compares
// with the law of point rotlets (page Scenes, section "Rotors").
#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

enum class Rotors {
  four,
  three  ///< a planted defect: the disk across from the first is left out
};

/// Solves for four disks at a distance from their common centre. The torque on each disk is 1, and
/// the viscosity is 1.
///
/// @return  speed at which the disks circle
double circling_speed(double radius, double distance, Rotors rotors) {
  Scene scene;
  for (const Complex direction : {Complex{1, 0}, {0, 1}, {0, -1}, {-1, 0}}) {
    if (rotors == Rotors::three && scene.bodies.size() == 3) break;
    scene.bodies.push_back(
        {.shape = Circle{radius}, .position = distance * direction, .torque = 1.0});
  }
  scene.solver.tolerance = 1e-9;
  const SuspensionSolver solver(scene);
  return solver.solve(solver.start()).motions[0].velocity.imag();
}

/// Returns the speed of point rotlets. Each of the three other rotlets causes a velocity
/// 1 / (4 pi r) around it. The two neighbours are at r = sqrt(2) R, and the share 1/sqrt(2) of
/// their velocity is along the circle; the opposite rotlet is at r = 2 R.
double rotlet_speed(double distance) {
  return 1.5 / (4.0 * std::numbers::pi * distance);
}

Measure rotlet_errors(Rotors rotors) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double distance = 4.0; distance <= (size == Size::full ? 128.0 : 64.0); distance *= 2.0) {
      const double found = circling_speed(0.5, 0.5 * distance, rotors);
      measurements.push_back(
          {.x = distance, .error = std::abs(found / rotlet_speed(0.5 * distance) - 1.0)});
    }
    return measurements;
  };
}

}  // namespace

Experiment rotors() {
  return {
      .key = "rotors",
      .title = "Four rotors at the corners of a square",
      .x = "distance from the middle, in radii, d",
      .error = "relative difference of the speed from that of point rotlets",
      .lines = {
          {.key = "rotlets",
           .label = "four disks",
           .measure = rotlet_errors(Rotors::four),
           .claim =
               Claim{
                   .id = "12_34",
                   .statement = "Rotors carry each other round as point rotlets "
                                "do, but for an error of order 2 in size over "
                                "distance.",
                   .law = Algebraic{2.0, 0.1},
                   .window = {.from = 8.0},
                   .reason =
                       "a rotlet's flow is harmonic, so that no Faxen term adds to it; its strain, "
                       "d^-2, causes stresslets in the others, whose flow falls like d^-1",
                   .api = {"stokesbook::SuspensionSolver"}},
           .control = Control{"the rotor across left out", rotlet_errors(Rotors::three)}}}};
}

}  // namespace stokesbook::verification::suspension
