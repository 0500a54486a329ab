#pragma once

#include <vector>

#include "near_singular/near_correction.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Places the near-singular scheme of each component: the interpolation scheme if the scene selects
/// it, otherwise the Cauchy scheme.
///
/// @param  configuration   where the components are
/// @param  discretisation  of each component
/// @return                 one per component
/// @par Cost               that of a CauchyCurve for each component that is prepared without one
std::vector<PlacedCurve> placed_schemes(const Configuration& configuration,
                                        const Discretisation& discretisation);

/// Places the Cauchy scheme of each component, as derivatives of the velocity require it.
///
/// @param  configuration   where the components are
/// @param  discretisation  of each component
/// @return                 one per component
/// @par Cost               as that of placed_schemes()
std::vector<PlacedCurve> placed_cauchy_schemes(const Configuration& configuration,
                                               const Discretisation& discretisation);

/// @}

}  // namespace stokesbook
