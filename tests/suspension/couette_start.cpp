// Tests the first instant of the published Couette run with 80 ellipses: the torque on the inner
// wall, relative to the torque without bodies, is 1.10814. The positions are read off a figure,
// which limits the tolerance.

#include <filesystem>

#include "scene/parse.hpp"
#include "suspension/scenes.hpp"
#include "suspension/solver/rheology.hpp"

namespace stokesbook::test {

BOOST_AUTO_TEST_CASE(couette_torque_ratio) {
  const Solved cell(read_scene(std::filesystem::path(STOKESBOOK_SCENES) / "couette.toml").scene);
  BOOST_REQUIRE_EQUAL(cell.solver.scene().bodies.size(), 80U);
  // Walls follow the bodies: the outer one first, of radius 10, then the inner one, of radius 5.
  const double empty = 4.0 * std::numbers::pi * (0.0 - 1.0) * 25.0 * 100.0 / (100.0 - 25.0);
  BOOST_TEST(std::abs(cell.load(81).torque / empty - 1.10814) < 2e-4);
  const Rheology rheology = Rheometer(cell.solver)(cell.solution);
  BOOST_TEST(std::abs(rheology.torque_ratio - cell.load(81).torque / empty) < 1e-12);
}

}  // namespace stokesbook::test
