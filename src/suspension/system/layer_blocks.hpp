#pragma once

#include <vector>

#include "closure/problem.hpp"
#include "krylov/block_diagonal.hpp"
#include "near_singular/near_targets.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Returns a function that assembles near-corrected double layers between components.
///
/// @param  problem    problem with its components; must outlive the result
/// @param  placed     placed curves of the components for near corrections, empty: none;
///                    must outlive the result
/// @param  tolerance  of the near corrections, relative to the density
/// @return            the layer between any two different components
/// @par Cost          M N kernel evaluations per call, and a row of the scheme per near node
LayerBlock layer_blocks(const StokesProblem& problem, const std::vector<PlacedCurve>& placed,
                        double tolerance);

/// @}

}  // namespace stokesbook
