// Contact in the suspension: pairs that are driven together stay apart, forces balance, runs end.

#include "suspension/contact.hpp"

#include <boost/test/unit_test.hpp>

#include "support/closed_forms.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {

namespace {

using enum SteppingMethod;

struct Run {
  std::vector<Frame> frames;
  std::vector<StepInfo> steps;
  RunTotals totals;
};

Run run_of(const Scene& scene) {
  Run run;
  Observer observer;
  observer.frame = [&](const Frame& frame) { run.frames.push_back(frame); };
  observer.step = [&](const StepInfo& step) { run.steps.push_back(step); };
  const SuspensionSolver solver(scene);
  Simulation simulation(solver, observer);
  simulation.run();
  run.totals = simulation.totals();
  return run;
}

Scene with_contact(const BackgroundFlow& flow, const std::vector<Body>& bodies, double separation) {
  Scene scene;
  scene.flow = flow;
  scene.bodies = bodies;
  scene.solver.tolerance = 1e-5;
  scene.contact = ContactSettings{separation};
  return scene;
}

Scene over(Scene scene, double t_final, double dt, SteppingMethod method = euler) {
  scene.time = TimeSettings{t_final, dt, method};
  return scene;
}

double distance(const Frame& frame, std::size_t a, std::size_t b) {
  return std::abs(frame.bodies[a].position - frame.bodies[b].position);
}

// Unit disks that a flow of rate 30 drives together: the free ends of a step overlap, or are past
// each other.
Scene head_on(double offset) {
  return with_contact(ExtensionalFlow{-30.0},
                      {body_at(Circle{1.0}, {-1.4, offset}, automatic_nodes),
                       body_at(Circle{1.0}, {1.4, -offset}, automatic_nodes)},
                      0.1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(disks_driven_through_each_other_stop_at_the_separation) {
  for (const double dt : {0.1, 0.3, 1.0}) {
    const Run run = run_of(over(head_on(0.0), dt, dt));
    const double gap = distance(run.frames.back(), 0, 1) - 2.0;
    BOOST_TEST(gap >= 0.1 * (1 - 1e-3));
    BOOST_TEST(gap <= 0.1 * (1 + 4e-3));
    BOOST_TEST(run.steps.front().ncp_iterations <= 2);
    BOOST_TEST(run.totals.rejected_steps == 0);
  }
}

BOOST_AUTO_TEST_CASE(forces_of_contact_balance) {
  const Run run = run_of(over(head_on(0.0), 0.1, 0.1));
  const Frame& start = run.frames.front();
  BOOST_REQUIRE(start.contacts.size() == 1);
  BOOST_TEST(start.contacts[0].force > 0.0);
  BOOST_TEST(std::abs(start.bodies[0].force + start.bodies[1].force) <
             1e-12 * start.contacts[0].force);
  BOOST_TEST(std::abs(start.contacts[0].normal + Complex(1.0, 0.0)) < 1e-3);
}

BOOST_AUTO_TEST_CASE(stacks_of_three_keep_both_separations) {
  for (const SteppingMethod method : {euler, heun}) {
    const Scene scene = over(with_contact(ExtensionalFlow{-1.0},
                                          {body_at(Circle{1.0}, {-2.3, 0.0}, automatic_nodes),
                                           body_at(Circle{1.0}, {0.0, 0.0}, automatic_nodes),
                                           body_at(Circle{1.0}, {2.3, 0.0}, automatic_nodes)},
                                          0.1),
                             1.0, 0.1, method);
    const Run run = run_of(scene);
    for (const std::size_t k : {0U, 1U}) {
      const double gap = distance(run.frames.back(), k, k + 1) - 2.0;
      BOOST_TEST(gap >= 0.1 * (1 - 1e-3));
      BOOST_TEST(gap <= 0.1 * (1 + 4e-3));
    }
    for (const StepInfo& step : run.steps) {
      BOOST_TEST(step.ncp_iterations <= (method == heun ? 6 : 3));
    }
  }
}

// Radius 1/2 on the axis of u = (-x, y), held at a gap of so many h = pi / 32: forces by a prototype
// of the specification, which tend to 3 pi with the gap.
BOOST_AUTO_TEST_CASE(the_force_that_holds_two_disks_apart) {
  const double h = std::numbers::pi / 32;
  const std::vector<std::pair<double, double>> known{{4.0, 10.1758}, {3.0, 9.9867}, {2.0, 9.7982},
                                                     {1.5, 9.7043},  {1.0, 9.6108}, {0.5, 9.5176},
                                                     {0.25, 9.4711}};
  for (const auto& [gap, force] : known) {
    const double x = 0.5 + 0.5 * gap * h;
    Scene scene = with_contact(ExtensionalFlow{-1.0},
                               {body_at(Circle{0.5}, {-x, 0.0}, automatic_nodes),
                                body_at(Circle{0.5}, {x, 0.0}, automatic_nodes)},
                               gap * h);
    scene.contact->allow_close = true;
    const Run run = run_of(over(scene, 0.4, 0.1));
    BOOST_REQUIRE(run.frames.back().contacts.size() == 1);
    BOOST_TEST(run.frames.back().contacts[0].force == force, boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(starts_that_overlap_or_are_close_are_refused) {
  Scene scene = over(head_on(0.0), 0.1, 0.1);
  scene.bodies[0].position = {-0.9, 0.0};
  scene.bodies[1].position = {0.9, 0.0};
  const auto mentions = [](const std::string& text) {
    return [=](const ConfigurationRefused& refusal) {
      return std::string(refusal.what()).find(text) != std::string::npos;
    };
  };
  BOOST_CHECK_EXCEPTION(run_of(scene), ConfigurationRefused, mentions("body 0 and body 1 by 0.2"));
  scene.bodies[0].position = {-1.03, 0.0};
  scene.bodies[1].position = {1.03, 0.0};
  BOOST_CHECK_EXCEPTION(run_of(scene), ConfigurationRefused, mentions("allow_close"));
  scene.contact->allow_close = true;
  const Run run = run_of(scene);
  BOOST_TEST(distance(run.frames.back(), 0, 1) - 2.0 >= 0.06 - 2e-4);
}

// Two disks pass each other in shear and come back: without contact they would return to where they
// began.
BOOST_AUTO_TEST_CASE(reversed_shear_leaves_what_contact_has_moved) {
  const double h = std::numbers::pi / 32;
  const auto returned = [&](double gaps, double dt) {
    Scene scene = with_contact(ShearFlow{1.0},
                               {body_at(Circle{0.5}, {-8.0, 0.5}, automatic_nodes),
                                body_at(Circle{0.5}, {0.0, 0.0}, automatic_nodes)},
                               gaps * h);
    scene.reverse_at = {20.0};
    scene.output.dt_write = 40.0;
    const Run run = run_of(over(scene, 40.0, dt));
    const auto& start = run.frames.front().bodies;
    const auto& end = run.frames.back().bodies;
    double change = 0.0, size = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      change += std::norm(end[k].position - start[k].position);
      size += std::norm(start[k].position);
    }
    return std::sqrt(change / size);
  };
  BOOST_TEST(returned(1.0, 0.08) == 0.135, boost::test_tools::tolerance(0.06));
  BOOST_TEST(returned(2.0, 0.08) == 0.188, boost::test_tools::tolerance(0.06));
  BOOST_TEST(returned(3.0, 0.08) == 0.412, boost::test_tools::tolerance(0.06));
}

}  // namespace stokesbook::test
