#pragma once

#include <optional>

#include "units.hpp"

namespace stokesbook::test {

/// Expected results of one component of a scene; parts that are not given are not compared.
struct Expected {
  std::size_t component = 0;
  std::optional<RigidMotion> motion;
  std::optional<Load> load;
  std::optional<Complex> stresslet;
};

/// Returns the largest difference between a solution in some units and the expected results in
/// units of one.
inline double difference(const Solved& solved, const Expected& expected, const Units& units) {
  const std::size_t k = expected.component;
  double most = 0.0;
  if (expected.motion) {
    most = distance(solved.motion(k), in_units(*expected.motion, units), units.length) /
           units.velocity();
  }
  if (expected.load) {
    const double d = distance(solved.load(k), in_units(*expected.load, units), units.length);
    most = std::max(most, d / units.force());
  }
  if (expected.stresslet) {
    const double d = std::abs(solved.stresslet(k) - units.torque() * *expected.stresslet);
    most = std::max(most, d / units.torque());
  }
  return most;
}

/// Solves a scene in several systems of units and compares with the expected results.
inline void check(const Scene& scene, const std::vector<Expected>& expected, double tolerance,
                  const std::vector<Units>& every = two_units) {
  for (const Units& units : every) {
    const Solved solved(in_units(scene, units));
    for (const Expected& e : expected) {
      BOOST_TEST_CONTEXT("component " << e.component << ", length " << units.length
                                      << ", viscosity " << units.viscosity) {
        BOOST_TEST(difference(solved, e, units) < tolerance);
      }
    }
  }
}

}  // namespace stokesbook::test
