// Checks Stokes' paradox in the plane resistance problem: with Stokeslets -log(r / ell), the
// resistance of a circle of radius sqrt(e) ell does not exist (03.12). With zero net force and a
// free uniform velocity (03.14), the problem is regular at every scale.

#include <boost/test/unit_test.hpp>

#include "support/problems.hpp"
#include "support/spectra.hpp"

namespace stokesbook::test {
namespace {

using std::numbers::pi;

StokesProblem held_circle(double radius, double gauge) {
  return {{held_body(Circle{radius}, 32, {{0.2, 0.1}}, {1.0, 0.0})}, 1.3, {}, gauge};
}

// Three bodies are held in motions that do not balance, and a force pushes one body. All lengths
// are multiples of `length`.
StokesProblem held_and_pushed(double length) {
  const auto at = [&](double x, double y, double angle) {
    return Pose{length * Complex{x, y}, angle};
  };
  return {
      {held_body(Circle{0.5 * length}, 32, at(-1.5, 0, 0), {{length, 0.0}, 0.5}),
       held_body(Ellipse{length, 0.6 * length}, 48, at(1, 0.5, 0.4), {{0.0, 0.3 * length}, 0.0}),
       free_body(Circle{0.6 * length}, 32, at(0, 2.5, 0), {{1.0, -0.7}, 0.2 * length}),
       held_body(Circle{0.4 * length}, 32, at(0.2, -1.7, 0), {{}, -1.0})},
      1.3,
      {},
      {}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(degenerate_scale)

BOOST_AUTO_TEST_CASE(gauge_problem_is_singular_there) {
  for (const double radius : {1e-3, 1.0, 1e3}) {
    const double degenerate = radius / std::sqrt(std::numbers::e);
    for (const ClosureForm form : all_forms) {
      const Eigen::VectorXd values =
          singular_values(assemble(held_circle(radius, degenerate), form).matrix);
      BOOST_TEST(values.minCoeff() < 1e-14);
    }
  }
}

// The closed form F = 4 pi mu U / (1/2 - log(a / ell)) changes its sign at the degenerate scale:
// problems with nearby gauges can be solved, but their forces are not meaningful.
BOOST_AUTO_TEST_CASE(force_changes_sign_there) {
  const double degenerate = 1.0 / std::sqrt(std::numbers::e);
  for (const ClosureForm form : all_forms) {
    for (const double factor : {0.9, 1.1}) {
      const Load load = solve_dense(held_circle(1.0, factor * degenerate), form).loads[0];
      const double exact = 4 * pi * 1.3 / std::log(factor);
      BOOST_TEST(load.force.real() == exact, boost::test_tools::tolerance(1e-12));
    }
  }
}

// The system contains no gauge length, so its condition number is the same in any unit of length.
BOOST_AUTO_TEST_CASE(free_uniform_velocity_has_no_unit) {
  const Completion at_one = solve_dense(held_and_pushed(1.0), ClosureForm::reduced);
  const double condition =
      condition_number(assemble(held_and_pushed(1.0), ClosureForm::reduced).matrix);
  for (const double length :
       {1e-3, std::sqrt(std::numbers::e), 2.0 * std::sqrt(std::numbers::e), 20.0, 1e3}) {
    const StokesProblem problem = held_and_pushed(length);
    BOOST_TEST(condition_number(assemble(problem, ClosureForm::reduced).matrix) == condition,
               boost::test_tools::tolerance(1e-9));
    // The held bodies' velocities grow with the length, but the force on the free body does not.
    // The expected solution is the rescaled solution of a problem of unit length.
    const Completion scaled = solve_dense(problem, ClosureForm::reduced);
    StokesProblem expected = held_and_pushed(1.0);
    expected.components[2].force /= length;
    expected.components[2].torque /= length;
    const Completion unit = solve_dense(expected, ClosureForm::reduced);
    for (std::size_t k = 0; k < 4; ++k) {
      BOOST_TEST(distance(scaled.loads[k],
                          {length * unit.loads[k].force, length * length * unit.loads[k].torque},
                          length) < 1e-12 * std::max(1.0, length));
      BOOST_TEST(distance(scaled.motions[k],
                          {length * unit.motions[k].velocity, unit.motions[k].omega},
                          length) < 1e-13 * std::max(1.0, length));
    }
    BOOST_TEST(std::abs(scaled.uniform_velocity - length * unit.uniform_velocity) <
               1e-13 * std::max(1.0, length));
  }
  Complex total{};
  for (const Load& load : at_one.loads) total += load.force;
  BOOST_TEST(std::abs(total) < 1e-13);
}

// In a frame that moves with the uniform velocity, the bordered forms agree. The net force is zero,
// so the gauge has no effect: any gauge must return the same loads and motions.
BOOST_AUTO_TEST_CASE(agrees_with_every_gauge) {
  const StokesProblem problem = held_and_pushed(1.0);
  const Completion free = solve_dense(problem, ClosureForm::reduced);
  StokesProblem gauged = problem;
  gauged.background = ComplexVector::Constant(all_nodes(problem).size(), free.uniform_velocity);
  for (const double gauge : {7.3, 100.0, 1e5}) {
    gauged.gauge_length = gauge;
    for (const ClosureForm form : all_forms) {
      const Completion result = solve_dense(gauged, form);
      for (std::size_t k = 0; k < 4; ++k) {
        BOOST_TEST(distance(result.loads[k], free.loads[k]) < 1e-11);
        BOOST_TEST(distance(result.motions[k], free.motions[k]) < 1e-12);
      }
    }
  }
}

// The force on a single held body is zero, because the uniform velocity of the fluid equals the
// body's velocity. The torque is the same as with a gauge.
BOOST_AUTO_TEST_CASE(lone_held_body) {
  const RigidMotion motion{{0.7, -0.2}, 1.5};
  const StokesProblem problem{{held_body(Circle{0.8}, 32, {{1, 1}}, motion)}, 1.3, {}, {}};
  const Completion result = solve_dense(problem, ClosureForm::reduced);
  const double torque = 4 * pi * 1.3 * 0.64 * motion.omega;
  BOOST_TEST(distance(result.loads[0], {0.0, torque}) < 1e-13);
  BOOST_TEST(std::abs(result.uniform_velocity - motion.velocity) < 1e-14);
}

BOOST_AUTO_TEST_CASE(net_force_needs_a_gauge) {
  const Component pushed = free_body(Circle{1}, 16, {}, {{1.0, 0.0}, 0.0});
  const Component pulled = free_body(Circle{1}, 16, {{4, 0}}, {{-1.0, 0.0}, 0.0});
  BOOST_CHECK_THROW(Closure({{pushed}, 1.0, {}, {}}), std::invalid_argument);
  BOOST_CHECK_NO_THROW(Closure({{pushed, pulled}, 1.0, {}, {}}));
  BOOST_CHECK_NO_THROW(Closure({{pushed}, 1.0, {}, 10.0}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
