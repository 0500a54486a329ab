// Assembles a problem as a dense matrix: in the reduced form (03.11), or as (03.5) with the border
// (03.6) or (03.8). Extracts motions and loads from the solution.
#include "closure/bordered_system.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Assembles the double layer with its jump, -1/2 + D, between all components.
MatrixXd layer_matrix(const StokesProblem& problem) {
  MatrixXd matrix = double_layer_matrix(curves_of(problem));
  matrix.diagonal().array() -= 0.5;
  return matrix;
}

// Returns one rigid motion of a component as velocities at its own nodes: the unit velocity along
// axis 1, along axis 2, or the turn (x - c)^perp.
ComplexVector rigid_mode(const Component& component, int mode) {
  if (mode < 2) {
    return ComplexVector::Constant(component.curve.size(), mode == 0 ? Complex{1.0} : imaginary);
  }
  return imaginary * (component.curve.x.array() - component.centre).matrix();
}

// Evaluates at points the flow of a unit load at a centre: the force along axis 1, along axis 2, or
// the torque.
ComplexVector unit_load_velocity(const ComplexVector& points, Complex centre, int mode, double mu,
                                 double gauge) {
  ComplexVector velocity(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    const Complex r = points[i] - centre;
    velocity[i] = mode < 2 ? stokeslet(r, mode == 0 ? Complex{1.0} : imaginary, mu, gauge)
                           : rotlet(r, 1.0, mu);
  }
  return velocity;
}

// Scales of the border's columns and rows for the three rigid motions.
struct BorderScales {
  double motion[3];  // unknown = motion * (U, omega)
  double load[3];    // unknown = (F, L) / load
  double row[3];     // row = row * integral
};

BorderScales border_scales(const Component& component, ClosureForm form, double viscosity) {
  if (form == ClosureForm::power_bordered) return {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  // Unknowns U, a omega, F / (4 pi mu) and L / (4 pi mu a); rows are means, as in (03.8).
  const RigidModes modes(component.curve, component.centre);
  const double a = modes.gyration_radius(), length = perimeter(component.curve);
  const double load = 4.0 * std::numbers::pi * viscosity;
  return {{1, 1, a}, {load, load, load * a}, {1 / length, 1 / length, 1 / (length * a)}};
}

DenseSystem assemble_reduced(const StokesProblem& problem, const std::vector<Index>& offsets) {
  const Closure closure(problem);
  const Index n = offsets.back();
  MatrixXd complement(2 * n, 2 * n), added(2 * n, 2 * n);
  // Column by column, A eta = (-1/2 + D)(I - P) eta + C eta with the velocities C of the closure.
  for (Index column = 0; column < 2 * n; ++column) {
    const Complex direction = column % 2 == 0 ? Complex{1.0} : imaginary;
    const ComplexVector unit = ComplexVector::Unit(n, column / 2) * direction;
    complement.col(column) = interleaved(closure.without_rigid_part(unit));
    added.col(column) = interleaved(closure.velocity(unit));
  }
  return {layer_matrix(problem) * complement + added, interleaved(closure.right_hand_side())};
}

DenseSystem assemble_bordered(const StokesProblem& problem, ClosureForm form,
                              const std::vector<Index>& offsets) {
  const Index n = offsets.back();
  const Index rows = 2 * n + 3 * std::ranges::count_if(problem.components, is_inner);
  DenseSystem system{MatrixXd::Zero(rows, rows), VectorXd::Zero(rows)};
  system.matrix.topLeftCorner(2 * n, 2 * n) = layer_matrix(problem);
  const ComplexVector nodes = all_nodes(curves_of(problem));
  const std::vector<double> gauges = stokeslet_gauges(problem);
  // The rows are (03.5) at all nodes, then three conditions (03.6) or (03.8) per inner component.
  Index border = 2 * n;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    const Index first = 2 * offsets[k], size = 2 * component.curve.size();
    if (component.velocity.size() > 0) {
      system.rhs.segment(first, size) += interleaved(component.velocity);
    }
    if (!is_inner(component)) continue;
    const BorderScales scales = border_scales(component, form, problem.viscosity);
    // Power's border has no gauge length: its Stokeslet contains -log(rho).
    const double gauge =
        form == ClosureForm::power_bordered ? problem.gauge_length.value_or(1.0) : gauges[k];
    const VectorXd w = weights(component.curve);
    for (int mode = 0; mode < 3; ++mode, ++border) {
      const ComplexVector rigid = rigid_mode(component, mode);
      const ComplexVector load =
          unit_load_velocity(nodes, component.centre, mode, problem.viscosity, gauge);
      system.matrix.row(border).segment(first, size) =
          scales.row[mode] * interleaved(rigid.cwiseProduct(w)).transpose();
      if (component.kind == ComponentKind::free_body) {
        // The motion of a free body is unknown; its load belongs to the right-hand side.
        const double given[3] = {component.force.real(), component.force.imag(), component.torque};
        system.matrix.col(border).segment(first, size) = -interleaved(rigid) / scales.motion[mode];
        system.rhs.head(2 * n) -= given[mode] * interleaved(load);
        if (form == ClosureForm::power_bordered) system.rhs[border] = given[mode];
      } else {
        // The load of a prescribed component is unknown.
        system.matrix.col(border).head(2 * n) = scales.load[mode] * interleaved(load);
        system.matrix(border, border) = form == ClosureForm::power_bordered ? -1.0 : 1.0;
      }
    }
  }
  if (problem.background.size() > 0) system.rhs.head(2 * n) -= interleaved(problem.background);
  return system;
}

}  // namespace

DenseSystem assemble(const StokesProblem& problem, ClosureForm form) {
  const std::vector<Index> offsets = node_offsets(problem);
  return form == ClosureForm::reduced ? assemble_reduced(problem, offsets)
                                      : assemble_bordered(problem, form, offsets);
}

Completion complete_dense(const StokesProblem& problem, ClosureForm form,
                          const VectorXd& solution) {
  const Index n = node_offsets(problem).back();
  const Closure closure(problem);
  const ComplexVector density = deinterleaved(solution.head(2 * n));
  Completion result = closure.complete(density);
  if (form == ClosureForm::reduced) return result;
  Index border = 2 * n;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    if (!is_inner(component)) continue;
    const auto [motion, load, row] = border_scales(component, form, problem.viscosity);
    const auto unknown = solution.segment<3>(border);
    if (component.kind == ComponentKind::free_body) {
      result.motions[k] = {{unknown[0] / motion[0], unknown[1] / motion[1]},
                           unknown[2] / motion[2]};
    } else {
      result.loads[k] = {{unknown[0] * load[0], unknown[1] * load[1]}, unknown[2] * load[2]};
    }
    border += 3;
  }
  return with_balance(problem, std::move(result));
}

}  // namespace stokesbook
