#pragma once

#include <cmath>
#include <numbers>

#include "suspension/contact_setup.hpp"

/// Makes scenes for the tests of forcing.
namespace stokesbook::test {

inline constexpr double gauge = 100.0;

/// Velocity of a unit disk in a fluid of viscosity 1 over the force on it.
inline const double disk_mobility = (std::log(gauge) + 0.5) / (4.0 * std::numbers::pi);

/// Returns a unit disk alone in an unbounded fluid.
inline Scene disk_scene(SteppingMethod method, double t_final, double dt) {
  Scene scene;
  scene.gauge_length = gauge;
  scene.bodies = {body_at(Circle{1.0}, {2.0, 1.0}, 16)};
  scene.solver.tolerance = 1e-10;
  scene.time = TimeSettings{t_final, dt, method};
  if (is_embedded(method)) scene.time->tolerance = 1e-9;
  scene.output.dt_write = t_final;
  return scene;
}

/// Returns two disks with contact, for loads that press them together.
inline Scene pressed_pair(SteppingMethod method) {
  Scene scene = loaded({body_at(Circle{1.0}, {-1.2, 0.0}, automatic_nodes),
                        body_at(Circle{1.0}, {1.2, 0.1}, automatic_nodes)},
                       0.1);
  return over(scene, 4.0, 0.1, method);
}

}  // namespace stokesbook::test
