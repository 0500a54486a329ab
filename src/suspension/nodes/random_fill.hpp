#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace stokesbook {

/// A scene with the bodies of its fills.
struct FilledScene {
  Scene scene;                    ///< the bodies of the fills follow the scene's own bodies
  std::vector<std::string> plan;  ///< how bodies were placed; empty if all were inserted at random
};

/// Inserts the bodies of [[fill]] one after another at random, where they keep their clearance; in
/// a periodic cell, also from images, their own included.
///
/// If a body finds no place in 20000 attempts, then all bodies are inserted at half their size, and
/// grow_bodies() lets them grow. Insertion jams above an area fraction of about 0.5, growth above
/// about 0.8. The same seed gives the same bodies: after insertion on every machine, after growth
/// by the same build only, since growth amplifies rounding.
/// @throws std::invalid_argument when growth ends before the bodies have their size, and when an
///                area fraction amounts to less than half a body, or to more than 1e7 bodies
FilledScene fill_scene(const SceneFile& file);

/// Returns the scene of fill_scene().
Scene place_fills(const SceneFile& file);

}  // namespace stokesbook
