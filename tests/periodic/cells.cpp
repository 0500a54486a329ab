// Solves the completed double-layer equation of rigid bodies in a periodic cell.
#include "cells.hpp"

#include <boost/test/unit_test.hpp>

#include "closure/closure.hpp"
#include "double_layer/double_layer.hpp"
#include "krylov/gmres.hpp"
#include "periodic/far_operator.hpp"
#include "stress/stresslet.hpp"

namespace stokesbook::test {

using Eigen::Index;

namespace {

// The linear flow, and the mean velocity unless that is a result.
ComplexVector background(const Cell& cell, const ComplexVector& targets) {
  ComplexVector velocity(targets.size());
  for (Index i = 0; i < targets.size(); ++i) velocity[i] = cell.linear_velocity(targets[i]);
  if (!cell.pressure_gradient) velocity.array() += cell.mean_velocity;
  return velocity;
}

StokesProblem problem_of(const Cell& cell) {
  StokesProblem problem;
  problem.viscosity = cell.viscosity;
  problem.cell = {cell.lattice.shortest(), cell.lattice.second(), cell.pressure_gradient};
  for (const CellBody& body : cell.bodies) {
    Component component{
        ComponentKind::free_body, body.curve, body.centre, body.force, body.torque, {}};
    if (body.held) {
      component.kind = ComponentKind::prescribed;
      component.velocity = RigidModes(body.curve, body.centre).at_nodes(*body.held);
    }
    problem.components.push_back(component);
  }
  problem.background = background(cell, all_nodes(curves_of(problem)));
  return problem;
}

// Evaluates a sum of the density and the loads.
ComplexVector velocity(const Fmm& fmm, const ComplexVector& density, const std::vector<Load>& loads,
                       double viscosity) {
  ComplexVector force(std::ssize(loads));
  Eigen::VectorXd torque(force.size());
  for (Index k = 0; k < force.size(); ++k) {
    force[k] = loads[static_cast<std::size_t>(k)].force / viscosity;
    torque[k] = loads[static_cast<std::size_t>(k)].torque / viscosity;
  }
  return fmm.velocity({density, force, torque});
}

}  // namespace

CellSolution solve(const Cell& cell, const FmmSettings& settings, const ComplexVector& targets) {
  const StokesProblem problem = problem_of(cell);
  const std::vector<Curve> curves = curves_of(problem);
  const std::vector<Index> offsets = node_offsets(problem);
  ComplexVector centres(std::ssize(curves));
  for (std::size_t k = 0; k < curves.size(); ++k) {
    centres[static_cast<Index>(k)] = cell.bodies[k].centre;
  }
  const Closure closure(problem);
  const Fmm fmm(curves, centres, settings, images_in(cell.lattice));
  const LinearMap apply = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    const ComplexVector density = deinterleaved(v), rest = closure.without_rigid_part(density);
    ComplexVector sum = velocity(fmm, rest, closure.density_loads(density), cell.viscosity) -
                        0.5 * rest + closure.smooth_velocity(density);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const Index first = offsets[k], n = curves[k].size();
      sum.segment(first, n) += diagonal_velocity(curves[k], rest.segment(first, n));
    }
    return interleaved(sum);
  };
  const ComplexVector rhs =
      closure.boundary_data() -
      velocity(fmm, ComplexVector::Zero(offsets.back()), closure.given_loads(), cell.viscosity);
  const GmresResult result = gmres(apply, {}, interleaved(rhs), {1e-14, 200});
  BOOST_TEST(result.residual < 1e-12);
  const ComplexVector density = deinterleaved(result.solution);
  const ComplexVector rest = closure.without_rigid_part(density);
  const Completion completion = closure.complete(density);
  CellSolution solution;
  solution.mean_velocity =
      cell.pressure_gradient ? completion.uniform_velocity : cell.mean_velocity;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const RigidMotion& motion = cell.bodies[k].held ? *cell.bodies[k].held : completion.motions[k];
    const ComplexVector own = rest.segment(offsets[k], curves[k].size());
    solution.bodies.push_back({motion.velocity, motion.omega, completion.loads[k].force,
                               completion.loads[k].torque,
                               body_stresslet(curves[k], own, cell.viscosity)});
  }
  if (targets.size() > 0) {
    const Fmm at_targets(curves, centres, targets, settings, images_in(cell.lattice));
    solution.velocity =
        velocity(at_targets, rest, completion.loads, cell.viscosity) + background(cell, targets);
    solution.velocity.array() += completion.uniform_velocity;
  }
  return solution;
}

}  // namespace stokesbook::test
