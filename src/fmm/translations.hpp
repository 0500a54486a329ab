#pragma once

#include <span>
#include <vector>

#include "fmm/expansions.hpp"

namespace stokesbook {

/// @addtogroup fmm
/// @{

/// The translations of expansions of one order.
///
/// Every translation is a matrix of binomial coefficients, the same for all, between two diagonal
/// scalings by powers of the distance; then \f$ \psi \f$ follows the centre of \f$ \phi \f$.
class Translations {
 public:
  /// Highest order.
  static constexpr int most_order = 60;

  /// Tabulates the binomial coefficients.
  /// @param  order  p, highest power
  /// @throws std::invalid_argument when it is not from 1 to most_order
  explicit Translations(int order);

  /// Returns the order.
  /// @return p
  int order() const { return order_; }

  /// M2M: adds a multipole expansion, moved to another centre.
  ///
  /// @param  from       box of the expansion
  /// @param  expansion  4 x (p + 1)
  /// @param  to         box that contains it
  /// @param  sum        4 x (p + 1), of that box, to which is added
  /// @par Cost          2 p^2 real multiplications
  void m2m(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
           Eigen::Ref<Expansion> sum) const;

  /// L2L: adds a local expansion, moved to another centre.
  ///
  /// @param  from       box of the expansion
  /// @param  expansion  4 x (p + 1)
  /// @param  to         box that it contains
  /// @param  sum        4 x (p + 1), of that box, to which is added
  /// @par Cost          2 p^2 real multiplications
  void l2l(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
           Eigen::Ref<Expansion> sum) const;

  /// M2L: adds the local expansion of the multipole expansions of many boxes.
  ///
  /// With \f$ D = c_t - c_s \f$: \f$ \lambda_l = (-R_t/D)^l\sum_{k\ge0} H_{lk}(R_s/D)^kA_k \f$ with
  /// \f$ H_{lk} = \binom{k+l-1}{l} \f$ and \f$ H_{l0} = -\frac1l \f$, and
  /// \f$ \lambda_0 \f$ has \f$ A_0\log D \f$ more.
  /// @param  boxes     all boxes of the sources' tree
  /// @param  multipole  their multipole expansions
  /// @param  list      indices of those that are well separated from the target
  /// @param  field     index of the field
  /// @param  target    box of the targets
  /// @param  sum       4 x (p + 1), to which is added
  /// @par Accuracy     leaves out \f$ p\rho^p \f$ of a velocity at the ratio \f$ \rho \f$ of a
  ///                   radius to the distance of the other disk, @ref claim_08_2
  /// @par Cost         4 p^2 real multiplications a source box, as many boxes at a time as a
  ///                   register has lanes
  void m2l(const std::vector<Box>& boxes, const Expansions& multipole,
           std::span<const Eigen::Index> list, Eigen::Index field, const Box& target,
           Eigen::Ref<Expansion> sum) const;

 private:
  double binomial(int n, int k) const;

  int order_;
  std::vector<double> pascal_;  // binomial(n, k), row n, column k, n <= p
  std::vector<double> m2l_;     // H, row l, column k
};

/// @}

}  // namespace stokesbook
