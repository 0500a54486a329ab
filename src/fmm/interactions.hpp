#pragma once

#include <span>
#include <vector>

#include "fmm/quadtree.hpp"

namespace stokesbook {

/// @addtogroup fmm
/// @{

/// Consecutive points of a tree.
struct Range {
  Eigen::Index first;  ///< first of them
  Eigen::Index last;   ///< one beyond the last
};

/// Lists, one a box, in one array.
template <class Entry>
struct Lists {
  std::vector<Eigen::Index> begin;  ///< of each list in entries, and the end of the last
  std::vector<Entry> entries;       ///< all lists after each other

  /// Returns the list of a box.
  /// @param  box  its index
  /// @return      entries
  std::span<const Entry> of(Eigen::Index box) const {
    const auto k = static_cast<std::size_t>(box);
    return {entries.data() + begin[k], entries.data() + begin[k + 1]};
  }
};

/// Which boxes of two trees interact, and how.
struct Interactions {
  Lists<Eigen::Index> far;  ///< for each target box the source boxes whose expansions it takes
  Lists<Range> near;        ///< for each target box the source points that it sums
};

/// Finds the interactions by a dual-tree traversal.
///
/// Boxes are well separated when \f$ R_s < \rho(|D| - R_t) \f$ and
/// \f$ R_t < \rho(|D| - R_s) \f$ with \f$ \rho = 1/2 \f$: every expansion then falls like
/// \f$ 2^{-k} \f$. Pairs that are not are divided, the larger box first; two leaves are summed
/// directly, and so are separated boxes whose pairs of points cost less than a translation. A
/// source's margin is part of its box: no point nearer to it takes its expansion.
/// @param  targets       tree of the targets
/// @param  sources       tree of the sources
/// @param  direct_pairs  pairs of points that cost as much as a translation
/// @return               every pair of a target and a source is in exactly one interaction
/// @par Cost             O(number of boxes)
Interactions find_interactions(const Quadtree& targets, const Quadtree& sources,
                               Eigen::Index direct_pairs);

/// @}

}  // namespace stokesbook
