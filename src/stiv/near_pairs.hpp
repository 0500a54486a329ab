#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "stiv/contact_shape.hpp"
#include "stiv/rigid_path.hpp"

namespace stokesbook {

/// The numbers of two components, the smaller number first.
using ComponentPair = std::pair<std::size_t, std::size_t>;

/// Pairs that may come closer than others, with their own separation, length, > 0.
using CloserPairs = std::map<ComponentPair, double>;

/// The least distance that the polygons of each pair of components must keep.
///
/// The gap of two curves is narrower than the gap of their polygons by at most the sum of the two
/// sags. To keep the curves delta apart, pass delta plus both sags.
struct Separation {
  double everywhere;     ///< separation of pairs in general, length, > 0
  CloserPairs closer{};  ///< pairs with a smaller separation

  /// Returns the separation of two components in either order, at most @c everywhere, length.
  double between(std::size_t a, std::size_t b) const {
    const auto own = closer.find(std::minmax({a, b}));
    return own == closer.end() ? everywhere : std::min(everywhere, own->second);
  }
};

/// Returns the least rectangle that holds the polygon of a component.
Rectangle bounding_rectangle(const ContactShape& shape, const Pose& pose);

/// Returns a rectangle that holds the polygon of a component at all times of a step: the bounding
/// rectangles at start and end, widened by the distance by which a turning point may leave both in
/// between, at most \f$ |X|\Delta\theta^2/8 \f$.
Rectangle swept_rectangle(const ContactShape& shape, const RigidPath& path);

/// Finds the pairs of components whose rectangles are at most `reach` apart in each coordinate,
/// ascending: the broad phase. An enclosing wall is near every component that it encloses.
///
/// @par Cost  O(n log n + p) for p pairs, as long as rectangles overlap few others
std::vector<ComponentPair> near_pairs(const ContactShapes& shapes,
                                      const std::vector<Rectangle>& rectangles, double reach);

}  // namespace stokesbook
