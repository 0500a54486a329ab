#pragma once

#include <optional>

#include "suspension/system/linear_system.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Measures by how much two solutions of one problem differ, as errors are reported: velocities and
/// \f$ a\omega \f$ of free bodies, with a the root mean square radius, relative to the scale of
/// velocities; and the loads on prescribed components, force by \f$ 4\pi\mu \f$ and torque by
/// \f$ 4\pi\mu a \f$, relative to that scale or to the largest load, which is larger near contact.
///
/// @param  problem  its components
/// @param  p        motions and loads of one solution
/// @param  q        of the other
/// @param  scale    of velocities, > 0, length / time
/// @return          largest difference, dimensionless; none where an enclosing wall is all there is
std::optional<double> relative_change(const StokesProblem& problem, const Completion& p,
                                      const Completion& q, double scale);

/// How wrong a solution is, and what it took to know.
struct ErrorEstimate {
  double error = 0.0;  ///< of motions and loads, as relative_change() measures them
  int matvecs = 0;     ///< applications of the fine operator
};

/// Estimates the error of a solution's motions and loads by a correction on finer nodes.
///
/// The density is interpolated to the finer nodes, and the system there solved for the correction
/// that its residual asks for. The estimate is twice the relative_change() by it; where there are
/// neither motions nor loads, twice the change of the density. The error of the iteration is part
/// of the residual.
///
/// The residual r is as large as the density's tail, motions err by its square only; and what the
/// iteration left, a residual \f$ r_0 \f$, can be large in motions where the system is
/// ill-conditioned. So the correction is solved to a residual of the lesser of
/// \f$ 100\,|r|^2/|b| \f$ and \f$ 0.1\,|r_0| \f$: the less there is to find, the closer one has
/// to look.
/// @param  coarse    the system that was solved, whose preconditioner serves the fine one too
/// @param  solution  of it, by solve()
/// @param  fine      the same problem at a quarter more nodes or so, each component's parameter the
///                   same; it needs no preconditioner
/// @param  scale     of velocities, > 0, length / time
/// @return           the estimate
/// @throws SolverError as solve() does
/// @par Accuracy  within a factor 10 of the error in 95 of 100 scenes, @ref claim_12_1; never less
/// than a thirtieth of it, @ref claim_12_2
/// @par Cost      about as many iterations of GMRES as the solution took, with a quarter more nodes
ErrorEstimate estimate_error(const LinearSystem& coarse, const GmresResult& solution,
                             const LinearSystem& fine, double scale);

/// @}

}  // namespace stokesbook
