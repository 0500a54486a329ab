// Tests that the solver refuses results whose accuracy it cannot ensure: a refusal names the
// components, the values, and the setting to change, and the recommended value is then accepted and
// accurate.

#include <cmath>
#include <limits>
#include <numbers>

#include "suspension/random_scenes.hpp"
#include "suspension/solver/solver_checks.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

Scene pair(double gap, int n_nodes, double tolerance = 1e-8) {
  Scene result = scene(
      {body(Circle{1.0}, n_nodes, -1.0 - 0.5 * gap), body(Circle{1.0}, n_nodes, 1.0 + 0.5 * gap)},
      ExtensionalFlow{1.0});
  result.solver.tolerance = tolerance;
  return result;
}

// Checks U_x of C11 with an error relative to U_x itself. The tolerance is relative to the largest
// velocity, 2, and is therefore a thousand times smaller at a gap of 1e-2, and thirty thousand
// times smaller at 1e-3.
void check_recommended_nodes(double gap, double expected, double relative_error) {
  const double tolerance = 0.5 * relative_error * expected;
  const SuspensionSolver planner(pair(gap, 64, tolerance));
  const std::vector<int> nodes = recommended_nodes(planner);
  BOOST_TEST(nodes[0] == nodes[1]);
  const Solved solved(pair(gap, nodes[0], tolerance));
  BOOST_TEST(std::abs(solved.motion(1).velocity.real() / expected - 1.0) < relative_error);
  check_refused(pair(gap, nodes[0] / 2, tolerance), {"n_nodes"});
}

}  // namespace

BOOST_AUTO_TEST_CASE(overlaps) {
  check_refused(pair(-0.1, 64), {"body 0 and body 1", "overlap", "0.1"});
  check_refused(pair(0.0, 64), {"body 0 and body 1", "overlap"});
  check_refused(scene({body(Circle{1.0}, 64, 0.0), body(Circle{0.3}, 64, 0.2)}), {"overlap"});
  check_refused(scene({body(Circle{1.0}, 64, 7.0)}, {}, {outer_wall(Circle{5.0}, 64)}),
                {"body 0 and wall 0", "overlap"});
  check_refused(scene({body(Circle{1.0}, 64, 4.5)}, {}, {outer_wall(Circle{5.0}, 64)}),
                {"body 0 and wall 0", "overlap"});
}

BOOST_AUTO_TEST_CASE(unresolved_gaps_shapes_and_densities) {
  check_refused(pair(0.01, 64), {"body 0 and body 1", "0.01 apart", "n_nodes"});
  check_refused(scene({body(Ellipse{10.0, 1.0}, 16, 0.0)}, ShearFlow{1.0}),
                {"body 0", "16 nodes", "shape", "n_nodes"});
  // The shape is resolved, but the density due to the Stokeslet inside a slender loaded body is
  // not.
  Scene slender = scene({body(Ellipse{3.0, 0.5}, 112, 0.0, 0.0, {1.0, 0.0})});
  slender.gauge_length = 100.0;
  check_refused(slender, {"density on body 0", "n_nodes"});
  Scene plain = pair(0.5, 48);
  plain.solver.near_singular = NearSingular::off;
  check_refused(plain, {"plain trapezoid rule", "near_singular"});
}

BOOST_AUTO_TEST_CASE(points_at_uneven_distances_are_told_how_to_lie) {
  ComplexVector points(40);
  for (int k = 0; k < 40; ++k) {
    const double part = k / 40.0;  // nodes crowd at the angle 0, with a kink where the curve closes
    points[k] = std::polar(1.0, 2.0 * std::numbers::pi * part * part * part);
  }
  check_refused(scene({body(NodalCurve{points, {}}, automatic_nodes, 0.0)}, ShearFlow{1.0}),
                {"body 0", "space its points evenly"});
}

BOOST_AUTO_TEST_CASE(an_error_of_which_nothing_is_known_is_not_called_infinite) {
  const Scene close = pair(1e-7, 64, 1e-12);
  const Resolutions nodes(2, {64, {}});
  const double unknown = std::numeric_limits<double>::infinity();
  const std::string message =
      accuracy_error(close, nodes, nodes, {{1e-15, 1.0}, {1e-15, 1.0}}, unknown, {});
  BOOST_TEST(message.starts_with("the error of the velocities cannot be estimated"), message);
  BOOST_TEST(message.find("inf") == std::string::npos, message);
}

// The error falls by e^(-decay) with each node, so that log(excess) / decay more nodes bring it down
// to the tolerance.
BOOST_AUTO_TEST_CASE(the_advice_on_nodes_suffices_for_the_tail) {
  const Scene close = pair(0.1, 64, 1e-6);
  const Resolutions nodes(2, {64, {}});
  const std::string message =
      accuracy_error(close, nodes, nodes, {{1e-15, 1.0}, {1e-4, 0.5}}, 1e-4, {});
  BOOST_TEST(message.find("body 1 is not resolved") != std::string::npos, message);
  const auto advice = message.find("set n_nodes = ");
  BOOST_REQUIRE(advice != std::string::npos);
  const int n_nodes = std::stoi(message.substr(advice + 14));
  BOOST_TEST(n_nodes >= 64 + std::log(100.0) / 0.5);
  BOOST_TEST(n_nodes <= 1.5 * 64);
}

BOOST_AUTO_TEST_CASE(memory_that_is_not_there) {
  const Scene large = scene({body(Circle{1.0}, 64, {}), body(Circle{1.0}, 1'000'000, 4.0)});
  check_refused(large, {"body 1", "1000000 nodes", "9.6e+04 GB", "n_nodes"});
  // The memory of a shape counts once, also if two bodies have this shape.
  const Scene twins = scene({body(Circle{1.0}, 1000, {}), body(Circle{1.0}, 1000, 4.0)});
  const Resolutions nodes(2, {1000, {}});
  BOOST_TEST(memory_error(twins, nodes, 1.1 * memory_of_discretised_shape(1000)).empty());
  Scene others = twins;
  others.bodies[1].shape = Circle{2.0};
  BOOST_TEST(!memory_error(others, nodes, 1.1 * memory_of_discretised_shape(1000)).empty());
  BOOST_TEST(available_memory() > 1e8);
}

BOOST_AUTO_TEST_CASE(impossible_data) {
  check_refused(
      scene({}, {}, {outer_wall(Circle{3.0}, 64), inner_wall(Circle{1.0}, 64, RadialWall{0.5})}),
      {"net flux"});
  check_refused(scene({body(Circle{1.0}, 32, 0.0, 0.0, {{0.0, -2.0}, 0.0})}),
                {"net force", "(0, -2)", "gauge_length"});
  Scene held = scene({held_body(Circle{1.0}, 32, 0.0, 0.0, {})}, UniformFlow{1.0});
  check_refused(held, {"uniform", "no effect", "gauge_length"});
  held.flow = SumFlow{{ShearFlow{1.0}, SumFlow{{held.flow}}}};
  check_refused(held, {"uniform", "no effect", "gauge_length"});
  held.gauge_length = 1.0;
  check_refused(held, {"gauge_length", "2"});
  Scene pushed = scene({body(Circle{1.0}, 32, 3.0, 0.0, {{1.0, 0.0}, 0.0})});
  pushed.gauge_length = 0.5;
  check_refused(pushed, {"body 0", "against its force", "gauge_length = 0.5", "set at least 2"});
}

BOOST_AUTO_TEST_CASE(separations_that_polygons_and_positions_carry) {
  // Unit disks begin slightly farther apart than the separation and are pushed together. By the law
  // of lubrication, one step reduces the gap by two tenths.
  const auto pressed = [](double separation, double x) {
    const double force = 10.0, speed = force * std::pow(separation, 1.5) / (1.5 * std::numbers::pi);
    Scene result = pair(1.1 * separation, automatic_nodes, 1e-2);
    result.flow = QuiescentFlow{};
    for (Body& body : result.bodies) {
      body.force = body.position.real() < 0.0 ? force : -force;
      body.position += x;
    }
    result.contact = ContactSettings{separation};
    const double dt = 0.2 * separation / speed;
    result.time = {.t_final = 2.0 * dt, .dt = dt, .method = SteppingMethod::euler};
    result.output.dt_write = dt;
    return result;
  };
  const auto check_kept = [&](double separation, double x) {
    const std::vector<Frame> frames = frames_of(pressed(separation, x));
    BOOST_REQUIRE_EQUAL(frames.size(), 3U);
    for (std::size_t i : {1U, 2U}) {
      const std::vector<BodyState>& bodies = frames[i].bodies;
      const double gap = std::abs(bodies[1].position - bodies[0].position) - 2.0;
      BOOST_TEST(gap == separation, boost::test_tools::tolerance(2e-5));
    }
  };
  check_kept(1.01e-8, 0.0);
  check_refused(pressed(0.99e-8, 0.0), {"minimum_separation", "9.9e-09", "at least 1e-08"});
  check_kept(1.01e-6, 1e4);
  check_refused(pressed(0.99e-6, 1e4),
                {"minimum_separation", "9.9e-07", "1e+04", "at least 1e-06"});
}

BOOST_AUTO_TEST_CASE(separations_are_compared_with_lengths_of_the_scene) {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    const Scene disks =
        scene({body(Circle{unit}, 32, {}), body(Circle{unit}, 32, {3.0 * unit, 0.0})});
    const SuspensionSolver solver(disks);
    const auto refusal = [&](double separation) {
      return separation_error(separation * unit, solver.start().configuration,
                              solver.discretisation());
    };
    BOOST_TEST(refusal(1.01e-8).empty());
    BOOST_TEST(!refusal(0.99e-8).empty());
  }
}

BOOST_AUTO_TEST_CASE(separations_are_compared_with_the_largest_body) {
  Scene disks = scene({body(Circle{1.0}, 32, {}), body(Circle{0.01}, 32, {3.0, 0.0})});
  for (int order = 0; order < 2; ++order) {
    const SuspensionSolver solver(disks);
    const auto refusal = [&](double separation) {
      return separation_error(separation, solver.start().configuration, solver.discretisation());
    };
    BOOST_TEST(refusal(1.01e-8).empty());
    BOOST_TEST(!refusal(0.99e-8).empty());
    std::swap(disks.bodies[0], disks.bodies[1]);
  }
}

BOOST_AUTO_TEST_CASE(failed_iterations) {
  Scene hard = mixed_bodies(1);
  hard.solver.gmres_max_iterations = 3;
  check_refused(hard, {"GMRES", "3 iterations", "gmres_max_iterations"});
  Scene broken = mixed_bodies(1);
  broken.bodies[2].torque = std::numeric_limits<double>::quiet_NaN();
  check_refused(broken, {"not finite"});
}

BOOST_AUTO_TEST_CASE(recommended_nodes_are_accepted_and_right) {
  check_recommended_nodes(1e-2, .0019680453757646231, 1e-9);
}

BOOST_AUTO_TEST_CASE(recommended_nodes_of_a_closer_pair_are_accepted_and_right,
                     *boost::unit_test::label("full")) {
  check_recommended_nodes(1e-3, 6.3142954288021558e-5, 1e-6);
}

}  // namespace stokesbook::test
