#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "suspension/configuration.hpp"
#include "suspension/reference.hpp"
#include "suspension/resolution.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Names a component for messages and contact tables.
///
/// @param  scene      that it is part of
/// @param  component  bodies first, then walls
/// @return            "body 3" or "wall 0", both counted from 0
std::string component_name(const Scene& scene, std::size_t component);

/// Returns the number of nodes that the scene gives a component.
///
/// @param  scene      that it is part of
/// @param  component  bodies first, then walls
/// @return            nodes, or automatic_nodes
int given_nodes(const Scene& scene, std::size_t component);

/// Finds the gaps that may ask for nodes: all pairs nearer than the reach of their trapezoid rules,
/// and the closest pair.
///
/// @param  configuration  placements of all components
/// @param  references     of each component
/// @param  tolerance      of velocities, > 0; sets the reach
/// @return                in ascending order of the gap; empty for a single component
/// @par Cost           a search in a RectangleIndex a component, N_a N_b distances a close pair
std::vector<Gap> find_gaps(const Configuration& configuration, const References& references,
                           double tolerance);

/// What a gap asks of the nodes on its two curves.
struct GapResolution {
  DensityDecay decay;  ///< of the densities on gap.a and gap.b
  double error;        ///< estimate for the nodes they have, relative to the velocity scale
};

/// Estimates how well a gap is resolved, before any solve.
///
/// @param  gap            of two components, > 0
/// @param  configuration  placements of all components
/// @param  references     of each component
/// @return                rates of decay and estimated error
GapResolution gap_resolution(const Gap& gap, const Configuration& configuration,
                             const References& references);

/// Places a component.
///
/// @param  reference  shared nodes, in the shape's own frame
/// @param  placement  where they are
/// @return            its nodes and its curve in the plane
SmoothCurve smooth_curve(const Reference& reference, const Placement& placement);

/// @}

}  // namespace stokesbook
