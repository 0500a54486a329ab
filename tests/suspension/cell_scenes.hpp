#pragma once

#include "scenes.hpp"

namespace stokesbook::test {

/// Returns a scene with a periodic cell.
inline Scene cell_scene(std::vector<Body> bodies, Complex a1, Complex a2,
                        const BackgroundFlow& flow = {}, double tolerance = 1e-10) {
  Scene made = scene(std::move(bodies), flow);
  made.cell.emplace();
  made.cell->vectors << a1.real(), a1.imag(), a2.real(), a2.imag();
  made.solver.tolerance = tolerance;
  return made;
}

/// Returns a disk with automatic nodes.
inline Body disk(double radius, Complex position, const Load& load = {}) {
  return body(Circle{radius}, automatic_nodes, position, 0.0, load);
}

/// Compares with an exact value, relative to one plus its modulus.
inline void check(Complex found, Complex exact, double tolerance = 1e-9) {
  BOOST_TEST(std::abs(found - exact) < tolerance * (1.0 + std::abs(exact)));
}

/// Returns three bodies with loads in a general cell and a general linear flow.
inline Scene three_bodies() {
  Scene made =
      cell_scene({body(Ellipse{0.4, 0.2}, automatic_nodes, {-0.45, 0.35}, 0.5, {{1.0, 0.5}, 0.3}),
                  body(Ellipse{0.35, 0.25}, automatic_nodes, {0.5, 0.2}, -0.7, {{-0.3, 0.2}, -0.2}),
                  disk(0.3, {0.1, -0.55}, {{0.4, -1.0}, 0.5})},
                 {2.2, 0.1}, {0.5, 1.9}, LinearFlow{Eigen::Matrix2d{{0.2, 1.0}, {-0.3, -0.2}}});
  made.viscosity = 1.3;
  made.cell->mean_velocity = {0.1, -0.2};
  return made;
}

/// Holds the third of the three bodies.
inline void hold_disk(Scene& scene) {
  Body& disk = scene.bodies[2];
  disk.held = true;
  disk.velocity = {0.2, 0.1};
  disk.omega = 0.7;
}

/// Returns two disks of different size in a square cell and the shear u = (y, 0).
inline Scene two_disks() {
  return cell_scene({disk(0.45, {-0.4, -0.2}), disk(0.3, {0.45, 0.25})}, 2.0, {0.0, 2.0},
                    ShearFlow{1.0});
}

}  // namespace stokesbook::test
