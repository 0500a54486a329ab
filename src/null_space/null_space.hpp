#pragma once

#include <Eigen/Core>

#include "closure/problem.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

/// Applies the null-space fix (04.6) of an enclosing wall to the density on the wall,
/// \f$ N_0\eta(x) = -\frac{1}{|\Gamma_0|}\, n(x) \int_{\Gamma_0} n\cdot\eta\,ds \f$.
///
/// Double layers carry no net flux through the boundary:
/// \f$ \int_{\partial\Omega} n\cdot(-\frac12+D)\eta\,ds = 0 \f$ (04.3). The operator
/// \f$ -\frac12 + D \f$ is therefore singular. N_0 moves the eigenvalue 0 to -1, whatever the
/// length of the wall, and leaves all other eigenvalues where they are.
/// @par Accuracy  that of the rule: geometric in N, @ref claim_04_4
/// @par Not for   inner walls and bodies: the fix on the enclosing wall balances their flux
ComplexVector null_space_velocity(const Curve& wall, const ComplexVector& density);

/// Assembles the matrix of null_space_velocity(): 2N x 2N, of rank 1, dimensionless, interleaved.
Eigen::MatrixXd null_space_matrix(const Curve& wall);

/// Computes the net flux of the prescribed velocities and slips out of the fluid,
/// \f$ Q = \int_{\partial\Omega} g\cdot n\,ds \f$ (04.2).
///
/// The motions of rigid bodies carry no flux. An incompressible fluid inside an enclosing wall
/// requires Q = 0. Otherwise the system with N_0 is solved for the data \f$ g - nQ/|\Gamma_0| \f$
/// on the wall, and nothing in its solution shows that (04.7).
/// @par Accuracy  that of the rule: geometric in the number of nodes, @ref claim_04_18
double net_flux(const StokesProblem& problem);

/// Computes \f$ \int_{\partial\Omega} |g|\,ds \ge |Q| \f$, a scale to which net_flux() can be
/// compared.
double flux_scale(const StokesProblem& problem);

}  // namespace stokesbook
