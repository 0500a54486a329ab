#pragma once

#include "suspension/scenes.hpp"

namespace stokesbook::test {

/// Returns four bodies of different shapes and node counts, at random places near the points of a
/// lattice.
///
/// @param  length  unit of length of the whole scene
inline Scene mixed_bodies(std::uint64_t seed, double length = 1.0,
                          const BackgroundFlow& flow = {}) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto place = [&](double x, double y) {
    return length * Complex{x + 0.3 * uniform(random), y + 0.3 * uniform(random)};
  };
  const auto angle = [&] { return 3.0 * uniform(random); };
  Scene result =
      scene({body(Ellipse{length, 0.5 * length}, 128, place(-2, -2), angle()),
             body(Star{0.9 * length, 0.15, 4}, 192, place(2, -2), angle()),
             body(Superellipse{0.9 * length, 0.7 * length, 4}, 192, place(2, 2), angle()),
             body(lopsided_curve(0.7 * length), 160, place(-2, 2), angle())},
            flow);
  // The loads are generic, with zero net force.
  Complex rest{};
  for (Body& b : result.bodies) {
    b.force = {uniform(random), uniform(random)};
    b.torque = length * uniform(random);
    rest += b.force;
  }
  for (Body& b : result.bodies) b.force -= 0.25 * rest;
  return result;
}

/// Returns the same bodies in a container whose boundary is not a circle.
inline Scene contained_bodies(std::uint64_t seed, double length = 1.0) {
  Scene result = mixed_bodies(seed, length);
  result.walls = {outer_wall(Ellipse{6.5 * length, 5.5 * length}, 256)};
  return result;
}

}  // namespace stokesbook::test
