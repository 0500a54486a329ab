#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "closure/problem.hpp"

namespace stokesbook {

/// @addtogroup krylov
/// @{

/// Assembles a component's own block of the reduced system, with N_0 on an enclosing wall.
///
/// The block turns with the component: \f$ A = Q \hat A Q^T \f$ with the rotation Q of every node
/// vector. With the component's own gauge it does not depend on its size.
/// @param  component  curve in any frame, centre in the same
/// @param  gauge      Stokeslet gauge length of a prescribed component; none: its own,
///   \f$ \sqrt e\, a \f$
/// @return            2N x 2N, dimensionless; vectors are interleaved (x_0, y_0, ...)
/// @par Cost            O(N^3) multiplications
/// @par Not for         a gauge near the degenerate scale of a prescribed component,
///   \f$ a/\sqrt e \f$ for a circle: the block is singular there
Eigen::MatrixXd self_block(const Component& component, std::optional<double> gauge = {});

/// Assembles a component's own layer: \f$ -\frac12 + D \f$, with N_0 on an enclosing wall.
///
/// @param  component  curve in any frame
/// @return            2N x 2N, dimensionless, interleaved
/// @par Cost          N^2 kernel evaluations
Eigen::MatrixXd own_layer(const Component& component);

/// The inverse of the diagonal blocks: solves every component alone.
///
/// Blocks are inverted once per distinct reference (shape, node count, kind) and shared by all
/// components of it; each application turns a component's vector into the reference frame and back.
class BlockDiagonalPreconditioner {
 public:
  /// One component: its reference's inverse self block, 2N x 2N, and how it is turned.
  struct Member {
    std::shared_ptr<const Eigen::MatrixXd> inverse;  ///< by invert_block()
    double orientation = 0.0;  ///< radians, counter-clockwise, against the reference
  };

  /// Groups the components that share a block.
  ///
  /// @param  members  components in the order of the densities, n nodes in all
  explicit BlockDiagonalPreconditioner(std::vector<Member> members);

  /// Applies the inverse blocks.
  ///
  /// @param  v  2n numbers, interleaved (x_0, y_0, x_1, y_1, ...)
  /// @return    2n numbers, ordered as v, unit of v
  /// @par Cost  4 N^2 multiplications a component, as matrix products over all components of a
  /// block
  Eigen::VectorXd operator()(const Eigen::VectorXd& v) const;

 private:
  std::vector<Member> members_;
  std::vector<Eigen::Index> offsets_;            // first node of each member
  std::vector<std::vector<std::size_t>> users_;  // members that share a block
};

/// Inverts a self block by LU factorisation.
///
/// @param  block  from self_block()
/// @return        its inverse, of the same size
/// @throws std::domain_error when the block is numerically singular: a reciprocal condition number
///                below 1e-14
/// @par Cost      O(N^3) multiplications
Eigen::MatrixXd invert_block(const Eigen::MatrixXd& block);

/// @}

}  // namespace stokesbook
