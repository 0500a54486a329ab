#pragma once

#include <vector>

#include "suspension/bodies/resolution.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The requirement of one gap on the nodes of one of its curves.
struct GapRequirement {
  double parameter;  ///< of the closest point, radians
  double depth;      ///< the density's rate of decay there, from density_decay(); may be infinite
};

/// Chooses a component's nodes for its shape and its gaps.
///
/// Nodes are equidistant if no gap requires more than one and a half times the nodes that the shape
/// requires. Otherwise nodes crowd at every gap that the nodes of the shape do not resolve, over a
/// width equal to the depth of the gap. A cluster suffices for a second, wider gap, too, if the
/// distance of this gap from the cluster is less than the depth of this gap.
///
/// The number of graded nodes is \f$ \ln(10^5/\varepsilon)/r \f$, where r is the least
/// graded_depth() of all gaps, and of a shape that requires `shape_nodes` nodes because of
/// singularities all around the curve. The strength is the one that requires the fewest nodes.
/// @param  gaps         of the component, in any order
/// @param  shape_nodes  number of nodes that the shape requires without gaps, > 0
/// @param  tolerance    of velocities relative to their scale, > 0
/// @return              the fewest nodes found; equidistant unless graded nodes are fewer
/// @throws std::invalid_argument when shape_nodes, the tolerance or a depth is not positive
/// @par Accuracy        circles meet the tolerance at gaps down to 1e-5: @ref claim_03_38,
/// @ref claim_03_39, @ref claim_03_40
/// @par Cost            an evaluation of graded_depths() per gap, and 64 more
/// @par Not for         tolerances below the effect of rounding, about 1e-16 gap^(-3/2)
Resolution nodes_for_gaps(const std::vector<GapRequirement>& gaps, int shape_nodes,
                          double tolerance);

/// @}

}  // namespace stokesbook
