// Tests loads that are measured in the flow itself, by averages of the velocity over circles: every
// body has the given load, held bodies and walls have the reported one, and the outer wall carries
// the sum of all.

#include "circle_averages.hpp"
#include "units.hpp"

namespace stokesbook::test {
namespace {

// Returns a pushed star, a held ellipse, an inner wall that turns and a free lopsided body, far
// enough apart for circles between them.
Scene crowd() {
  return scene({body(Star{0.6, 0.15, 5}, 192, {-1.9, 0.8}, 0.4, {{0.7, -1.1}, 0.4}),
                held_body(Ellipse{0.7, 0.4}, 128, {0.4, 1.8}, 0.9, {{0.3, 0.2}, -0.6}),
                body(lopsided_curve(0.5), 160, {1.9, -0.5}, 2.0, {{0.2, 0.9}, -0.3})},
               {}, {inner_wall(Superellipse{0.5, 0.6, 4}, 160, RotatingWall{0.8}, {-0.4, -1.7})});
}

// Measures the load of component k on circles between its outermost point and the nearest point of
// the other components.
Enclosed around(const Solved& solved, std::size_t k) {
  const StokesProblem problem =
      solved.solver.problem(solved.solution.instant, solved.solution.discretisation);
  const Complex centre = solved.solution.instant.configuration[k].position;
  const double own = bounding_radius(problem.components[k].curve, centre);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < problem.components.size(); ++j) {
    if (j == k) continue;
    const ComplexVector& x = problem.components[j].curve.x;
    nearest = std::min(nearest, (x.array() - centre).abs().minCoeff());
  }
  const double clearance = nearest - own;
  return enclosed_by(solved, centre, own + 0.1 * clearance, own + 0.8 * clearance);
}

void check_load(const Enclosed& enclosed, const Load& load, const Units& units) {
  BOOST_TEST(distance(enclosed.load, load, units.length) < 1e-10 * units.force());
  BOOST_TEST(enclosed.residual < 1e-12 * units.velocity());
  BOOST_TEST(enclosed.flux < 1e-12 * units.velocity() * units.length);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(balance)

BOOST_AUTO_TEST_CASE(loads_in_an_unbounded_fluid) {
  for (const Units& units : two_units) {
    const Solved solved(in_units(crowd(), units));
    Complex total{};
    for (std::size_t k = 0; k < 4; ++k) {
      check_load(around(solved, k), solved.load(k), units);
      total += solved.load(k).force;
    }
    BOOST_TEST(std::abs(total) < 1e-11 * units.force());
  }
}

BOOST_AUTO_TEST_CASE(loads_in_a_container) {
  Scene cell = crowd();
  cell.walls.push_back(outer_wall(Circle{3.6}, 224, TranslatingWall{{0.4, -0.2}}));
  for (const Units& units : two_units) {
    const Solved solved(in_units(cell, units));
    for (std::size_t k = 0; k < 4; ++k) check_load(around(solved, k), solved.load(k), units);
    // A circle just inside the outer wall encloses the opposite of the load of the wall.
    const Load wall = solved.load(4);
    check_load(enclosed_by(solved, 0.0, 3.0 * units.length, 3.55 * units.length),
               {-wall.force, -wall.torque}, units);
  }
}

// The flow also has the given loads if the bodies nearly touch. A circle in the fluid then encloses
// both bodies together, so the sum of their loads is measured.
BOOST_AUTO_TEST_CASE(sum_of_close_loads) {
  Scene pair = scene({body(Circle{0.7}, 0, -0.705, 0.0, {{1.0, 0.4}, 0.3}),
                      body(Ellipse{0.7, 0.4}, 0, 0.705, 0.0, {{-0.2, 0.5}, -0.9})});
  const Solved solved(resolved(with_gauge(pair, 10.0)));
  const Complex lever{0.705, 0.0};
  const double torque = 0.3 - 0.9 + cross(-lever, {1.0, 0.4}) + cross(lever, {-0.2, 0.5});
  check_load(enclosed_by(solved, 0.0, 1.6, 4.0), {{0.8, 0.9}, torque}, {});
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
