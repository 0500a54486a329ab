#pragma once

#include <cstddef>
#include <vector>

#include "near_singular/closest_points.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Two components and where they come closest.
struct Gap {
  std::size_t a = 0,     ///< one component
      b = 0;             ///< the other, after it
  ClosestPoints points;  ///< point_a on a, point_b on b
};

/// Finds the gaps that may ask for nodes: all pairs nearer than the reach of their trapezoid rules,
/// and the closest pair.
///
/// @param  configuration   poses of all components
/// @param  discretisation  of each component
/// @param  tolerance       of velocities, > 0; sets the reach
/// @return                 in ascending order of the gap; empty for a single component
/// @par Cost           a search in a RectangleIndex a component, N_a N_b distances a close pair
std::vector<Gap> find_gaps(const Configuration& configuration, const Discretisation& discretisation,
                           double tolerance);

/// @}

}  // namespace stokesbook
