// Checks the operator of bodies in periodic cells where the trapezoid rule alone fails: bodies that
// nearly touch an image of another body, or their own.
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "stress/solved_flow.hpp"
#include "stress/stresslet.hpp"
#include "suspension/system/linear_system.hpp"

using namespace stokesbook;
using std::numbers::pi;

namespace {

Plan accurate_plan() {
  Plan plan;
  plan.near_tolerance = 1e-14;
  plan.sum_tolerance = 1e-14;
  return plan;
}

Component disk(ComponentKind kind, double radius, Complex centre, Eigen::Index n) {
  Component component;
  component.kind = kind;
  component.curve = place(sample(Circle{radius}, n, Side::fluid_outside), centre, 0.0);
  component.centre = centre;
  if (kind == ComponentKind::prescribed) component.velocity = ComplexVector::Zero(n);
  return component;
}

struct Solved {
  Completion completion;
  ComplexVector density;
  int iterations;
};

Solved solve_cell(const StokesProblem& problem) {
  const LinearSystem discrete{problem,
                              SuspensionOperator(problem, cauchy_curves(problem), accurate_plan())};
  const GmresResult result = solve(discrete, discrete.system.right_hand_side(), {1e-13, 500});
  BOOST_TEST(result.converged);
  const ComplexVector density = deinterleaved(result.solution);
  return {discrete.system.closure().complete(density),
          discrete.system.closure().without_rigid_part(density), result.iterations};
}

// The gap 0.02 between two disks leads through the edge of the cell.
StokesProblem pair_at_the_edge() {
  StokesProblem problem;
  problem.components = {disk(ComponentKind::free_body, 0.2, {-0.29, 0.0}, 128),
                        disk(ComponentKind::free_body, 0.2, {0.29, 0.0}, 128)};
  problem.cell = {1.0, {0.3, 1.0}};
  return problem;
}

void check(Complex found, Complex exact, double tolerance) {
  BOOST_TEST(std::abs(found - exact) < tolerance * (1.0 + std::abs(exact)));
}

}  // namespace

// The drag of held disks in a square array at the area fraction 0.7: the gap between images of the
// disk is 0.056.
BOOST_AUTO_TEST_CASE(own_images) {
  constexpr double drag = 13519.150129894;
  StokesProblem problem;
  problem.components = {disk(ComponentKind::prescribed, std::sqrt(0.7 / pi), {0.3, -0.1}, 96)};
  problem.cell = {1.0, imaginary};
  problem.background = ComplexVector::Ones(96);
  check(-solve_cell(problem).completion.loads[0].force, drag, 1e-10);
  // The mean gradient of the pressure is given instead, as the force over the area.
  problem.background = {};
  problem.cell->pressure_gradient = -1.0;
  const Completion driven = solve_cell(problem).completion;
  check(driven.loads[0].force, -1.0, 1e-13);
  check(driven.uniform_velocity * drag, 1.0, 1e-10);
}

BOOST_AUTO_TEST_CASE(a_gap_through_the_edge) {
  StokesProblem problem = pair_at_the_edge();
  problem.components[0].force = {1.0, -0.5};
  problem.components[0].torque = 0.2;
  problem.components[1].force = {-1.0, 0.5};
  problem.background = all_nodes(curves_of(problem)).imag();
  const Solved solved = solve_cell(problem);
  const std::vector<RigidMotion>& motions = solved.completion.motions;
  check(motions[0].velocity, {0.0024876214562, -0.0349631349210}, 1e-11);
  check(motions[0].omega, -0.0743037501003, 1e-11);
  check(motions[1].omega, -0.2846656412087, 1e-11);
  const auto stresslet = [&](std::size_t k) {
    return body_stresslet(problem.components[k].curve,
                          solved.density.segment(128 * static_cast<Eigen::Index>(k), 128), 1.0);
  };
  check(stresslet(0), {0.07628104994902, 0.23241859306169}, 1e-11);
  check(stresslet(1), {0.07895149991216, 0.13794754936363}, 1e-11);
}

// The velocity of body 2 by a torque on body 1 is the rotation of body 1 by a force on body 2, also
// through the edge, and with forces that do not balance.
BOOST_AUTO_TEST_CASE(reciprocity_through_the_edge) {
  StokesProblem problem = pair_at_the_edge();
  problem.components[0].torque = 1.0;
  const Complex by_torque = solve_cell(problem).completion.motions[1].velocity;
  problem.components[0].torque = 0.0;
  Complex by_force;
  for (const Complex direction : {Complex{1.0}, imaginary}) {
    problem.components[1].force = direction;
    by_force += direction * solve_cell(problem).completion.motions[0].omega;
  }
  BOOST_TEST(std::abs(by_torque) > 0.01);
  check(by_torque, by_force, 1e-12);
}

BOOST_AUTO_TEST_CASE(problems_without_a_meaning_are_refused) {
  StokesProblem problem;
  problem.components = {disk(ComponentKind::free_body, 0.2, {0.0, 0.0}, 32)};
  problem.cell = {1.0, imaginary};
  BOOST_CHECK_NO_THROW(solve_cell(problem));
  problem.components[0].force = 1.0;  // a cell has no problem with a net force
  BOOST_CHECK_NO_THROW(solve_cell(problem));
  problem.gauge_length = 1.0;
  BOOST_CHECK_THROW(solve_cell(problem), std::invalid_argument);
  problem.gauge_length = {};
  problem.cell->pressure_gradient = 1.0;
  BOOST_CHECK_THROW(solve_cell(problem), std::invalid_argument);
  problem.cell = {1.0, 2.0};
  BOOST_CHECK_THROW(solve_cell(problem), std::invalid_argument);
}
