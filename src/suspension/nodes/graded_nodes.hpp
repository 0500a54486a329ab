#pragma once

#include <vector>

#include "suspension/bodies/resolution.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// What one gap asks of the nodes of one of its curves.
struct GapDemand {
  double parameter;  ///< of the closest point, radians
  double depth;      ///< the density's rate of decay there, from density_decay(); may be infinite
};

/// Chooses a component's nodes for its shape and its gaps.
///
/// Equidistant nodes serve where no gap asks for more than one and a half times what the shape asks
/// for. Else nodes crowd at every gap that the shape's nodes do not resolve, over its depth; a
/// cluster serves wider gaps within their own depths from it. The count is
/// \f$ \ln(10^5/\varepsilon)/r \f$, r the least graded_depth() of all gaps and of a shape that asks
/// for as many nodes everywhere; the strength is the one that needs the fewest.
/// @param  gaps         of the component, in any order
/// @param  shape_nodes  what the shape asks for without gaps, > 0
/// @param  tolerance    of velocities relative to their scale, > 0
/// @return              the fewest nodes found; equidistant where crowding does not pay
/// @throws std::invalid_argument when shape_nodes, the tolerance or a depth is not positive
/// @par Accuracy        circles meet the tolerance at gaps down to 1e-5: @ref claim_03_38,
/// @ref claim_03_39, @ref claim_03_40
/// @par Cost            an evaluation of graded_depths() a gap, and 64 more
/// @par Not for         tolerances below what rounding leaves, about 1e-16 gap^(-3/2)
Resolution nodes_for_gaps(const std::vector<GapDemand>& gaps, int shape_nodes, double tolerance);

/// @}

}  // namespace stokesbook
