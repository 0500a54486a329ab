#pragma once

#include <vector>

#include "fmm/expansions.hpp"
#include "fmm/fmm.hpp"
#include "periodic/far_sums.hpp"
#include "periodic/lattice.hpp"

namespace stokesbook {

/// The flow of all far images of the sources in a disk, as a map from the multipole expansion of
/// the sources to the local expansion of that flow, both about the centre of the disk.
///
/// With scaled coefficients, the sums of far_sums(), and \f$ H_{lk} = \binom{k+l-1}{l} \f$:
/// \f[ \lambda_l = \sum_{k\ge1}(-1)^kH_{lk}S_{k+l}A_k - \frac{S_l}{l}A_0, \f]
/// \f[ \mu_l = \sum_{k\ge1}(-1)^kH_{lk}\bigl[S_{k+l}B_k - (k+l)T_{k+l+1}A_k\bigr]
///     - \frac{S_l}{l}B_0 + T_{l+1}A_0. \f]
/// The sums over disks that define \f$ S_2, T_1 \f$ and \f$ T_3 \f$ leave a flow that is not
/// periodic. With \f$ v = \pi R^2/V \f$, these terms make it periodic:
/// \f[ \mu_1 \mathrel{+}= v\bar A_1,\quad \lambda_1 \mathrel{+}= -\tfrac i2v\,\mathrm{Im}B_1,\quad
///     \lambda_2 \mathrel{+}= \tfrac v2\bar A_0. \f]
/// Two terms set the mean velocity over the cell to zero, where the double layer of a rigid motion
/// counts as that motion inside its body:
/// \f[ \lambda_0 \mathrel{+}= vB_2 - 2A_0\Bigl[c_L - \tfrac12 +
///     \sum_{near}(\log|w| - \tfrac12)\Bigr]. \f]
///
/// The velocity of near images and far images is periodic if the net source of the double layer,
/// \f$ \sum w\,n\cdot\eta \f$, is zero. Otherwise it contains \f$ \frac{z-c}{2V}\sum w\,n\cdot\eta
/// \f$, because a periodic flow of an incompressible fluid has no net source. The gradient of the
/// pressure has the mean \f$ \frac1V\sum F \f$.
/// @sa source: Hasimoto, J. Fluid Mech. 5 (1959), 317
class FarOperator {
 public:
  /// Evaluates the sums over the lattice.
  ///
  /// @param  radius  R of the disk, which contains all sources and all targets, length
  /// @param  order   p of the expansions, >= 2
  /// @throws std::invalid_argument when the order is < 2
  FarOperator(const Lattice& lattice, double radius, int order);

  /// Adds the local expansion, by p^2 operations, without allocation.
  void operator()(Eigen::Ref<const Expansion> multipole, Eigen::Ref<Expansion> local) const;

 private:
  int order_;
  FarSums sums_;
  double share_;     // pi R^2 / V
  double constant_;  // bracket of lambda_0
};

/// Plans the images of a cell for an Fmm: near images one by one, and all others by a FarOperator.
///
/// The sum is \f$ \sum_w \f$ of Fmm over all lattice vectors w. Its Stokeslets have the mean zero,
/// so that no gauge length exists. All sources and targets should lie within one Voronoi cell,
/// apart from the extent of the bodies: Lattice::wrap(). They may be anywhere, but the number of
/// near images grows with the square of the distances.
///
/// With the centre c of the cell's disk, the pressure over viscosity of forces \f$ F_k \f$ at
/// \f$ c_k \f$ is that of periodic Stokeslets with the mean zero, plus the linear pressure
/// \f$ \frac1V\sum F_k\cdot(z - c) \f$, minus the constant
/// \f$ \frac{1}{2V}\sum F_k\cdot(c_k - c) \f$.
/// @par Accuracy  that of the Fmm with the same settings, @ref claim_14_6. FmmSettings with a leaf
///                size of all points sum all near images directly.
FmmImagePlan images_in(const Lattice& lattice);

}  // namespace stokesbook
