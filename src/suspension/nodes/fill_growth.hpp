#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace stokesbook {

/// Bodies that all have the same part of their size.
struct GrowingBodies {
  double size;               ///< part of shape and clearance, > 0 and <= 1
  std::vector<Body> bodies;  ///< without overlaps
};

/// Lets bodies grow together to the shape and clearance of their fills, and moves apart those that
/// come too near to each other, to components of the scene or to the box of their fill.
///
/// Bodies grow by at most 0.02 of their size at a time. If 100 sweeps over the gaps do not suffice
/// to move them apart, the growth is halved; the bodies have their final size when less than 0.002
/// fails.
/// @param  fills  fill of each body
/// @return        the size reached; the same bits for any number of threads
/// @par Cost      that of polygon_gaps() for each sweep
/// @sa source: Jodrey, Tory, Phys. Rev. A 32 (1985), who move spheres apart one pair at a time
GrowingBodies grow_bodies(const Scene& scene, const std::vector<const Fill*>& fills,
                          GrowingBodies growing);

}  // namespace stokesbook
