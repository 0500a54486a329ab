#pragma once

#include <cstdint>
#include <vector>

#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Finds the points that lie in the fluid, outside all bodies and inner walls, and inside the
/// enclosing wall, by Barycentric::side().
///
/// @param  configuration   poses of all components
/// @param  discretisation  of each component
/// @param  points          m points, length
/// @return                 one per point: 1 in the fluid, otherwise 0
/// @par Accuracy  if shapes are resolved, points farther from the boundary than 1e-12 of a
/// component's size are assigned correctly, also between nodes: @ref claim_06_25
/// @par Cost      a search in a RectangleIndex per point, O(N) for a point inside a bounding circle
std::vector<std::uint8_t> in_fluid(const Configuration& configuration,
                                   const Discretisation& discretisation,
                                   const ComplexVector& points);

/// @}

}  // namespace stokesbook
