#pragma once

#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Poses of all components: bodies in the scene's order, then walls in the scene's order.
using Configuration = std::vector<Pose>;

/// @}

}  // namespace stokesbook
