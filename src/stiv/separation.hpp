#pragma once

#include <algorithm>
#include <map>

#include "stiv/component_pair.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// Pairs that may come closer than others, and how close, length, > 0.
using CloserPairs = std::map<ComponentPair, double>;

/// The least distance that the polygons of each pair of components keep.
///
/// Gaps of the curves are narrower by at most the sum of the two sags: who wants them wider than
/// delta asks for delta and both sags.
struct Separation {
  double everywhere;     ///< of pairs in general, length, > 0
  CloserPairs closer{};  ///< exceptions

  /// Returns the separation of a pair.
  /// @param  a  a component
  /// @param  b  another one
  /// @return    length, > 0, at most @c everywhere
  double between(std::size_t a, std::size_t b) const {
    const auto own = closer.find(std::minmax({a, b}));
    return own == closer.end() ? everywhere : std::min(everywhere, own->second);
  }
};

/// @}

}  // namespace stokesbook
