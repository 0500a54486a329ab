#pragma once

#include <vector>

#include "fmm/quadtree.hpp"

namespace stokesbook {

/// @addtogroup fmm
/// @{

/// Lists of numbers, one a box, in one array.
struct Lists {
  std::vector<Eigen::Index> begin;    ///< of each list in entries, and the end of the last
  std::vector<Eigen::Index> entries;  ///< all lists after each other
};

/// Which boxes of two trees interact, and how.
struct Interactions {
  Lists far;   ///< for each target box the source boxes whose expansions it takes
  Lists near;  ///< for each target box first and last source point of each range that it sums
};

/// Finds the interactions by a dual-tree traversal.
///
/// Boxes are well separated when \f$ R_s < \rho(|D| - R_t) \f$ and
/// \f$ R_t < \rho(|D| - R_s) \f$ with \f$ \rho = 1/2 \f$: every expansion then falls like
/// \f$ 2^{-k} \f$. Pairs that are not are divided, the larger box first; two leaves are summed
/// directly, and so are separated leaves whose pairs of points cost less than a translation.
/// @param  targets       tree of the targets
/// @param  sources       tree of the sources
/// @param  direct_pairs  pairs of points that cost as much as a translation
/// @return               every pair of a target and a source is in exactly one interaction
/// @par Cost             O(number of boxes)
Interactions find_interactions(const Quadtree& targets, const Quadtree& sources,
                               Eigen::Index direct_pairs);

/// @}

}  // namespace stokesbook
