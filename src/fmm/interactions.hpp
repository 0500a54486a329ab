#pragma once

#include <span>
#include <vector>

#include "fmm/quadtree.hpp"

namespace stokesbook {

/// Consecutive points of a tree.
struct Range {
  Eigen::Index first;  ///< first of them
  Eigen::Index last;   ///< one beyond the last
};

/// Lists, one per box, in one array.
template <class Entry>
struct Lists {
  std::vector<Eigen::Index> begin;  ///< first index of each list in entries, and the end of all
  std::vector<Entry> entries;       ///< all lists after each other

  /// Returns the list of a box.
  std::span<const Entry> of(Eigen::Index box) const {
    const auto k = static_cast<std::size_t>(box);
    return {entries.data() + begin[k], entries.data() + begin[k + 1]};
  }
};

/// The interactions between the boxes of two trees.
struct Interactions {
  Lists<Eigen::Index> far;  ///< for each target box the source boxes that are converted (M2L)
  Lists<Range> near;        ///< for each target box the source points that are summed directly
};

/// Finds the interactions by a dual-tree traversal.
///
/// Boxes are well separated when \f$ R_s < \rho(|D| - R_t) \f$ and
/// \f$ R_t < \rho(|D| - R_s) \f$ with \f$ \rho = 1/2 \f$ (08.8): every expansion then falls like
/// \f$ 2^{-k} \f$. If a pair of boxes is not well separated, then the larger box is divided. Two
/// leaves are summed directly, and so is a well separated pair whose target is a leaf and whose
/// pairs of points, at most `direct_pairs`, cost less than a translation. The disk of a box contains
/// the margins of its sources, so that the expansion of a source is never used at a target within
/// the source's margin. Every pair of a target and a source is in exactly one interaction.
/// @par Cost  O(number of boxes)
Interactions find_interactions(const Quadtree& targets, const Quadtree& sources,
                               Eigen::Index direct_pairs);

}  // namespace stokesbook
