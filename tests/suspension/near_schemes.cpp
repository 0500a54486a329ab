// Tests that both schemes of close evaluation give the same motions and loads to the requested
// tolerance, with close pairs of two bodies, of a body and a wall, and of two walls.

#include "scenes.hpp"
#include "suspension/motion/describe.hpp"

namespace stokesbook::test {
namespace {

// Returns a cell with every kind of pair, at gaps from 0.05 to 0.1.
Scene crowded_cell(NearSingular scheme, double tolerance) {
  Scene cell = scene({body(Circle{0.4}, 128, {-1.2, 0.3}, 0.0, {{0.3, -0.2}, 0.4}),
                      body(Ellipse{0.6, 0.35}, 160, {-0.15, 0.3}, 0.0, {{0.0, 0.5}, 0.0})},
                     {},
                     {inner_wall(Circle{0.5}, 160, RotatingWall{1.0}, {1.0, 0.35}),
                      inner_wall(Circle{0.3}, 160, FixedWall{}, {0.0, -1.6}),
                      outer_wall(Circle{2.0}, 512, RotatingWall{-0.5})});
  cell.solver.near_singular = scheme;
  cell.solver.tolerance = tolerance;
  return cell;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(near_schemes)

BOOST_AUTO_TEST_CASE(agree_on_pairs_of_any_kind) {
  const Solved cauchy(crowded_cell(NearSingular::cauchy, 1e-10));
  for (const double tolerance : {1e-6, 1e-9}) {
    const Solved interpolated(crowded_cell(NearSingular::interpolation, tolerance));
    for (const std::size_t k : {0U, 1U}) {
      const RigidMotion &a = cauchy.motion(k), &b = interpolated.motion(k);
      BOOST_TEST(std::abs(a.velocity - b.velocity) < tolerance);
      BOOST_TEST(std::abs(a.omega - b.omega) < tolerance);
      BOOST_TEST(std::abs(a.velocity) > 1e-2);
    }
    for (const std::size_t k : {2U, 3U, 4U}) {
      BOOST_TEST(std::abs(cauchy.load(k).force - interpolated.load(k).force) < 30 * tolerance);
      BOOST_TEST(std::abs(cauchy.load(k).torque - interpolated.load(k).torque) < 30 * tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_plan_names_the_scheme) {
  const auto told = [](NearSingular scheme) {
    const std::vector<std::string> lines = describe(SuspensionSolver(crowded_cell(scheme, 1e-6)));
    const auto line = std::find_if(lines.begin(), lines.end(), [](const std::string& text) {
      return text.starts_with("near correction");
    });
    return *line;
  };
  BOOST_TEST(told(NearSingular::interpolation).find("interpolation scheme") != std::string::npos);
  BOOST_TEST(told(NearSingular::automatic).find("Cauchy scheme") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
