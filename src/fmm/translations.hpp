#pragma once

#include <span>
#include <vector>

#include "fmm/expansions.hpp"

namespace stokesbook {

/// Translates expansions of one order from box to box.
///
/// Every translation consists of a diagonal scaling, a matrix of binomial coefficients that is the
/// same for all pairs of boxes, and another diagonal scaling. The scalings are powers of radius
/// over distance. A bidiagonal term then refers \f$ \psi_c \f$ to the new centre (08.11).
class Translations {
 public:
  /// Highest order that is possible.
  static constexpr int most_order = 60;

  /// Tabulates the binomial coefficients up to the order p.
  /// @throws std::invalid_argument when the order is not from 1 to most_order
  explicit Translations(int order);

  int order() const { return order_; }  ///< returns the order p, the highest power

  /// M2M: adds a multipole expansion, moved to the centre of another box `to`, which contains
  /// `from` (08.12).
  ///
  /// @par Cost  2 p^2 real multiplications
  void m2m(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
           Eigen::Ref<Expansion> sum) const;

  /// L2L: adds a local expansion, moved to the centre of another box `to`, which `from` contains
  /// (08.13). The cost is that of m2m().
  void l2l(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
           Eigen::Ref<Expansion> sum) const;

  /// M2L: adds the multipole expansions of many boxes, converted to a local expansion.
  ///
  /// With \f$ D = c_t - c_s \f$: \f$ \lambda_l = (-R_t/D)^l\sum_{k\ge0} H_{lk}(R_s/D)^kA_k \f$ with
  /// \f$ H_{lk} = \binom{k+l-1}{l} \f$ (08.10) and \f$ H_{l0} = -\frac1l \f$. In addition
  /// \f$ \lambda_0 \f$ contains \f$ A_0\log D \f$.
  /// @param  boxes      all boxes of the sources' tree
  /// @param  multipole  multipole expansions of all boxes
  /// @param  list       indices of the boxes to be converted, well separated from the target
  /// @par Accuracy  relative error \f$ p\rho^p \f$ of the velocity (08.9), where \f$ \rho \f$ is
  ///                the radius of one disk over the distance of its centre from the other disk,
  ///                @ref claim_08_2
  /// @par Cost      4 p^2 real multiplications per source box, as many boxes at a time as a
  ///                register has lanes
  void m2l(const std::vector<Box>& boxes, const Expansions& multipole,
           std::span<const Eigen::Index> list, Eigen::Index field, const Box& target,
           Eigen::Ref<Expansion> sum) const;

  /// Assembles m2l() of one source box as a matrix of 4(p + 1) rows and columns, which acts on the
  /// coefficients of an Expansion, column by column.
  ///
  /// @par Cost  16 (p + 1)^2 numbers
  Eigen::MatrixXd m2l_matrix(const Box& from, const Box& to) const;

 private:
  using Matrix = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  int order_;
  Matrix binomial_;  // row n, column k, n <= p
  Matrix m2l_;       // H, row l, column k
};

}  // namespace stokesbook
