#pragma once

#include <Eigen/Core>

#include "closure/problem.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup null_space
/// @{

/// Applies the null-space fix of an enclosing wall to its own density,
/// \f$ N_0\eta(x) = -\frac{1}{|\Gamma_0|}\, n(x) \int_{\Gamma_0} n\cdot\eta\,ds \f$.
///
/// Double layers carry no net flux through the boundary:
/// \f$ \int_{\partial\Omega} n\cdot(-\frac12+D)\eta\,ds = 0 \f$, so \f$ -\frac12 + D \f$ misses one
/// dimension of boundary data: it is singular, with the left null vector \f$ n\,ds \f$. N_0 puts
/// that eigenvalue at -1 whatever the length of the wall, and moves no other.
/// @param  wall     the enclosing wall
/// @param  density  at its nodes, length / time
/// @return          velocities at its nodes, length / time
/// @par Accuracy    that of the rule: geometric in N, @ref claim_04_4
/// @par Cost        O(N)
/// @par Not for     inner walls and bodies, whose flux the wall's fix balances
ComplexVector null_space_velocity(const Curve& wall, const ComplexVector& density);

/// Assembles the matrix of null_space_velocity().
///
/// @param  wall  the enclosing wall, N nodes
/// @return       2N x 2N, of rank 1, dimensionless; vectors are interleaved (x_0, y_0, ...)
/// @par Cost     4 N^2 entries
Eigen::MatrixXd null_space_matrix(const Curve& wall);

/// Computes the net flux of the prescribed velocities out of the fluid,
/// \f$ Q = \int_{\partial\Omega} g\cdot n\,ds \f$.
///
/// Rigid bodies carry none. An incompressible fluid needs Q = 0 where a wall encloses it; otherwise
/// the system solves for \f$ g - nQ/|\Gamma_0| \f$ on the wall without a sign of trouble.
/// @param  problem  velocities of its prescribed components and walls
/// @return          flux, length^2 / time
/// @par Accuracy    that of the rule: geometric in the nodes, @ref claim_04_18
double net_flux(const StokesProblem& problem);

/// Computes the size that net_flux() is to be compared with, \f$ \int_{\partial\Omega} |g|\,ds \f$.
///
/// @param  problem  velocities of its prescribed components and walls
/// @return          length^2 / time, >= |net_flux()|
double flux_scale(const StokesProblem& problem);

/// @}

}  // namespace stokesbook
