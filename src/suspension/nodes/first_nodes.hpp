#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "suspension/bodies/discretised_shape.hpp"
#include "suspension/bodies/gaps.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Recommends nodes for every component, so that shapes and gaps meet a tolerance.
///
/// @param  discretisation  of each component, at any resolution
/// @param  tolerance       of velocities, > 0
/// @param  configuration   where the components are
/// @param  gaps            of the configuration, as find_gaps() returns them
/// @return                 multiples of 16, one per component; 0 if no number up to 4096 resolves
///                         the shape, and no gap requires nodes
/// @par Cost               that of nodes_for_shape() per distinct shape
std::vector<int> recommended_nodes(const Discretisation& discretisation, double tolerance,
                                   const Configuration& configuration,
                                   const std::vector<Gap>& gaps);

/// Chooses the resolution with which a solve begins.
///
/// @param  scene           scene whose given node numbers are kept
/// @param  discretisation  of each component alone
/// @param  configuration   where the components are
/// @param  gaps            of the configuration, as find_gaps() returns them
/// @return                 given node numbers; automatic ones from shapes and gaps, graded where a
///                         narrow gap requires it
Resolutions first_resolutions(const Scene& scene, const Discretisation& discretisation,
                              const Configuration& configuration, const std::vector<Gap>& gaps);

/// @}

}  // namespace stokesbook
