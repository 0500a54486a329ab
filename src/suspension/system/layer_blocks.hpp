#pragma once

#include <vector>

#include "closure/problem.hpp"
#include "krylov/layer_block.hpp"
#include "near_singular/near_targets.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Assembles near-corrected double layers between components.
///
/// @param  problem    its components; must outlive the result
/// @param  placed     the same components for near corrections, empty: none;
///                    must outlive the result
/// @param  tolerance  of the near corrections, relative to the density
/// @return            the layer between any two different components
/// @par Cost        M N kernel evaluations a call, and a row of the scheme a near node
LayerBlock layer_blocks(const StokesProblem& problem, const std::vector<PlacedCurve>& placed,
                        double tolerance);

/// @}

}  // namespace stokesbook
