#pragma once

#include <vector>

#include <Eigen/Core>

#include "closure/rigid_modes.hpp"
#include "krylov/block_diagonal.hpp"

namespace stokesbook {

/// The blocks of the system between different components, as preconditioners assemble them.
class CouplingBlocks {
 public:
  /// @param  held   one per component: whether its loads follow from its density; free bodies and
  ///                walls that enclose the fluid are not held
  /// @param  gauge  gauge length of the Stokeslets of held components, length
  /// @param  layer  double layer between any two components
  CouplingBlocks(const StokesProblem& problem, std::vector<bool> held, double gauge,
                 LayerBlock layer);

  /// Assembles \f$ D(I-P) \f$ at the nodes of a target, and the flows \f$ S\Pi \f$ of the source's
  /// loads if the source is held (13.4).
  Eigen::MatrixXd operator()(std::size_t target, std::size_t source) const;

  /// Returns the rigid motions of an inner component.
  const RigidModeMatrices& modes(std::size_t component) const { return modes_[component]; }

  /// Returns whether a component is held.
  bool is_held(std::size_t component) const { return held_[component]; }

 private:
  const StokesProblem& problem_;  // outlives this object
  std::vector<bool> held_;
  double gauge_;
  LayerBlock layer_;
  std::vector<RigidModeMatrices> modes_;
};

/// Multiplies columns of 2N numbers by the inverse of a component's own block, in the frame of the
/// plane.
Eigen::MatrixXd solved_alone(const BlockDiagonalPreconditioner::Member& member,
                             const Eigen::MatrixXd& columns);

/// Multiplies rows of 2N numbers by the inverse of a component's own block, in the frame of the
/// plane.
Eigen::MatrixXd times_inverse(const Eigen::MatrixXd& rows,
                              const BlockDiagonalPreconditioner::Member& member);

}  // namespace stokesbook
