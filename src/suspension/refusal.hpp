#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "suspension/gaps.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Explains what is wrong with a geometry.
///
/// @param  scene          names the components and the tolerance
/// @param  gaps           in ascending order
/// @param  configuration  placements of all components
/// @param  references     of each component
/// @return                a message naming components, values and what to change; empty when every
///                        shape and gap is resolved
std::string geometry_refusal(const Scene& scene, const std::vector<Gap>& gaps,
                             const Configuration& configuration, const References& references);

/// Explains that the density on a component is not resolved by its nodes.
///
/// @param  scene      names the component and the tolerance
/// @param  component  bodies first, then walls
/// @param  n_nodes    of the component
/// @param  tail       its estimate, above the tolerance
/// @param  gaps       in ascending order; names the neighbour that asks for nodes
/// @return            a message with the estimate and a node count that should do
std::string density_refusal(const Scene& scene, std::size_t component, Eigen::Index n_nodes,
                            const TailEstimate& tail, const std::vector<Gap>& gaps);

/// Recommends a node count for which a shape resolves its own double layer to a tolerance.
///
/// @param  reference  the shape with its side
/// @param  tolerance  of rigid_motion_residual()
/// @param  at_least   where the search starts
/// @return            multiple of 16, >= at_least, or 0 when 4096 nodes are not enough
/// @par Cost          rigid_motion_residual() of each count that is tried, 16 or a quarter apart
int nodes_for_shape(const Reference& reference, double tolerance, int at_least);

/// @}

}  // namespace stokesbook
