#pragma once

#include <vector>

#include <Eigen/Core>

#include "closure/rigid_modes.hpp"
#include "krylov/block_diagonal.hpp"

namespace stokesbook {

/// Returns the gauge length \f$ \ell \f$ of the Stokeslets with which bodies are held in clusters:
/// a hundred times the largest radius of gyration a of all inner components.
///
/// A cluster of radius R that moves as a whole at the velocity U exerts the force
/// \f$ 4\pi\mu U/(\log\frac\ell R + \frac12) \f$. With the own gauges \f$ \sqrt e\,a \f$ of the
/// bodies, the force would be infinite for R = e a, and have the wrong sign for larger clusters.
double held_gauge(const StokesProblem& problem);

/// The ways in which clusters treat free bodies.
enum class ClusterForm {
  mobility,   ///< free bodies stay free
  resistance  ///< free bodies are held, then released together by a resistance problem
};

/// Assembles a component's own block in clusters: the self_block() of a free body in the mobility
/// form and of an enclosing wall; for any other inner component the self_block() of a prescribed
/// component with the gauge of held_gauge().
Eigen::MatrixXd cluster_block(Component component, ClusterForm form, double gauge);

/// The blocks of the system between different components, as preconditioners assemble them.
class CouplingBlocks {
 public:
  /// Prepares the blocks of a problem, which must outlive this object.
  ///
  /// @param  form   whether free bodies are held
  /// @param  layer  double layer of any component at nodes of others
  CouplingBlocks(const StokesProblem& problem, ClusterForm form, LayerBlock layer);

  /// Assembles \f$ D(I-P) \f$ of a source at nodes of other components, and the flows \f$ S\Pi \f$
  /// of the source's loads if the source is held (13.4).
  Eigen::MatrixXd operator()(const ComplexVector& targets, std::size_t source) const;

  /// Assembles the block at all nodes of one other component.
  Eigen::MatrixXd operator()(std::size_t target, std::size_t source) const {
    return (*this)(problem_.components[target].curve.x, source);
  }

  /// Returns the rigid motions of an inner component.
  const RigidModeMatrices& modes(std::size_t component) const { return modes_[component]; }

  /// Returns whether a component is held: its loads follow from its density.
  bool is_held(std::size_t component) const;

 private:
  const StokesProblem& problem_;
  ClusterForm form_;
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
