#pragma once

#include <numbers>
#include <vector>

#include "support/recorded_run.hpp"
#include "suspension/trajectories.hpp"

/// Makes bodies and scenes for the tests of contact, with automatic nodes.
namespace stokesbook::test {

inline Body turned(const Shape& shape, Complex position, double orientation) {
  Body body = body_at(shape, position, automatic_nodes);
  body.orientation = orientation;
  return body;
}

inline Body held(const Shape& shape, Complex position, double orientation = 0.0) {
  Body body = turned(shape, position, orientation);
  body.held = true;
  return body;
}

inline Body pushed(const Shape& shape, Complex position, Complex force, double orientation = 0.0) {
  Body body = turned(shape, position, orientation);
  body.force = force;
  return body;
}

/// Returns loaded and held bodies in an unbounded fluid, with the tolerance that tests of contact
/// require.
inline Scene loaded(const std::vector<Body>& bodies, double separation) {
  Scene scene = in_contact(QuiescentFlow{}, bodies, separation);
  scene.gauge_length = 100.0;
  scene.solver.tolerance = 1e-3;
  return scene;
}

/// Returns the same scene with another tolerance of the solver.
inline Scene solved_to(Scene scene, double tolerance) {
  scene.solver.tolerance = tolerance;
  return scene;
}

/// Returns unit disks at the separation that opposite forces press together: contact forces cancel
/// these loads, and all is at rest.
inline Scene pressed_disks() {
  return solved_to(loaded({pushed(Circle{1.0}, -1.05, 1.0), pushed(Circle{1.0}, 1.05, -1.0)}, 0.1),
                   1e-6);
}

/// Returns unit disks that a flow of rate 30 drives together: without contact they would overlap at
/// the end of a step, or would have passed each other.
inline Scene head_on(double offset) {
  return in_contact(ExtensionalFlow{-30.0},
                    {body_at(Circle{1.0}, {-1.4, offset}, automatic_nodes),
                     body_at(Circle{1.0}, {1.4, -offset}, automatic_nodes)},
                    0.1);
}

/// Returns unit disks that begin at six tenths of the separation, are pulled apart, and are pressed
/// together from the time `pressed_from` on.
inline Scene opened_and_pressed(double pressed_from, double t_final) {
  Scene scene = in_contact(ExtensionalFlow{1.0},
                           {body_at(Circle{1.0}, {-1.03, 0.0}, automatic_nodes),
                            body_at(Circle{1.0}, {1.03, 0.0}, automatic_nodes)},
                           0.1);
  scene.contact->allow_close = true;
  scene.reverse_at = {pressed_from};
  return over(scene, t_final, 0.05);
}

inline Wall container(double radius) {
  return {.role = WallRole::outer, .shape = Circle{radius}};
}

/// Returns loaded bodies in a circular container at rest, with the tolerance that tests of contact
/// require.
inline Scene in_container(double radius, const std::vector<Body>& bodies, double separation) {
  Scene scene = in_contact(QuiescentFlow{}, bodies, separation);
  scene.walls = {container(radius)};
  scene.solver.tolerance = 1e-3;
  return scene;
}

}  // namespace stokesbook::test
