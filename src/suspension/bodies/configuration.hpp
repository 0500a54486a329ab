#pragma once

#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Poses of all components: bodies in the scene's order, then walls in the scene's order.
using Configuration = std::vector<Pose>;

/// All that the flow of an instant depends on, beside the scene.
struct Instant {
  Configuration configuration;  ///< where the components are
  double amplitude = 1.0;       ///< of the imposed flow: factor of background flow, velocities of
                                ///< walls and held bodies, and loads; -1 where they are reversed
};

/// @}

}  // namespace stokesbook
