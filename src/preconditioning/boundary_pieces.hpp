#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "closure/problem.hpp"
#include "fmm/quadtree.hpp"
#include "krylov/block_diagonal.hpp"

namespace stokesbook {

/// A piece of the boundary that a HierarchicalPreconditioner does not divide: an inner component, or
/// an arc of an enclosing wall.
struct BoundaryPiece {
  std::size_t component = 0;  ///< number of the component
  Eigen::Index first = 0;     ///< its first node among those of the component
  Curve curve;                ///< its nodes; the weights of an arc are those of the wall
  Box disk;                   ///< centre and radius of a disk about it
  std::shared_ptr<const Eigen::MatrixXf> inverse;  ///< of its own block, in its own frame
  double orientation = 0.0;                        ///< of this frame, radians
  /// The block of N_0 (04.6) from one arc to another is the flow of the latter times the transposed
  /// flux of the former. Inner components have neither.
  Eigen::VectorXf flow_of_flux;
  Eigen::VectorXf flux_of_density;  ///< see flow_of_flux

  bool is_arc() const { return flow_of_flux.size() > 0; }  ///< returns whether it is part of a wall
};

/// Lists inner components, and arcs of 16 nodes or fewer of enclosing walls.
///
/// @param  alone  inverse of the own block of each inner component, and its orientation; those of
///                walls are not read
/// @throws std::domain_error as invert_block() does
std::vector<BoundaryPiece> boundary_pieces(
    const StokesProblem& problem, const std::vector<BlockDiagonalPreconditioner::Member>& alone);

}  // namespace stokesbook
