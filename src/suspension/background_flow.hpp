#pragma once

#include "scene/scene.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Evaluates an undisturbed flow at points of the plane.
///
/// @param  flow    kind and strength
/// @param  points  m points, length
/// @return         m velocities, length / time
ComplexVector background_velocity(const BackgroundFlow& flow, const ComplexVector& points);

/// @}

}  // namespace stokesbook
