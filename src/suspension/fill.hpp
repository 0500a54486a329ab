#pragma once

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Places the bodies of [[fill]] at random, one after another, wherever they keep their clearance;
/// returns the scene with them as bodies and without fills.
///
/// Reproducible: the same seed gives the same bodies on every machine.
/// @throws std::invalid_argument  when a body finds no place (random sequential addition jams above
/// an area fraction of
///                                about 0.5)
Scene with_fills_placed(const Scene& scene);

/// @}

}  // namespace stokesbook
