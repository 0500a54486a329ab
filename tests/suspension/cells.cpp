// Checks the operator of bodies in periodic cells where the trapezoid rule alone fails: bodies that
// nearly touch an image of another body, or their own.
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "stress/solved_flow.hpp"
#include "stress/stresslet.hpp"
#include "support/ewald.hpp"
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

struct SolvedCell {
  Completion completion;
  ComplexVector density;
  ComplexVector without_rigid_part;
};

SolvedCell solve_cell(const StokesProblem& problem) {
  const LinearSystem discrete{SuspensionOperator(problem, cauchy_curves(problem), accurate_plan())};
  const GmresResult result = solve(discrete, discrete.system.right_hand_side(), {1e-13, 500});
  BOOST_TEST(result.converged);
  const ComplexVector density = deinterleaved(result.solution);
  return {discrete.system.closure().complete(density), density,
          discrete.system.closure().without_rigid_part(density)};
}

// The gap 0.02 between two disks leads through the edge of the cell.
StokesProblem pair_at_the_edge() {
  StokesProblem problem;
  problem.components = {disk(ComponentKind::free_body, 0.2, {-0.29, 0.0}, 128),
                        disk(ComponentKind::free_body, 0.2, {0.29, 0.0}, 128)};
  problem.cell = {1.0, {0.3, 1.0}};
  return problem;
}

void check_close(Complex found, Complex exact, double tolerance) {
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
  check_close(-solve_cell(problem).completion.loads[0].force, drag, 1e-10);
  // The mean gradient of the pressure is given instead, as the force over the area.
  problem.background = {};
  problem.cell->pressure_gradient = -1.0;
  const Completion driven = solve_cell(problem).completion;
  check_close(driven.loads[0].force, -1.0, 1e-13);
  check_close(driven.uniform_velocity * drag, 1.0, 1e-10);
}

BOOST_AUTO_TEST_CASE(a_gap_through_the_edge) {
  StokesProblem problem = pair_at_the_edge();
  problem.components[0].force = {1.0, -0.5};
  problem.components[0].torque = 0.2;
  problem.components[1].force = {-1.0, 0.5};
  problem.background = all_nodes(curves_of(problem)).imag();
  const SolvedCell solved = solve_cell(problem);
  const std::vector<RigidMotion>& motions = solved.completion.motions;
  check_close(motions[0].velocity, {0.0024876214562, -0.0349631349210}, 1e-11);
  check_close(motions[0].omega, -0.0743037501003, 1e-11);
  check_close(motions[1].omega, -0.2846656412087, 1e-11);
  const auto stresslet = [&](std::size_t k) {
    return body_stresslet(
        problem.components[k].curve,
        solved.without_rigid_part.segment(128 * static_cast<Eigen::Index>(k), 128), 1.0);
  };
  check_close(stresslet(0), {0.07628104994902, 0.23241859306169}, 1e-11);
  check_close(stresslet(1), {0.07895149991216, 0.13794754936363}, 1e-11);
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
  check_close(by_torque, by_force, 1e-12);
}

// The flow of a solution is the motion of a body on its curve, also in the gap through the edge;
// it repeats with the lattice, and the pressure rises by F.w / V along a vector w.
BOOST_AUTO_TEST_CASE(flow_between_images) {
  StokesProblem problem = pair_at_the_edge();
  problem.components[0].force = {1.0, -0.5};
  problem.components[0].torque = 0.2;
  problem.components[1].force = {-0.4, 0.8};
  problem.background = all_nodes(curves_of(problem)).imag();
  const SolvedCell solved = solve_cell(problem);
  const SolvedFlow flow(problem, cauchy_curves(problem), solved.density,
                        {1e-14, planned_sum(accurate_plan())});
  ComplexVector z(40);
  for (Eigen::Index i = 0; i < 40; ++i) {
    z[i] =
        problem.components[i < 20 ? 0 : 1].centre + std::polar(0.2, 0.3 * static_cast<double>(i));
  }
  const ComplexVector velocity = flow.velocity(z);
  const std::vector<FlowDerivatives> slopes = flow.derivatives(z);
  for (Eigen::Index i = 0; i < 40; ++i) {
    const std::size_t k = i < 20 ? 0 : 1;
    const RigidMotion& motion = flow.completion().motions[k];
    check_close(velocity[i] + z[i].imag(),
                motion.velocity + motion.omega * perp(z[i] - problem.components[k].centre), 1e-9);
  }
  for (const Complex w : {Complex{1.0}, Complex{0.3, 1.0}}) {
    const ComplexVector moved = z.array() + w;
    const ComplexVector there = flow.velocity(moved);
    const std::vector<FlowDerivatives> slopes_there = flow.derivatives(moved);
    const double rise = dot(Complex{0.6, 0.3}, w);
    for (std::size_t i = 0; i < 40; ++i) {
      check_close(there[static_cast<Eigen::Index>(i)], velocity[static_cast<Eigen::Index>(i)],
                  1e-11);
      check_close(slopes_there[i].pressure, slopes[i].pressure + rise, 1e-9);
      check_close(slopes_there[i].vorticity, slopes[i].vorticity, 1e-9);
      check_close(slopes_there[i].strain, slopes[i].strain, 1e-9);
    }
  }
  // Derivatives agree with differences of velocities, in the fluid beside the gap.
  const Complex point{0.5, 0.06};
  const double h = 1e-4;
  const ComplexVector around = flow.velocity(
      ComplexVector{{point - h, point + h, point - h * imaginary, point + h * imaginary}});
  const Complex along_x = (around[1] - around[0]) / (2.0 * h),
                along_y = (around[3] - around[2]) / (2.0 * h);
  const FlowDerivatives slope = flow.derivatives(ComplexVector{{point}})[0];
  check_close(slope.strain, along_x + imaginary * along_y, 1e-5);
  check_close(slope.vorticity, along_x.imag() - along_y.real(), 1e-5);
}

// The constant of the pressure does not depend on the targets, nor on the place of the sources.
BOOST_AUTO_TEST_CASE(pressure_of_forces) {
  StokesProblem problem = pair_at_the_edge();
  const std::vector<Load> loads = {{{1.0, -0.5}, 0.2}, {{-0.4, 0.8}, 0.0}};
  for (std::size_t k : {0U, 1U}) problem.components[k].force = loads[k].force;
  const Lattice lattice(problem.cell->a1, problem.cell->a2);
  const ComplexVector zero = ComplexVector::Zero(256);
  for (const ComplexVector& targets : {ComplexVector{{Complex{0.0, 0.1}}},
                                       ComplexVector{{Complex{0.4, -0.3}, Complex{1.7, 2.0}}}}) {
    const auto flow = FastSum(problem, 1e-14, targets).derivatives(zero, loads);
    for (Eigen::Index i = 0; i < targets.size(); ++i) {
      double exact = 0.0;
      for (std::size_t k : {0U, 1U}) {
        const Complex f =
            test::ewald_functions(lattice, targets[i] - problem.components[k].centre).f;
        exact += (loads[k].force * f).real() / (2.0 * pi) +
                 dot(loads[k].force, targets[i]) / lattice.area();
      }
      check_close(flow[static_cast<std::size_t>(i)].pressure, exact, 1e-12);
    }
  }
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
  const ComplexVector density = ComplexVector::Zero(32), outside{{Complex{0.3, 0.3}}};
  problem.cell->pressure_gradient = {};
  const SolvedFlow direct(problem, cauchy_curves(problem), density);
  BOOST_CHECK_THROW(direct.velocity(outside), std::invalid_argument);
  BOOST_CHECK_THROW(direct.derivatives(outside), std::invalid_argument);
  problem.cell = {1.0, 2.0};
  BOOST_CHECK_THROW(solve_cell(problem), std::invalid_argument);
}
