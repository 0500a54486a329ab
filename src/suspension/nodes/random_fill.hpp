#pragma once

#include "scene/scene.hpp"

namespace stokesbook {

/// Places the bodies of [[fill]] one after another at random, where they keep their clearance.
///
/// The placement is reproducible: the same seed gives the same bodies on every machine.
/// @return    the scene of the file, with the bodies of the fills after its own bodies
/// @throws std::invalid_argument when a body finds no place in 20000 attempts (random sequential
///                addition jams above an area fraction of about 0.5), and when an area fraction
///                amounts to less than half a body, or to more than 1e7 bodies
/// @par Cost  per attempt, a search in a RectangleIndex, and closest_points() for every
///            component whose bounding circle is within the clearance
Scene place_fills(const SceneFile& file);

}  // namespace stokesbook
