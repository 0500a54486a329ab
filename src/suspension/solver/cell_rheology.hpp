#pragma once

#include "record/run_data.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// Measures the rheology of a periodic cell with the area V.
///
/// - Mean stress: \f$ \Sigma_{ij} = \frac1V\oint\sigma_{ik}\nu_kx_j\,ds \f$ over the boundary of a
///   cell with the outward normal \f$ \nu \f$ and places x relative to the cell_centre()
///   \f$ x_0 \f$. With the places \f$ c_k \f$ of the images in the cell and the external loads of
///   the bodies,
///   \f[ \Sigma = 2\mu E + \frac1V\sum_k\Big[S_k - F_k\otimes(c_k-x_0)
///       + \frac{L_k}{2}\begin{pmatrix}0&1\\-1&0\end{pmatrix}\Big]. \f]
///   Without external forces no choice of images changes the stress. With them, the stress jumps by
///   \f$ F_k\otimes w/V \f$ where a body leaves the cell through an edge.
/// - Contact stress, the share of the forces F of contact and repulsion on a body a from the image
///   of a body b moved by w, \f$ -\frac1V\sum F\otimes(c_a-c_b-w) \f$: the mean stress includes it.
///   Contact also changes the stresslets; this part is not separate.
/// - Viscosity \f$ \Sigma:E/(2E:E) \f$; not a number without strain.
/// - Particle pressure \f$ \Pi = -\frac12\mathrm{tr}\,\Sigma - \langle p\rangle \f$ with the mean
///   pressure of the fluid in its area \f$ V_f \f$, which follows from the tractions t of the
///   bodies on the fluid by \f$ V_f\langle p\rangle = -\frac12\sum_k\oint t\cdot(x-c_k)\,ds \f$.
/// - Dissipation by traction: the same dissipation as Rheology::dissipation, from the tractions
///   instead of stresslets and loads,
///   \f[ \sum_k\oint[(u-u_\infty)\cdot t + 2\mu\,E:(u\otimes n)]\,ds. \f]
///   The second term is zero for rigid motions. The difference of the two values is a measure of
///   the error of both.
///
/// @param  stresslet  sum over all bodies, by body_stresslet(), force
/// @param  contacts   contact forces that are part of the loads of the solution
/// @par Cost          SolvedFlow::derivatives() at all nodes
/// @sa source: Batchelor, J. Fluid Mech. 41 (1970), 545
CellRheology cell_rheology(const SuspensionSolver& solver, const Solution& solution,
                           Complex stresslet, const std::vector<ContactForce>& contacts);

}  // namespace stokesbook
