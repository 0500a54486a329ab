#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "closure/closure.hpp"

namespace stokesbook {

/// Assembles a component's own block of the reduced system (03.11), with N_0 (04.6) on an enclosing
/// wall.
///
/// The block turns with the component: \f$ A = Q \hat A Q^T \f$ with the rotation Q of every node
/// vector (05.11). With the component's own gauge, the block does not depend on its size.
/// @param  gauge  Stokeslet gauge length of a prescribed component; if empty, its own gauge
///                \f$ \sqrt e\, a \f$
/// @return        2N x 2N, dimensionless; vectors are interleaved (x_0, y_0, ...)
/// @par Cost      N^2 kernel evaluations, O(N^2) multiplications
/// @par Not for   a gauge near the degenerate scale of a prescribed component,
/// \f$ a/\sqrt e \f$ for a circle: the block is singular there
Eigen::MatrixXd self_block(const Component& component, std::optional<double> gauge = {});

/// Assembles a component's own layer: \f$ -\frac12 + D \f$, with N_0 on an enclosing wall, 2N x 2N,
/// dimensionless, interleaved.
Eigen::MatrixXd own_layer(const Component& component);

/// Evaluates C K, the velocities that a closure C adds for the rigid motions of a component: the
/// closure depends on a density only through the rigid motions in the density.
///
/// @param  modes  K of the component, 2N x 3
/// @param  first  position of the component's first node among all n nodes
/// @return        2n x 3, dimensionless
/// @par Cost      three times that of Closure::velocity()
Eigen::MatrixXd closed_modes(const Closure& closure, const Eigen::MatrixXd& modes,
                             Eigen::Index first, Eigen::Index n);

/// A function, called by several threads at once, that assembles the double layer of one component
/// at m nodes of others: 2m x 2N, dimensionless, interleaved, in the frame of the plane.
using LayerBlock = std::function<Eigen::MatrixXd(const ComplexVector& targets, std::size_t source)>;

/// The inverse of the diagonal blocks (05.10): solves for every component as if it were alone.
///
/// A block is inverted once for each reference (distinct shape, number of nodes and kind), and all
/// components of this reference share the inverse. Each application turns the vector of a component
/// into the frame of the reference and back (05.11).
class BlockDiagonalPreconditioner {
 public:
  /// One component.
  struct Member {
    /// Inverse of its self block. Null: that of \f$ -\frac12 \f$, as which the block of a circular
    /// wall acts on all but a few modes.
    std::shared_ptr<const Eigen::MatrixXd> inverse;
    double orientation = 0.0;  ///< radians, counter-clockwise, relative to the reference
    Eigen::Index n_nodes = 0;  ///< number of nodes N; read only if there is no inverse
  };

  /// Groups the components that share a block. The members are in the order of the densities and
  /// have n nodes in all.
  explicit BlockDiagonalPreconditioner(std::vector<Member> members);

  /// Applies the inverse blocks to 2n interleaved numbers (x_0, y_0, x_1, y_1, ...).
  ///
  /// @par Cost  4 N^2 multiplications per component, as products of a block with the vectors of all
  /// its components
  Eigen::VectorXd operator()(const Eigen::VectorXd& v) const;

 private:
  std::vector<Member> members_;
  std::vector<Eigen::Index> offsets_;            // first node of each member
  std::vector<std::vector<std::size_t>> users_;  // members that share a block
};

/// Inverts a self block by LU factorisation, by O(N^3) multiplications.
///
/// @throws std::domain_error when the block is numerically singular: a reciprocal condition number
///         below 1e-14
Eigen::MatrixXd invert_block(const Eigen::MatrixXd& block);

}  // namespace stokesbook
