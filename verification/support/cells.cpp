// Solves the completed double-layer equation of rigid bodies in a periodic cell.
#include "support/cells.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

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

CellBody cell_body(const Shape& shape, Complex centre, double angle, Index n) {
  return {place(sample(shape, n, Side::fluid_outside), centre, angle), centre, {}};
}

Cell disk_in_a_cell(Complex a1, Complex a2, double area_fraction, Index n) {
  const Lattice lattice(a1, a2);
  const double radius = std::sqrt(area_fraction * lattice.area() / std::numbers::pi);
  return {lattice, {cell_body(Ellipse{radius, radius}, {0.1, -0.2}, 0.0, n)}};
}

void set_shear(Cell& cell) {
  cell.vorticity = -1.0;
  cell.strain = imaginary;
}

Cell three_bodies(Index n) {
  Cell cell{Lattice({2.2, 0.1}, {0.5, 1.9}),
            {cell_body(Ellipse{0.4, 0.2}, {-0.45, 0.35}, 0.5, n),
             cell_body(Ellipse{0.35, 0.25}, {0.5, 0.2}, -0.7, n),
             cell_body(Ellipse{0.3, 0.3}, {0.1, -0.55}, 0.0, n)}};
  cell.viscosity = 1.3;
  cell.vorticity = -1.3;  // G = [[0.2, 1], [-0.3, -0.2]]
  cell.strain = {0.4, 0.7};
  cell.mean_velocity = {0.1, -0.2};
  const Complex forces[] = {{1.0, 0.5}, {-0.3, 0.2}, {-0.7, -0.7}};
  const double torques[] = {0.3, -0.2, 0.5};
  for (std::size_t k = 0; k < 3; ++k) {
    cell.bodies[k].force = forces[k];
    cell.bodies[k].torque = torques[k];
  }
  return cell;
}

Cell worm_in_a_cell(Index n) {
  Curve worm{ComplexVector(n), ComplexVector(n), ComplexVector(n), Side::fluid_outside};
  for (Index i = 0; i < n; ++i) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double x = 0.7 * std::cos(t), dx = -0.7 * std::sin(t), ddx = -x;
    const double wave = std::cos(2.0 * x), bend = std::sin(2.0 * x);
    worm.x[i] = {x, 0.15 * std::sin(t) + 0.3 * bend};
    worm.dx[i] = {dx, 0.15 * std::cos(t) + 0.6 * wave * dx};
    worm.ddx[i] = {ddx, -0.15 * std::sin(t) + 0.6 * wave * ddx - 1.2 * bend * dx * dx};
  }
  return {Lattice(1.0, imaginary), {{worm, 0.0, 0.0, 0.0, RigidMotion{}}}, 0.7};
}

CellSolution solve(const Cell& cell, const FmmSettings& settings, const ComplexVector& targets,
                   FmmImagePlan images) {
  if (!images) images = images_in(cell.lattice);
  const StokesProblem problem = problem_of(cell);
  const std::vector<Curve> curves = curves_of(problem);
  const std::vector<Index> offsets = node_offsets(problem);
  ComplexVector centres(std::ssize(curves));
  for (std::size_t k = 0; k < curves.size(); ++k) {
    centres[static_cast<Index>(k)] = cell.bodies[k].centre;
  }
  const Closure closure(problem);
  const Fmm fmm(curves, centres, settings, images);
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
  if (result.residual > 1e-12) throw std::runtime_error("a cell is not solved");
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
    const Fmm at_targets(curves, centres, targets, settings, images);
    solution.velocity =
        velocity(at_targets, rest, completion.loads, cell.viscosity) + background(cell, targets);
    solution.velocity.array() += completion.uniform_velocity;
  }
  return solution;
}

}  // namespace stokesbook::test
