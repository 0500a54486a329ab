#pragma once

#include <optional>

#include "suspension/system/linear_system.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Measures by how much two solutions of one problem differ, in the units in which errors are
/// reported.
///
/// The differences are those of the velocities and of \f$ a\omega \f$ of free bodies, with the root
/// mean square radius a, relative to the scale of velocities; and those of the loads on prescribed
/// components. Forces are divided by \f$ 4\pi\mu \f$, and torques by \f$ 4\pi\mu a \f$. Their
/// differences are relative to the scale of velocities, or to the largest load in these units if it
/// is larger, as near contact.
/// @param  problem  problem with its components
/// @param  p        motions and loads of one solution
/// @param  q        motions and loads of the other solution
/// @param  scale    of velocities, > 0, length / time
/// @return          largest difference, dimensionless; none if there is no component but an
///                  enclosing wall
std::optional<double> relative_change(const StokesProblem& problem, const Completion& p,
                                      const Completion& q, double scale);

/// The estimated error of a solution, and the cost of the estimate.
struct ErrorEstimate {
  double error = 0.0;  ///< of motions and loads, as relative_change() measures them
  int matvecs = 0;     ///< applications of the fine operator
};

/// Estimates the error of a solution's motions and loads by a correction on finer nodes.
///
/// The density is interpolated to the finer nodes, where it leaves a residual r. The system on the
/// finer nodes is solved for the correction of r. The estimate is twice the relative_change() by
/// this correction; if there are neither motions nor loads, the estimate is twice the largest
/// change of the density over the scale. The estimate includes the error of the GMRES iteration,
/// which contributes to the residual.
///
/// The residual r is as large as the tail of the density, but the error of the motions is quadratic
/// in the tail. The residual \f$ r_0 \f$ that the iteration left may cause large errors of the
/// motions if the system is ill-conditioned. The correction is therefore solved to a residual of
/// the lesser of \f$ 100\,|r|^2/|b| \f$ and \f$ 0.1\,|r_0| \f$, but not below
/// \f$ 10^{-8}|r| \f$ nor above \f$ 0.03\,|r| \f$.
/// @param  coarse    the system that was solved; its preconditioner is also used for the fine one
/// @param  solution  of the coarse system, by solve()
/// @param  fine      the same problem with about a quarter more nodes, equidistant in the same
///                   parameter of each component; no preconditioner is required
/// @param  scale     of velocities, > 0, length / time
/// @return           the estimate
/// @throws SolverError as solve() does
/// @par Accuracy  within a factor 10 of the error in 95 of 100 scenes, @ref claim_12_1; never less
/// than a thirtieth of the error, @ref claim_12_2
/// @par Cost      about as many iterations of GMRES as the solution took, with a quarter more nodes
ErrorEstimate estimate_error(const LinearSystem& coarse, const GmresResult& solution,
                             const LinearSystem& fine, double scale);

/// @}

}  // namespace stokesbook
