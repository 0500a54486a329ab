#pragma once

#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Where a component is.
struct Placement {
  Complex position;          ///< of its frame's origin, length
  double orientation = 0.0;  ///< radians, counter-clockwise
};

/// Placements of all components: bodies in the scene's order, then walls in the scene's order.
using Configuration = std::vector<Placement>;

/// @}

}  // namespace stokesbook
