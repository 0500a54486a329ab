#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "krylov/block_diagonal.hpp"
#include "preconditioning/compact_matrix.hpp"

namespace stokesbook {

struct ReducedGroup;
struct ReducedLevel;

/// How much a HierarchicalPreconditioner leaves out. The defaults suit random packings of up to 500
/// components with few contacts.
struct HierarchySettings {
  double tolerance = 0.6;  ///< tau of single components, and of arcs of walls
  /// tau of groups of four; that of larger groups falls by 0.6 from level to level, down to 0.06.
  /// Below 0.05 rounding in single precision shows.
  double group_tolerance = 0.3;
  /// Couplings of groups at larger distances of their centres, over the sum of their radii, are
  /// expansions; > 1.
  double reach = 1.2;
  int order = 12;            ///< of these expansions
  Eigen::Index root = 1500;  ///< a level with at most as many unknowns is inverted as a whole
};

/// Preconditions by eliminating all components in a tree of groups.
///
/// Let the operator be \f$ (I+B)A_0 \f$ as for clusters, where \f$ A_0 \f$ consists of the own
/// blocks, and let the columns of Q span the directions in which components are coupled:
/// \f$ (I+B)^{-1} \approx I - QQ^T + Q\,C^{-1}Q^T \f$ with \f$ C = I+Q^TBQ \f$ (13.7). The small
/// system C couples all components. Let T be its blocks of groups of four. Then
/// \f$ C = (I+B')T \f$ with \f$ B' = (C-T)T^{-1} \f$, and (13.7) replaces the inverse of
/// \f$ I+B' \f$ in its turn, with the few directions in which groups are coupled (13.8). The last
/// system is inverted. Nothing is left out because it is far away: distant groups are coupled by
/// multipole expansions.
/// @par Accuracy  iterations for random packings of disks, @ref claim_13_11, and in
/// containers, @ref claim_13_13
/// @par Not for   crystals with tight contacts, which form a stiff network: clusters take far fewer
/// iterations
class HierarchicalPreconditioner {
 public:
  /// Eliminates all components. An enclosing wall is cut into arcs, which are eliminated like
  /// bodies, see boundary_pieces().
  ///
  /// @param  problem  components in the order of the densities, n nodes in all
  /// @param  alone    inverse of the self_block() of each inner component, held ones with the gauge
  ///                  of held_gauge(), and its orientation; those of walls are not read
  /// @param  layer    double layer of any component at nodes of others
  /// @throws std::domain_error when the matrix of a group is singular to rounding
  /// @par Cost  groups of m components have O(m^(1/2)) directions: O(n^(3/2)) operations, and
  /// O(n log n) numbers, 2 bytes each
  HierarchicalPreconditioner(const StokesProblem& problem,
                             std::vector<BlockDiagonalPreconditioner::Member> alone,
                             const LayerBlock& layer, const HierarchySettings& settings = {});

  /// Applies the approximate inverse, a linear map, to 2n interleaved numbers (x_0, y_0, ...). The
  /// result is the same for any number of threads.
  ///
  /// @par Cost  reads all bytes() once
  Eigen::VectorXd operator()(const Eigen::VectorXd& v) const;

  /// Returns the memory of the groups and of the last inverse, bytes.
  Eigen::Index bytes() const;

 private:
  // A group, or a component on the lowest level, with the directions that couple it to all others.
  struct Group {
    Eigen::Index first;            // its first unknown among those of its level
    Eigen::Index first_direction;  // its first direction among those of its level
    CompactMatrix basis;           // Q
    CompactMatrix inverse;         // T^{-1}; no rows and columns where it is the identity
  };

  // A component, or an arc of an enclosing wall, of the lowest level.
  struct Single {
    Eigen::Index first;                            // its first unknown in the problem
    std::shared_ptr<const CompactMatrix> inverse;  // of its own block, in its frame
    double orientation;
  };

  // Adds a level; returns its groups.
  std::vector<ReducedGroup> keep(ReducedLevel level);

  std::vector<Single> singles_;             // in the order of the tree
  std::vector<std::vector<Group>> levels_;  // components, then larger and larger groups
  CompactMatrix root_;                      // inverse of the last level
};

}  // namespace stokesbook
