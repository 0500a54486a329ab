// Checks that every written step of a run with contact keeps its gaps, that contact forces push
// across closed gaps only, and that all forces and torques balance.
#include "contact_checks.hpp"

#include <algorithm>
#include <cmath>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "support/contact_balance.hpp"
#include "support/exact_gaps.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook::test {

namespace {

// Gaps may be smaller than the separation by this factor of the separation, see
// SuspensionContact::too_close().
constexpr double accepted = 2e-5;

// Widest gap across which a contact force may act, relative to the separation.
constexpr double open = 1.1;

constexpr double rounding = 1e-12;

constexpr int most_iterations = 9;

std::size_t component(const ContactParty& party, const Scene& scene) {
  return party.number + (party.is_wall ? scene.bodies.size() : 0);
}

// Checks the gaps at the end of a step by Euler's method. The forces of Heun's method act in a half
// of the step only, so gaps may be wider at the end of the step.
void check_ends(const Scene& scene, const Frame& frame, const Frame& next, double separation) {
  const std::vector<PlacedShape> placed = placed_shapes(scene, next);
  for (const ContactForce& contact : frame.contacts) {
    const double gap =
        exact_gap(placed[component(contact.a, scene)], placed[component(contact.b, scene)]);
    BOOST_TEST(gap <= open * separation);
  }
}

void check_forces(const Scene& scene, const Frame& frame, double separation) {
  for (const ContactForce& contact : frame.contacts) {
    BOOST_TEST(contact.force >= 0.0);
    BOOST_TEST(std::abs(std::abs(contact.normal) - 1.0) <= rounding);
    BOOST_TEST(contact.gap <= open * separation);
  }
  BOOST_TEST(contact_imbalance(scene, frame) <= rounding);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    const BodyState& state = frame.bodies[k];
    if (body.held) continue;
    const double largest = std::max(largest_force(frame), std::abs(body.force));
    const Load listed = contact_load(frame, {false, k}, state.position);
    BOOST_TEST(std::abs(state.force - body.force - listed.force) <= rounding * largest);
    BOOST_TEST(std::abs(state.torque - body.torque - listed.torque) <= rounding * largest);
  }
}

}  // namespace

double least_gap(const Scene& scene, const RecordedRun& run) {
  return least_exact_gap(scene, run.frames, 10.0);
}

double largest_force(const Frame& frame) {
  double largest = 0.0;
  for (const ContactForce& contact : frame.contacts) largest = std::max(largest, contact.force);
  return largest;
}

Load contact_load(const Frame& frame, const ContactParty& on, Complex about) {
  Load load;
  for (const ContactForce& contact : frame.contacts) {
    if (contact.a != on && contact.b != on) continue;
    const Complex force = contact.force * (contact.a == on ? contact.normal : -contact.normal);
    load.force += force;
    load.torque += cross(contact.point - about, force);
  }
  return load;
}

void check_contact(const Scene& scene, const RecordedRun& run, std::optional<double> least) {
  const double separation = SuspensionSolver(scene).separation(), kept = least.value_or(separation);
  BOOST_TEST(run.stopped == "");
  BOOST_REQUIRE(run.frames.size() == run.steps.size() + 1);
  BOOST_TEST(least_exact_gap(scene, run.frames, 2.0 * separation) >= kept - accepted * separation);
  for (const Frame& frame : run.frames) check_forces(scene, frame, separation);
  for (std::size_t k = 0; k < run.steps.size(); ++k) {
    const StepInfo& step = run.steps[k];
    BOOST_TEST(step.ncp_iterations <= most_iterations);
    BOOST_TEST(step.force_imbalance <= rounding);
    BOOST_TEST(step.torque_imbalance <= rounding);
    if (scene.time->method != SteppingMethod::euler) continue;
    check_ends(scene, run.frames[k], run.frames[k + 1], separation);
  }
  // If the step length is given, only contact rejects steps.
  if (scene.time->method == SteppingMethod::euler && !scene.time->tolerance) {
    BOOST_TEST(run.totals.halved_by_contact == run.totals.rejected_steps);
  }
}

}  // namespace stokesbook::test
