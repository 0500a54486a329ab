#pragma once

#include "near_singular/near_targets.hpp"
#include "stress/solved_flow.hpp"
#include "support/vectors.hpp"
#include "support/walls.hpp"

namespace stokesbook::test {

/// Corrects the reduced system of a problem at nodes that are near another component. The
/// correction is the velocity of the Cauchy scheme minus the velocity of the trapezoid rule. The
/// curves are placed without rotation.
inline void add_near_correction(DenseSystem& system, const StokesProblem& problem,
                                const std::vector<PlacedCurve>& placed) {
  const std::vector<Eigen::Index> offsets = node_offsets(problem);
  const std::vector<NearTargets> near =
      find_near_targets(placed, all_nodes(problem), Targets::own_nodes, 1e-14);
  const Eigen::MatrixXd trapezoid = double_layer_matrix(curves_of(problem));
  for (std::size_t k = 0; k < placed.size(); ++k) {
    const Curve& curve = placed[k].curve();
    const auto& cauchy = *std::get<std::shared_ptr<const CauchyCurve>>(placed[k].scheme);
    const Eigen::Index n = curve.size();
    Eigen::MatrixXd rows = cauchy.velocity_rows(near[k].local);
    for (std::size_t i = 0; i < near[k].index.size(); ++i) {
      rows.middleRows(2 * static_cast<Eigen::Index>(i), 2) -=
          trapezoid.block(2 * near[k].index[i], 2 * offsets[k], 2, 2 * n);
    }
    if (problem.components[k].kind != ComponentKind::enclosing_wall) {
      const RigidModeMatrices rigid = rigid_mode_matrices(curve, 0.0);
      rows -= (rows * rigid.modes).eval() * rigid.projection;
    }
    for (std::size_t i = 0; i < near[k].index.size(); ++i) {
      system.matrix.block(2 * near[k].index[i], 2 * offsets[k], 2, 2 * n) +=
          rows.middleRows(2 * static_cast<Eigen::Index>(i), 2);
    }
  }
}

/// Solves a problem by a dense factorisation, with close evaluation between its components.
inline SolvedFlow solve_flow(const StokesProblem& problem) {
  const std::vector<PlacedCurve> placed = cauchy_curves(problem);
  DenseSystem system = assemble_bounded(problem, ClosureForm::reduced);
  add_near_correction(system, problem, placed);
  const Eigen::VectorXd density = solve(system);
  return SolvedFlow(problem, placed, deinterleaved(density));
}

}  // namespace stokesbook::test
