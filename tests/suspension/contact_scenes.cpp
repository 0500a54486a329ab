// Scenes that are hard on contact: deep overlaps ahead, slots, oblique slides, moving walls, and
// what must be refused.

#include <boost/test/unit_test.hpp>

#include "lcp/fischer_newton.hpp"
#include "lcp/lemke.hpp"
#include "support/exact_gaps.hpp"
#include "support/recorded_run.hpp"
#include "suspension/load_response.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

Body turned(const Shape& shape, Complex position, double orientation) {
  Body body = body_at(shape, position, automatic_nodes);
  body.orientation = orientation;
  return body;
}

Body held(const Shape& shape, Complex position, double orientation = 0.0) {
  Body body = turned(shape, position, orientation);
  body.held = true;
  return body;
}

Body pushed(const Shape& shape, Complex position, Complex force) {
  Body body = body_at(shape, position, automatic_nodes);
  body.force = force;
  return body;
}

// Loads and held bodies in an unbounded fluid, to contact's needs.
Scene loaded(const std::vector<Body>& bodies, double separation) {
  Scene scene = in_contact(QuiescentFlow{}, bodies, separation);
  scene.gauge_length = 100.0;
  scene.solver.tolerance = 1e-3;
  return scene;
}

Wall container(double radius) {
  return {.role = WallRole::outer, .shape = Circle{radius}};
}

// Bodies in a container that turns once in 2 pi.
Scene in_turning_container(double radius, const std::vector<Body>& bodies, double separation) {
  Scene scene;
  scene.walls = {container(radius)};
  scene.walls[0].motion = RotatingWall{1.0};
  scene.bodies = bodies;
  scene.contact = ContactSettings{separation};
  scene.solver.tolerance = 1e-3;
  return scene;
}

// Least gap of all written states, by the curves' formulas.
double least_gap(const Scene& scene, const RecordedRun& run) {
  return least_exact_gap(scene, run.frames, 10.0);
}

auto mentions(const std::vector<std::string>& words) {
  return [=](const NumericsRefused& refusal) {
    const std::string message = refusal.what();
    for (const std::string& word : words) {
      BOOST_TEST(message.find(word) != std::string::npos, "no \"" << word << "\" in: " << message);
    }
    return true;
  };
}

}  // namespace

// What checks the others is itself checked.
BOOST_AUTO_TEST_CASE(gaps_by_formulas_are_known_ones) {
  const PlacedShape disk{Circle{0.5}, {2.0, 1.0}}, ellipse{Ellipse{2.0, 1.0}, {0.0, 0.0}, pi / 2};
  const auto near = boost::test_tools::tolerance(1e-13);
  BOOST_TEST(exact_gap({Circle{1.0}}, disk) == std::sqrt(5.0) - 1.5, near);
  BOOST_TEST(exact_gap(ellipse, {Circle{0.5}, {2.0, 0.0}}) == 0.5, near);
  BOOST_TEST(exact_gap(ellipse, {Star{0.5, 0.2, 3}, {2.0, 0.0}, pi}) == 0.4, near);
  BOOST_TEST(exact_gap(ellipse, disk) == exact_gap(disk, ellipse), near);
  BOOST_TEST(exact_gap({Circle{3.0}, {}, 0.0, true}, disk) == 2.5 - std::sqrt(5.0), near);
  // Across one another, one within the other, and outside of what encloses.
  BOOST_TEST(exact_gap({Circle{2.0}}, disk) < 1e-12);
  BOOST_TEST(exact_gap({Circle{4.0}}, disk) == std::sqrt(5.0) - 3.5, near);
  BOOST_TEST(exact_gap({Circle{1.0}, {}, 0.0, true}, disk) == 1.5 - std::sqrt(5.0), near);
}

// The free end of the step lies in the middle of a held body, where the nearest way out is any.
BOOST_AUTO_TEST_CASE(a_step_that_would_end_deep_within_a_body) {
  for (const double angle : {0.0, 0.4, pi / 2}) {
    Scene scene = loaded({pushed(Circle{0.3}, {0.1, 2.0}, {0.0, -100.0}),
                          held(Ellipse{1.5, 0.8}, {0.0, 0.0}, angle)},
                         0.05);
    const SuspensionSolver solver(scene);
    const double speed = -solver.solve(solver.initial_configuration()).motions[0].velocity.imag();
    const double dt = 2.0 / speed;
    scene = over(scene, dt, dt);
    const RecordedRun run = recorded_run(scene);
    const double gap = least_gap(scene, run);
    BOOST_TEST(gap >= 0.05 * (1 - 1e-3));
    BOOST_TEST(gap <= 0.05 * (1 + 4e-3));
    BOOST_TEST(run.frames.back().bodies[0].position.imag() > 0.0);
  }
}

// A disk is pressed into the slit of two held ones, for four hundred steps.
BOOST_AUTO_TEST_CASE(a_pinched_disk_stays_where_it_is) {
  Scene scene = loaded({pushed(Circle{0.8}, {0.01, 1.6}, {0.0, -200.0}),
                        held(Circle{1.0}, {-1.2, 0.0}), held(Circle{1.0}, {1.2, 0.0})},
                       0.09);
  scene.output.dt_write = 1.0;
  const RecordedRun run = recorded_run(over(scene, 40.0, 0.1));
  BOOST_REQUIRE(run.steps.size() == 400);
  for (std::size_t k = 5; k < run.frames.size(); ++k) {
    BOOST_REQUIRE(run.frames[k].contacts.size() == 2);
    for (const ContactForce& contact : run.frames[k].contacts) {
      BOOST_TEST(contact.gap >= 0.09 * (1 - 1e-3));
      BOOST_TEST(contact.gap <= 0.09 * (1 + 4e-3));
    }
    BOOST_TEST(std::abs(run.frames[k].bodies[0].position - run.frames[5].bodies[0].position) <
               1e-3 * 0.09);
  }
}

// Between two flat sides, as far away as contact keeps them: 1.002 separations.
BOOST_AUTO_TEST_CASE(a_disk_moves_along_a_slot_that_fits) {
  const double separation = 0.1, side = 0.5 + 1.002 * separation + 0.4;
  Scene scene = loaded(
      {pushed(Circle{0.4}, {-0.5, 0.0}, {50.0, 0.0}), held(Superellipse{2.0, 0.5, 8}, {0.0, side}),
       held(Superellipse{2.0, 0.5, 8}, {0.0, -side})},
      separation);
  const auto end = [&](const Scene& with_or_without) {
    return recorded_run(over(with_or_without, 1.0, 0.05)).frames.back().bodies[0].position;
  };
  Scene free = scene;
  free.contact.reset();
  const Complex passed = end(scene);
  BOOST_TEST(passed.real() > 0.5);
  BOOST_TEST(std::abs(passed.imag()) < 3e-3 * separation);
  BOOST_TEST(std::abs(passed - end(free)) < 3e-3 * separation);
}

BOOST_AUTO_TEST_CASE(an_ellipse_slides_along_another_one) {
  Body ellipse = pushed(Ellipse{0.5, 0.25}, {-1.5, 0.95}, {30.0, -60.0});
  ellipse.orientation = 0.6;
  const Scene scene = over(loaded({ellipse, held(Ellipse{3.0, 0.5}, {0.0, 0.0})}, 0.05), 6.0, 0.1);
  const RecordedRun run = recorded_run(scene);
  BOOST_TEST(least_gap(scene, run) >= 0.05 * (1 - 1e-3));
  BOOST_TEST(run.frames.back().bodies[0].position.real() > -1.0);
  int touching = 0;
  for (const Frame& frame : run.frames) {
    if (frame.contacts.size() != 1) continue;
    ++touching;
    // What the body passes on to the fluid is its load and the force of contact.
    const double added = std::abs(frame.bodies[0].force - ellipse.force);
    BOOST_TEST(added == frame.contacts[0].force, boost::test_tools::tolerance(1e-9));
  }
  BOOST_TEST(touching > 20);
}

// A disk is pressed on a wall that moves against it, is pushed back, rolls aside, and is let go.
BOOST_AUTO_TEST_CASE(a_moving_wall_pushes_a_disk) {
  Scene scene = in_contact(QuiescentFlow{}, {pushed(Circle{0.4}, {-0.6, 0.02}, {40.0, 0.0})}, 0.05);
  scene.solver.tolerance = 1e-3;
  scene.walls = {container(3.0), {.role = WallRole::inner, .shape = Circle{0.5}}};
  scene.walls[1].position = {0.5, 0.0};
  scene.walls[1].motion = TranslatingWall{{-0.5, 0.0}};
  scene = over(scene, 2.0, 0.05);
  const RecordedRun run = recorded_run(scene);
  BOOST_TEST(least_gap(scene, run) >= 0.05 * (1 - 1e-3));
  for (std::size_t k = 4; k <= 24; ++k) {
    const Frame& frame = run.frames[k];
    BOOST_REQUIRE(frame.contacts.size() == 1);
    BOOST_TEST(frame.contacts[0].b.is_wall);
    BOOST_TEST(frame.contacts[0].b.number == 1);
    BOOST_TEST(frame.contacts[0].gap <= 0.05 * (1 + 4e-3));
    // Both ends of the straight path are the separation away: |apart + dt faster| = |apart|.
    const Complex apart = frame.bodies[0].position - frame.walls[1].position;
    const Complex faster = frame.bodies[0].velocity + 0.5;
    const double radial = (faster * std::conj(apart)).real();
    BOOST_TEST(std::abs(radial + 0.5 * 0.05 * std::norm(faster)) < 3e-3);
  }
  BOOST_TEST(run.frames.back().contacts.empty());
}

BOOST_AUTO_TEST_CASE(starts_with_one_within_the_other_are_refused) {
  Scene scene = over(in_contact(ShearFlow{1.0},
                                {body_at(Circle{0.5}, {3.0, 0.0}, automatic_nodes),
                                 body_at(Circle{1.0}, {0.0, 0.0}, automatic_nodes),
                                 body_at(Ellipse{0.2, 0.1}, {0.1, 0.2}, automatic_nodes)},
                                0.05),
                     0.1, 0.1);
  BOOST_CHECK_EXCEPTION(recorded_run(scene), ConfigurationRefused,
                        mentions({"overlap", "body 1 and body 2"}));
  scene.contact->allow_close = true;
  BOOST_CHECK_EXCEPTION(recorded_run(scene), ConfigurationRefused,
                        mentions({"overlap", "body 1 and body 2"}));
}

BOOST_AUTO_TEST_CASE(starts_outside_of_the_container_are_refused) {
  for (const double x : {1.8, 5.0}) {
    Scene scene = over(in_contact(QuiescentFlow{},
                                  {body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes),
                                   body_at(Circle{0.5}, {x, 0.0}, automatic_nodes)},
                                  0.05),
                       0.1, 0.1);
    scene.walls = {container(2.0)};
    BOOST_CHECK_EXCEPTION(recorded_run(scene), ConfigurationRefused,
                          mentions({"overlap", "body 1 and wall 0"}));
  }
}

// Nodes that do not resolve the gap would answer a force with an attraction:
// no step is short enough.
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
        recorded_run(scene), NumericsRefused,
        mentions({"body 0 and body 1", "too close for the plain trapezoid rule"}));
  }
}

// Nineteen disks in a hexagon are pressed towards its middle: 42 contacts, more than the 38 ways in
// which their centres can move. Forces need not be unique, motions are.
BOOST_AUTO_TEST_CASE(motions_are_unique_where_forces_are_not) {
  const double pitch = 2.1;
  std::vector<Body> bodies;
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      if (std::abs(i + j) > 2) continue;
      const Complex position = pitch * Complex(i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j);
      bodies.push_back(pushed(Circle{1.0}, position, -500.0 * position));
    }
  }
  const Scene scene = over(loaded(bodies, 0.1), 0.1, 0.1);
  const SuspensionSolver solver(scene);
  const Configuration start = solver.initial_configuration();
  const Solution free = solver.solve(start);
  std::vector<Eigen::Triplet<double>> entries;
  Index m = 0;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      const Complex apart = bodies[a].position - bodies[b].position;
      if (std::abs(apart) > 1.1 * pitch) continue;
      const Complex normal = apart / std::abs(apart);
      for (const auto& [body, sign] : {std::pair{a, 1.0}, std::pair{b, -1.0}}) {
        const auto first = static_cast<int>(3 * body), row = static_cast<int>(m);
        entries.emplace_back(first, row, sign * normal.real());
        entries.emplace_back(first + 1, row, sign * normal.imag());
      }
      ++m;
    }
  }
  BOOST_REQUIRE(m == 42);
  Eigen::SparseMatrix<double> forces(static_cast<Index>(3 * bodies.size()), m);
  forces.setFromTriplets(entries.begin(), entries.end());
  AnsweredLoads none;
  none.tolerance = 0.0;
  LoadResponse respond(solver, start, free, none);
  const MatrixXd response = respond(forces);
  const MatrixXd unsymmetric = forces.transpose() * response;
  const VectorXd free_velocity = to_rate(free);
  const LcpProblem problem{0.5 * (unsymmetric + unsymmetric.transpose()),
                           forces.transpose() * free_velocity};
  // Of 42 forces 7 are not unique: there the matrix is singular, and Newton's method linear.
  const LcpResult by_pivots = lemke(problem),
                  by_newton = fischer_newton(problem, {.tolerance = 1e-9});
  BOOST_REQUIRE((by_pivots.status == LcpStatus::solved));
  BOOST_REQUIRE((by_newton.status == LcpStatus::solved));
  const VectorXd pivots = free_velocity + response * by_pivots.z,
                 newton = free_velocity + response * by_newton.z;
  const double scale = free_velocity.cwiseAbs().maxCoeff();
  BOOST_TEST((pivots - newton).cwiseAbs().maxCoeff() < 1e-6 * scale);
  // The run finds the same: no disk moves towards another one.
  const RecordedRun run = recorded_run(scene);
  BOOST_TEST(least_gap(scene, run) >= 0.1 * (1 - 1e-3));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto first = static_cast<Index>(3 * k);
    const Complex velocity = run.frames[0].bodies[k].velocity;
    BOOST_TEST(std::abs(velocity - Complex(pivots[first], pivots[first + 1])) < 0.02 * scale);
  }
}

// An ellipse lies along the wall of a rotating container: a film that is nearly flat lets it move
// 10,000 times less than a free body. What resolves the flow, in which all turns as one, does not
// resolve the force that keeps the two apart in a step that is too long.
BOOST_AUTO_TEST_CASE(forces_across_a_flat_gap_get_the_nodes_that_they_ask_for) {
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
  for (const StepInfo& step : coarse.steps) BOOST_TEST(step.error_estimate < 5e-3);
  BOOST_TEST(least_gap(scene, coarse) >= separation * (1 - 1e-4));
}

// It rests on two of its arms, a hair nearer now with the one, now with the other: polygons tell
// but the deeper one, and a step that sees to that alone is refused or goes to and fro.
BOOST_AUTO_TEST_CASE(a_star_slides_down_a_wall_on_two_of_its_arms) {
  const double separation = 0.035;
  for (const double orientation : {2.8, 2.9, 3.0}) {
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
}

// The density of a film under pressure is thousands of times the velocities. To a body elsewhere,
// errors of the film's quadrature must not look like those that nodes mend.
BOOST_AUTO_TEST_CASE(forces_ask_for_no_nodes_but_where_they_act) {
  const std::vector<Body> bodies{turned(Ellipse{0.6688, 0.3824}, {-0.4357, -1.1251}, -0.184),
                                 turned(Ellipse{1.2848, 0.1724}, {0.8626, -0.9645}, 3.8755)};
  for (const double separation : {0.027, 0.029, 0.031}) {
    const Scene scene = in_turning_container(1.8773, bodies, separation);
    const RecordedRun run = recorded_run(over(scene, 0.5, 0.125));
    BOOST_TEST(run.steps.back().contacts == 1);
    BOOST_TEST(run.resolution.most_nodes[0] <= 96);
    for (const StepInfo& step : run.steps) BOOST_TEST(step.error_estimate < 1e-3);
  }
}

// On the nodes that the flow of a full container asks for, forces across its films may have
// responses that no fluid has, and then together no solution, however short the step.
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
}

// A disk rests in a container on sixteen times the nodes that it needs, as a film before may have
// asked for.
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

}  // namespace stokesbook::test
