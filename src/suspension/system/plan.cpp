// Decides from the scene alone which parts of the solver are built and how accurate they are
// (chapter 12, section "System").
#include "suspension/system/plan.hpp"

#include <algorithm>

#include "fmm/fmm.hpp"
#include "suspension/bodies/components.hpp"

namespace stokesbook {

bool Plan::is_fast(Eigen::Index nodes, std::optional<Eigen::Index> targets) const {
  if (targets == 0) return false;
  if (summation != Summation::automatic) return summation == Summation::fmm;
  constexpr double rounding = 1e-14;  // rounding error of a fast sum, relative to the sum
  if (sum_tolerance < rounding) return false;
  const auto n = static_cast<double>(nodes), m = static_cast<double>(targets.value_or(0));
  const double least = static_cast<double>(break_even(FmmSettings::for_tolerance(sum_tolerance)));
  return (targets ? m * n / (m + n) : n) > least;
}

Plan make_plan(const Scene& scene) {
  const ComponentCounts counts = count_components(scene);
  const SolverSettings& solver = scene.solver;
  Plan plan;
  plan.null_space_fix = counts.outer > 0;
  plan.near_correction =
      solver.near_singular != NearSingular::off && (counts.all() > 1 || scene.cell);
  // The own block of a circle has the eigenvalues -1 and -1/2 only: its inverse saves nothing.
  const bool only_circles = counts.circles == counts.all();
  const bool local = solver.coupling == Coupling::local;
  const bool chosen_here = !local && solver.preconditioner == PreconditionerKind::automatic;
  // Blocks between components, which trees and factorisations have, lack the images of a cell.
  const bool has_blocks = chosen_here && !scene.cell;
  plan.preconditioner = local          ? PreconditionerKind::block_diagonal
                        : !chosen_here ? solver.preconditioner
                        : only_circles ? PreconditionerKind::none
                                       : PreconditionerKind::block_diagonal;
  // Below this tolerance, the rounding errors of a factorisation in the softest modes of held
  // components show in the estimates. Iterations that stop in time hardly touch these modes.
  constexpr double least_tolerance_of_direct = 1e-8;
  plan.direct_allowed =
      has_blocks && counts.all() > 1 && solver.tolerance >= least_tolerance_of_direct;
  plan.tree_allowed = has_blocks && counts.all() - counts.outer > 1;
  // A hundredth of the tolerance leaves room for the condition number. Rounding limits all
  // tolerances from below.
  plan.gmres_tolerance = solver.gmres_tol.value_or(std::max(1e-14, 0.01 * solver.tolerance));
  // With contact, the densities of films under pressure exceed the scale of velocities by orders of
  // magnitude, and so do the errors of sums. These errors are rough: taken for unresolved tails of
  // densities, they would make the node number grow without end. Sums are therefore a hundred times
  // as accurate.
  const double closer = scene.contact ? 1e-2 : 1.0;
  plan.near_tolerance = std::max(1e-15, closer * 0.01 * solver.tolerance);
  plan.summation = solver.summation;
  plan.sum_tolerance = closer * 0.1 * plan.gmres_tolerance;
  return plan;
}

}  // namespace stokesbook
