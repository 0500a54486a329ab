#pragma once

#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Poses of all components: bodies in the scene's order, then walls in the scene's order.
using Configuration = std::vector<Pose>;

/// The data on which the flow of an instant depends, in addition to the scene.
struct Instant {
  Configuration configuration;  ///< where the components are
  double amplitude = 1.0;  ///< flow amplitude: factor of the background flow, of the velocities
                           ///< of walls and held bodies, and of the loads; -1 after a reversal
};

/// @}

}  // namespace stokesbook
