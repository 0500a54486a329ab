// Tests which starts contact refuses, and pairs that may begin closer than the separation (chapter
// 12).

#include <string>
#include <utility>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "contact_checks.hpp"
#include "contact_setup.hpp"

namespace stokesbook::test {

namespace {

double gap(const Frame& frame) {
  return std::abs(frame.bodies[0].position - frame.bodies[1].position) - 2.0;
}

// Checks that the refusal contains the reason, and each of these pairs with its overlap or gap. The
// tolerance covers the digits in the message and the sag of polygons.
void check_start_refused(const Scene& scene, const std::string& reason,
                         const std::vector<std::pair<std::string, double>>& pairs) {
  const auto tells = [&](const ConfigurationError& error) {
    const std::string message = error.what();
    BOOST_TEST(message.find(reason) != std::string::npos);
    for (const auto& [text, length] : pairs) {
      const std::size_t at = message.find(text);
      BOOST_TEST_REQUIRE(at != std::string::npos, "no \"" << text << "\" in: " << message);
      BOOST_TEST(std::abs(std::stod(message.substr(at + text.size())) - length) <=
                 0.01 * scene.contact->minimum_separation);
    }
    return true;
  };
  BOOST_CHECK_EXCEPTION(recorded_run(scene), ConfigurationError, tells);
}

}  // namespace

BOOST_AUTO_TEST_CASE(starts_that_overlap_are_refused_with_pairs_and_depths) {
  Scene scene = over(head_on(0.0), 0.1, 0.1);
  scene.bodies.push_back(body_at(Circle{1.0}, {0.0, 2.05}, automatic_nodes));
  scene.bodies[0].position = {-0.9, 0.0};
  scene.bodies[1].position = {0.9, 0.0};
  for (const bool allow_close : {false, true}) {
    scene.contact->allow_close = allow_close;
    check_start_refused(scene, "overlap", {{"body 0 and body 1 by ", 0.2}});
  }
  scene.bodies[2].position = {0.0, 1.5};
  const double deep = 2.0 - std::hypot(0.9, 1.5);
  check_start_refused(scene, "overlap",
                      {{"body 0 and body 1 by ", 0.2},
                       {"body 0 and body 2 by ", deep},
                       {"body 1 and body 2 by ", deep}});
}

BOOST_AUTO_TEST_CASE(starts_below_the_separation_are_refused_with_pairs_and_gaps) {
  Scene scene = over(head_on(0.0), 0.1, 0.1);
  scene.bodies.push_back(body_at(Ellipse{0.5, 1.0}, {2.61, 0.0}, automatic_nodes));
  scene.bodies[0].position = {-1.03, 0.0};
  scene.bodies[1].position = {1.03, 0.0};
  check_start_refused(scene, "allow_close",
                      {{"body 0 and body 1 are ", 0.06}, {"body 1 and body 2 are ", 0.08}});
  scene.bodies.pop_back();
  scene.contact->allow_close = true;
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run, 0.06);
  BOOST_TEST(run.frames.back().contacts.size() == 1);
  BOOST_TEST(std::abs(gap(run.frames.back()) - 0.06) <= 1e-5 * 0.1);
}

// A gap never becomes smaller than its widest earlier value, or than the separation if that value
// exceeds the separation.
BOOST_AUTO_TEST_CASE(close_pairs_keep_the_widest_gap_that_they_had) {
  for (const double pressed_from : {0.3, 0.9}) {
    const Scene scene = opened_and_pressed(pressed_from, pressed_from + 1.0);
    const RecordedRun run = recorded_run(scene);
    check_contact(scene, run, 0.06);
    double widest = 0.0;
    for (const Frame& frame : run.frames) {
      BOOST_TEST(gap(frame) >= std::min(widest, 0.1) - 2e-5 * 0.1);
      widest = std::max(widest, gap(frame));
    }
    BOOST_TEST(run.frames.back().contacts.size() == 1);
    BOOST_TEST(std::abs(gap(run.frames.back()) - std::min(widest, 0.1)) <= 2e-5 * 0.1);
  }
}

BOOST_AUTO_TEST_CASE(starts_with_one_within_the_other_are_refused) {
  Scene scene = over(in_contact(ShearFlow{1.0},
                                {body_at(Circle{0.5}, {3.0, 0.0}, automatic_nodes),
                                 body_at(Circle{1.0}, {0.0, 0.0}, automatic_nodes),
                                 body_at(Circle{0.2}, {0.3, 0.4}, automatic_nodes)},
                                0.05),
                     0.1, 0.1);
  for (const bool allow_close : {false, true}) {
    scene.contact->allow_close = allow_close;
    check_start_refused(scene, "overlap", {{"body 1 and body 2 by ", 0.7}});
  }
}

// At the start, a gap may be smaller than the separation by a thousandth of the separation.
BOOST_AUTO_TEST_CASE(starts_may_lack_a_thousandth_of_the_separation) {
  const auto with_gap = [](double gap) {
    Scene scene = over(head_on(0.0), 0.1, 0.1);
    scene.bodies[0].position = {-1.0 - 0.5 * gap, 0.0};
    scene.bodies[1].position = {1.0 + 0.5 * gap, 0.0};
    return scene;
  };
  const double lacking = 0.1 * (1.0 - 1.1e-3);
  check_start_refused(with_gap(lacking), "allow_close", {{"body 0 and body 1 are ", lacking}});
  const SuspensionSolver solver(with_gap(0.1 * (1.0 - 0.9e-3)));
  SuspensionContact(solver).admit_start({solver.start().configuration});
}

// Contact is searched for along the path of a step. A step of a billion turns would take a billion
// times as long, so it is refused.
BOOST_AUTO_TEST_CASE(steps_longer_than_the_scene_are_shortened_or_refused) {
  Scene cell;
  cell.bodies = {body_at(Circle{0.5}, {1.0, 0.0}, 32)};
  cell.walls = {{.role = WallRole::outer, .shape = Circle{3.0}, .n_nodes = 64}};
  cell.solver.tolerance = 1e-2;
  cell.contact = ContactSettings{0.05};
  cell.walls[0].motion = RotatingWall{1e18};
  const auto tells = [](const SolverError& error) {
    const std::string message = error.what();
    return message.find("wall 0 moves by") != std::string::npos &&
           message.find("time.dt_min") != std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(recorded_run(over(cell, 1.0, 0.1)), SolverError, tells);
  cell.walls[0].motion = RotatingWall{1e3};
  for (const StepInfo& step : recorded_run(over(cell, 0.05, 0.05)).steps) {
    BOOST_TEST(step.dt * 1e3 * 3.0 <= 40.0 * (1.0 + 1e-12));
  }
}

// One body crosses the wall of the container; the other lies outside of it.
BOOST_AUTO_TEST_CASE(starts_outside_of_the_container_are_refused) {
  for (const double x : {1.8, 5.0}) {
    const Scene scene = over(in_container(2.0,
                                          {body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes),
                                           body_at(Circle{0.5}, {x, 0.0}, automatic_nodes)},
                                          0.05),
                             0.1, 0.1);
    check_start_refused(scene, "overlap", {{"body 1 and wall 0 by ", x + 0.5 - 2.0}});
  }
}

}  // namespace stokesbook::test
