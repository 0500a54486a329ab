#pragma once

#include <vector>

#include "fmm/quadtree.hpp"

namespace stokesbook {

/// Consecutive points of a tree.
struct Range {
  Eigen::Index first;  ///< first of them
  Eigen::Index last;   ///< one beyond the last
};

/// The interactions between the boxes of two trees: two lists for each target box.
struct Interactions {
  Complex shift;                               ///< vector by which the sources are moved, length
  std::vector<std::vector<Eigen::Index>> far;  ///< source boxes that are converted (M2L)
  std::vector<std::vector<Range>> near;        ///< source points that are summed directly
};

/// Finds the interactions by a dual-tree traversal, with all sources moved by a vector.
///
/// Boxes are well separated when \f$ R_s < \rho(|D| - R_t) \f$ and
/// \f$ R_t < \rho(|D| - R_s) \f$ with \f$ \rho = 1/2 \f$ (08.8): every expansion then falls like
/// \f$ 2^{-k} \f$. If a pair of boxes is not well separated, then the larger box is divided. Two
/// leaves are summed directly, and so is a well separated pair whose target is a leaf and whose
/// pairs of points, at most `direct_pairs`, cost less than a translation. The disk of a box
/// contains the margins of its sources, so that the expansion of a source is never used at a target
/// within the source's margin. Every pair of a target and a source is in exactly one interaction.
/// @par Cost  O(number of boxes)
Interactions find_interactions(const Quadtree& targets, const Quadtree& sources,
                               Eigen::Index direct_pairs, Complex shift = {});

}  // namespace stokesbook
