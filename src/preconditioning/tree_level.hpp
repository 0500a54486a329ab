#pragma once

#include <vector>

#include <Eigen/Core>

#include "fmm/quadtree.hpp"
#include "preconditioning/boundary_pieces.hpp"
#include "preconditioning/compact_matrix.hpp"
#include "preconditioning/coupling_blocks.hpp"
#include "preconditioning/far_field.hpp"

namespace stokesbook {

/// A group of one level of a HierarchicalPreconditioner without its interior: what the level above
/// needs to know of it.
struct ReducedGroup {
  Box disk;                                ///< a disk about its components
  Eigen::MatrixXf outgoing;                ///< multipole expansions of its directions
  Eigen::MatrixXf incoming;                ///< components of local expansions along its directions
  std::vector<Eigen::Index> near;          ///< near_groups() of the same level
  std::vector<Eigen::MatrixXf> couplings;  ///< blocks of the next C from each of these

  Eigen::Index width() const { return incoming.rows(); }  ///< returns the number of directions

  /// Returns the coupling from a near group, or a null pointer for other groups.
  const Eigen::MatrixXf* coupling(Eigen::Index source) const;
};

/// The groups of one level.
struct ReducedLevel {
  /// Makes room for a number of groups.
  explicit ReducedLevel(std::size_t count) : groups(count), inverses(count) {}

  std::vector<ReducedGroup> groups;     ///< without their interiors
  std::vector<CompactMatrix> bases;     ///< Q of each group
  std::vector<CompactMatrix> inverses;  ///< \f$ T^{-1} \f$; empty where it is the identity
};

/// How the groups of a level are reduced.
struct LevelSettings {
  double tolerance;  ///< tau: weaker couplings are left out
  double reach;      ///< see HierarchySettings
  bool is_large;     ///< whether memory counts more than time
};

/// Chooses the directions of single pieces, the lowest level of a tree: T is the identity.
///
/// @param  pieces  pieces of the problem's boundary in the order of the tree
/// @param  disks   disks about them
/// @param  layer   double layer of any component at nodes of others
/// @par Memory     of a large problem, only the products of blocks and directions are kept: the
///                 blocks are assembled twice
ReducedLevel reduce_pieces(const StokesProblem& problem, const std::vector<BoundaryPiece>& pieces,
                           const std::vector<Box>& disks, const LayerBlock& layer,
                           const FarField& far_field, const LevelSettings& settings);

/// Chooses the directions of groups of reduced groups. Frees the couplings of the children as
/// soon as they have been used.
///
/// @throws std::domain_error when T of a group is singular to rounding
ReducedLevel reduce_groups(const std::vector<Box>& groups, std::vector<ReducedGroup>& children,
                           const FarField& far_field, const LevelSettings& settings);

/// Assembles the system that couples all groups of a level.
Eigen::MatrixXf coupled_system(const std::vector<ReducedGroup>& groups, const FarField& far_field);

/// Rounds the matrices of a level one by one, and frees each.
///
/// @throws std::domain_error when a number is not finite
std::vector<CompactMatrix> rounded(std::vector<Eigen::MatrixXf>&& matrices, bool is_large);

}  // namespace stokesbook
