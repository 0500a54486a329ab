#pragma once

#include "scene/scene.hpp"

namespace stokesbook {

/// Places the bodies of [[fill]] one after another at random, where they keep their clearance.
///
/// The bodies of the fills follow the scene's own bodies. The same seed gives the same bodies on
/// every machine.
/// @throws std::invalid_argument when a body finds no place in 20000 attempts (random sequential
///                addition jams above an area fraction of about 0.5), and when an area fraction
///                amounts to less than half a body, or to more than 1e7 bodies
Scene place_fills(const SceneFile& file);

}  // namespace stokesbook
