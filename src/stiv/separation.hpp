#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

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
  double everywhere;     ///< of pairs in general, length, > 0
  CloserPairs closer{};  ///< pairs with a smaller separation

  /// Returns the separation of two components in either order, at most @c everywhere, length.
  double between(std::size_t a, std::size_t b) const {
    const auto own = closer.find(std::minmax({a, b}));
    return own == closer.end() ? everywhere : std::min(everywhere, own->second);
  }
};

}  // namespace stokesbook
