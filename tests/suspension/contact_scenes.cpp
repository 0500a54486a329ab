// Tests scenes that are difficult for contact (chapter 12): nodes that do not suffice, films that
// are nearly flat, and contact that lasts.

#include <boost/test/unit_test.hpp>

#include "contact_checks.hpp"
#include "contact_setup.hpp"
#include "support/exact_gaps.hpp"

namespace stokesbook::test {

namespace {

using Eigen::VectorXd;

using std::numbers::pi;

// Returns bodies in a container that turns once in the time 2 pi.
Scene in_turning_container(double radius, const std::vector<Body>& bodies, double separation) {
  Scene scene;
  scene.walls = {container(radius)};
  scene.walls[0].motion = RotatingWall{1.0};
  scene.bodies = bodies;
  scene.contact = ContactSettings{separation};
  scene.solver.tolerance = 1e-3;
  return scene;
}

auto mentions(const std::vector<std::string>& words) {
  return [=](const SolverError& error) {
    const std::string message = error.what();
    for (const std::string& word : words) {
      BOOST_TEST(message.find(word) != std::string::npos, "no \"" << word << "\" in: " << message);
    }
    return true;
  };
}

// The star rests on two of its arms, and the smaller of the two gaps changes from arm to arm. The
// search for gaps between polygons reports only the smaller gap. A step that resolves this gap
// alone would be refused or would oscillate between the two gaps.
void slide_star_down_a_wall(double orientation) {
  const double separation = 0.035;
  Body star = pushed(Star{0.4, 0.09, 3}, {-0.85, -1.25}, {0.0, -30.0});
  star.orientation = orientation;
  Scene scene = over(loaded({star}, separation), 3.0, 0.06, SteppingMethod::heun);
  scene.gauge_length.reset();
  scene.walls = {{.role = WallRole::outer, .shape = Ellipse{2.0, 1.93}}};
  const RecordedRun run = recorded_run(scene);
  BOOST_TEST(run.totals.rejected_steps == 0);
  BOOST_TEST(least_gap(scene, run) >= separation * (1 - 2e-5));
  const auto rests_on_two = [](const Frame& frame) { return frame.contacts.size() == 2; };
  BOOST_TEST(std::ranges::any_of(run.frames, rests_on_two));
}

// The density in a film under pressure is thousands of times as large as the velocities. On distant
// bodies, the quadrature errors of the film must not be mistaken for errors that more nodes reduce.
void press_film(double separation) {
  const std::vector<Body> bodies{turned(Ellipse{0.6688, 0.3824}, {-0.4357, -1.1251}, -0.184),
                                 turned(Ellipse{1.2848, 0.1724}, {0.8626, -0.9645}, 3.8755)};
  const Scene scene = in_turning_container(1.8773, bodies, separation);
  const RecordedRun run = recorded_run(over(scene, 0.5, 0.125));
  BOOST_TEST(run.steps.back().contacts == 1);
  BOOST_TEST(run.resolution.most_nodes[0] <= 96);
  for (const StepInfo& step : run.steps) BOOST_TEST(step.velocity_error < 1e-3);
}

}  // namespace

// Checks the reference that the other tests use: exact_gap() against known gaps.
BOOST_AUTO_TEST_CASE(gaps_by_formulas_are_known_ones) {
  const PlacedShape disk{Circle{0.5}, {2.0, 1.0}}, ellipse{Ellipse{2.0, 1.0}, {0.0, 0.0}, pi / 2};
  const auto near = boost::test_tools::tolerance(1e-13);
  BOOST_TEST(exact_gap({Circle{1.0}}, disk) == std::sqrt(5.0) - 1.5, near);
  BOOST_TEST(exact_gap(ellipse, {Circle{0.5}, {2.0, 0.0}}) == 0.5, near);
  BOOST_TEST(exact_gap(ellipse, {Star{0.5, 0.2, 3}, {2.0, 0.0}, pi}) == 0.4, near);
  BOOST_TEST(exact_gap(ellipse, disk) == exact_gap(disk, ellipse), near);
  const PlacedShape block{Superellipse{2.0, 0.5, 8}, {1.0, 0.0}, pi / 2};
  BOOST_TEST(exact_gap(block, {Circle{0.4}, {0.0, 0.1}}) == 0.1,
             boost::test_tools::tolerance(1e-5));
  BOOST_TEST(exact_gap(block, {Circle{0.4}, {0.0, 0.0}}) == 0.1, near);
  BOOST_TEST(exact_gap(block, {Circle{0.4}, {1.0, 2.5}}) == 0.1, near);
  BOOST_TEST(exact_gap({Circle{3.0}, {}, 0.0, true}, disk) == 2.5 - std::sqrt(5.0), near);
  // The curves cross, one lies within the other, or the disk lies outside of the enclosing circle.
  BOOST_TEST(exact_gap({Circle{2.0}}, disk) < 1e-12);
  BOOST_TEST(exact_gap({Circle{4.0}}, disk) == std::sqrt(5.0) - 3.5, near);
  BOOST_TEST(exact_gap({Circle{1.0}, {}, 0.0, true}, disk) == 1.5 - std::sqrt(5.0), near);
}

// Nodes that do not resolve the gap would make a repulsive contact force attract the bodies, for
// every step length.
BOOST_AUTO_TEST_CASE(too_few_nodes_stop_the_run) {
  const double h = pi / 32, x = 0.5 + 0.125 * h;
  Scene scene =
      over(in_contact(ExtensionalFlow{-1.0},
                      {body_at(Circle{0.5}, {-x, 0.0}, 32), body_at(Circle{0.5}, {x, 0.0}, 32)},
                      0.25 * h),
           1.0, 0.1);
  scene.solver.near_singular = NearSingular::off;
  for (const double tolerance : {1e-5, 1.0}) {
    scene.solver.tolerance = tolerance;
    BOOST_CHECK_EXCEPTION(
        recorded_run(scene), SolverError,
        mentions({"body 0 and body 1", "too close for the plain trapezoid rule"}));
  }
}

// An ellipse lies along the wall of a rotating container. The film between them is nearly flat, so
// the ellipse moves 10,000 times less under a force than a free body. Nodes that resolve the flow,
// which is a rigid rotation of the whole, do not resolve the contact force of a step that is too
// long.
BOOST_AUTO_TEST_CASE(forces_across_a_flat_gap_get_the_nodes_that_they_ask_for,
                     *boost::unit_test::label("full")) {
  const double separation = 0.033;
  Scene scene = in_turning_container(
      2.75, {body_at(Ellipse{1.2, 0.18}, {0.0, -2.2}, automatic_nodes)}, separation);
  Complex& position = scene.bodies[0].position;
  const PlacedShape wall{Circle{2.75}, {}, 0.0, true};
  while (exact_gap({scene.bodies[0].shape, position}, wall) > 1.01 * separation) {
    position -= Complex(0.0, 1e-4);
  }
  scene = over(scene, 0.3, 0.1);
  const auto run_to = [&](double tolerance) {
    scene.solver.tolerance = tolerance;
    return recorded_run(scene);
  };
  const RecordedRun coarse = run_to(1e-3), fine = run_to(1e-6);
  const auto largest_force = [](const RecordedRun& run) {
    double largest = 0.0;
    for (const ContactForce& contact : run.frames[1].contacts) {
      largest = std::max(largest, contact.force);
    }
    return largest;
  };
  BOOST_TEST(largest_force(fine) > 10.0);
  BOOST_TEST(std::abs(largest_force(coarse) / largest_force(fine) - 1.0) < 0.1);
  for (const StepInfo& step : coarse.steps) BOOST_TEST(step.velocity_error < 5e-3);
  BOOST_TEST(least_gap(scene, coarse) >= separation * (1 - 1e-4));
}

BOOST_AUTO_TEST_CASE(a_star_slides_down_a_wall_on_two_of_its_arms) {
  slide_star_down_a_wall(2.9);
}

BOOST_AUTO_TEST_CASE(a_star_that_begins_at_other_angles_slides_down_too,
                     *boost::unit_test::label("full")) {
  for (const double orientation : {2.8, 3.0}) slide_star_down_a_wall(orientation);
}

BOOST_AUTO_TEST_CASE(forces_ask_for_no_nodes_but_where_they_act) {
  press_film(0.029);
}

BOOST_AUTO_TEST_CASE(forces_across_other_films_ask_for_no_nodes_elsewhere_either,
                     *boost::unit_test::label("full")) {
  for (const double separation : {0.027, 0.031}) press_film(separation);
}

// On the nodes that resolve the flow of a full container, the computed mobility of the forces
// across its films may be unphysical. The LCP of these contacts may then have no solution, however
// short the step.
BOOST_AUTO_TEST_CASE(forces_without_a_solution_get_nodes) {
  const std::vector<Body> bodies{turned(Ellipse{0.7313, 0.4112}, {-0.2567, -0.9849}, 6.0375),
                                 turned(Ellipse{1.2912, 0.2015}, {0.1579, 0.5839}, 2.8759),
                                 turned(Ellipse{0.6835, 0.3006}, {0.6799, -0.3884}, 6.2988),
                                 turned(Ellipse{0.5926, 0.2749}, {-0.7573, -0.2246}, -0.1092),
                                 turned(Ellipse{1.0274, 0.1932}, {-0.2525, 0.2073}, 2.9845)};
  const Scene scene = in_turning_container(1.4786, bodies, 0.0448);
  const RecordedRun run = recorded_run(over(scene, 0.8, 0.08));
  BOOST_TEST(run.steps.back().contacts > 1);
  BOOST_TEST(run.totals.rejected_steps <= 2);
  BOOST_TEST(run.warnings.empty());
}

BOOST_AUTO_TEST_CASE(steps_too_long_for_a_crowd_are_halved) {
  std::vector<Body> bodies{body_at(Ellipse{0.3, 0.12}, {}, automatic_nodes)};
  for (int k = 0; k < 6; ++k) {
    bodies.push_back(turned(Ellipse{0.3, 0.12}, std::polar(0.62, k * pi / 3), k * pi / 3 + 1.8));
  }
  Scene scene = over(in_turning_container(0.85, bodies, 0.01), 1.0, 1.0);
  scene.solver.tolerance = 1e-2;
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  BOOST_TEST(run.totals.halved_by_contact > 0);
  // Steps become far shorter than time.dt, and one message says why.
  BOOST_TEST(std::ranges::min(run.steps, {}, &StepInfo::dt).dt <= 0.1);
  BOOST_REQUIRE(run.warnings.size() == 1U);
  const std::string& warning = run.warnings.front();
  BOOST_TEST(warning.starts_with("t = "), warning);
  for (const char* part :
       {"contact is not resolved", "body ", "steps of time.dt = 1 are cut to "}) {
    BOOST_TEST(warning.find(part) != std::string::npos, warning);
  }
}

// A disk rests in a container on sixteen times the nodes that it requires, as if an earlier film
// had required them.
BOOST_AUTO_TEST_CASE(lasting_contact_gives_back_nodes) {
  Body heavy = body_at(Circle{0.5}, {0.3, -1.3}, automatic_nodes);
  heavy.force = {0.0, -20.0};
  Scene scene = over(in_contact(QuiescentFlow{}, {heavy}, 0.05), 6.0, 0.1);
  scene.walls = {{WallRole::outer, Circle{2.0}, {}, 0.0, automatic_nodes, {}}};
  scene.output.dt_write = 2.0;
  const SuspensionSolver solver(scene);
  std::vector<Checkpoint> checkpoints;
  Observer observer;
  observer.checkpoint = [&](const Checkpoint& reached) { checkpoints.push_back(reached); };
  Simulation(solver, observer).run();
  Checkpoint fine = checkpoints.at(1);
  BOOST_REQUIRE(fine.history.at("contact_loads").size() > 0);
  fine.history["nodes_in_contact"] = VectorXd::Constant(2, 512.0);
  Simulation resumed(solver, observer);
  resumed.resume(fine);
  resumed.run();
  const Checkpoint& end = checkpoints.back();
  BOOST_REQUIRE(end.history.at("contact_loads").size() > 0);
  BOOST_TEST(end.history.at("nodes_in_contact").maxCoeff() <= 64.0);
}

// The contact force cancels the loads, so that next to nothing moves: the error of the flow with
// this force is far below that of the flow without it.
BOOST_AUTO_TEST_CASE(errors_in_lasting_contact_are_those_of_the_flow_with_its_forces) {
  Scene scene = over(pressed_disks(), 0.5, 0.05, SteppingMethod::heun);
  scene.output.dt_write = 0.25;
  const SuspensionSolver solver(scene);
  const double without_force = solver.solve(solver.start()).error_estimate,
               with_force = recorded_run(scene).steps.back().velocity_error;
  BOOST_TEST(with_force > 0.0);
  BOOST_TEST(with_force < 0.1 * without_force);
}

// Two disks touch, and a third one, with few nodes, comes near them.
BOOST_AUTO_TEST_CASE(nodes_that_no_longer_suffice_in_lasting_contact_are_refused) {
  Scene scene = loaded({pushed(Circle{1.0}, -1.02, 12.0), pushed(Circle{1.0}, 1.02, -3.0),
                        pushed(Circle{1.0}, 3.35, -9.0)},
                       0.04);
  scene.gauge_length = 30.0;
  scene.bodies[0].n_nodes = scene.bodies[1].n_nodes = 64;
  scene.bodies[2].n_nodes = 24;
  BOOST_CHECK_EXCEPTION(
      recorded_run(over(scene, 4.0, 0.05, SteppingMethod::heun)), SolverError,
      mentions({"the density on body 2 is not resolved", "with its 24 nodes; set n_nodes = "}));
}

}  // namespace stokesbook::test
