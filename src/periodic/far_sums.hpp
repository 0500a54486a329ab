#pragma once

#include <vector>

#include <Eigen/Core>

#include "periodic/lattice.hpp"

namespace stokesbook {

/// Returns the lattice vectors \f$ w \ne 0 \f$ of the near images of a disk of radius R:
/// \f$ |w| < 3R \f$, each vector followed by its negative, length.
///
/// All other images of the disk are well separated from it, as the boxes of an Fmm are (08.8).
std::vector<Complex> near_images(const Lattice& lattice, double radius);

/// Sums of powers over the lattice vectors of the far images of a disk, dimensionless.
struct FarSums {
  Eigen::VectorXcd s;  ///< \f$ R^m\sum w^{-m} \f$ at index m; zero for odd m
  Eigen::VectorXcd t;  ///< \f$ R^{m-1}\sum \bar w w^{-m} \f$ at index m; zero for even m
};

/// Evaluates the sums over \f$ |w| \ge 3R \f$ for all m up to 2p + 2.
///
/// Four of these sums, \f$ S_2, T_1, T_3 \f$ and the sum of the constant 1, do not converge
/// absolutely. They have the values of a sum over growing disks.
///
/// Poisson's formula turns the smooth part of every sum into a sum over the dual lattice, which is
/// the lattice itself turned by a right angle. With \f$ x = \alpha|w|^2 \f$,
/// \f$ c = (\pi|w|/V)^2/\alpha \f$, the incomplete gamma functions
/// \f$ Q(m,x) = e^{-x}\sum_{j<m}x^j/j! \f$ and \f$ P = 1 - Q \f$, and lengths in units of R:
/// \f[ S_m = \sum_{far}\frac{Q(m,x)}{w^m} - \sum_{near}\frac{P(m,x)}{w^m}
///   + \sum\Bigl(\frac\pi V\Bigr)^{m-1}\frac{\bar w^m}{|w|^2}\frac{e^{-c}}{(m-1)!}, \f]
/// \f[ T_m = \sum_{far}\frac{\bar w Q(m,x)}{w^m} - \sum_{near}\frac{\bar w P(m,x)}{w^m}
///   + \sum\Bigl(\frac\pi V\Bigr)^{m-2}\frac{\bar w^{m+1}}{|w|^4}\frac{(1+c)e^{-c}}{(m-1)!}. \f]
/// The result does not depend on \f$ \alpha = \min(\pi/V, 2) \f$. Sums over all images minus those
/// over the near images would be useless for large m, because almost all digits cancel.
/// @param  radius  R > 0, length
/// @param  order   p >= 1
/// @par Accuracy   rounding, also after the binomials of FarOperator, @ref claim_14_1
/// @par Cost       p operations for each of some 100 vectors, for more vectors in elongated cells
FarSums far_sums(const Lattice& lattice, double radius, int order);

/// Returns the constant of a periodic logarithm that is referred to the length 1: the mean over a
/// cell of \f$ c_L + \frac{\pi}{2V}|z|^2 - \log|z| + \sum_{w\ne0}\ldots \f$ vanishes for
/// \f$ c_L = -\log(2\pi|\eta(\tau)|^2/|b_1|) \f$ with Dedekind's
/// \f$ \eta = q^{1/24}\prod(1-q^n),\ q = e^{2\pi i\tau} \f$.
double logarithm_constant(const Lattice& lattice);

}  // namespace stokesbook
