#pragma once

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Places the bodies of [[fill]] at random, one after another, wherever they keep their clearance.
///
/// Reproducible: the same seed gives the same bodies on every machine.
/// @param  file  with fills or none
/// @return       its scene, with the bodies of the fills after its own
/// @throws std::invalid_argument when a body finds no place in 20000 attempts (random sequential
///                addition jams above an area fraction of about 0.5), and when an area fraction is
///                less than half a body
/// @par Cost      a search in a RectangleIndex an attempt, closest_points() where two bounding
///                circles meet
Scene place_fills(const SceneFile& file);

/// @}

}  // namespace stokesbook
