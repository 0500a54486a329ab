#pragma once

#include "scene/scene.hpp"

namespace stokesbook::verification::suspension {

/// What drives a crowd.
enum class Drive { rotating_container, shear, extension, vortices, settling };

/// What a crowd is made of.
enum class Crowd { circles, ellipses, stars };

inline constexpr int drives = 5, crowds = 3;

/// A family of random dense scenes.
struct Family {
  Drive drive;
  Crowd crowd;
};

/// Five to fifteen bodies in a flow, to eight in a container, at an area fraction of 0.2 to 0.6 as
/// far as they find room, with contact; steps 1 to 20 times 1/50 of the flow's time, Euler's or
/// Heun's. Shear and extension reverse every two units of time, which keeps the bodies together.
///
/// @return  the same scene on every machine
Scene crowded_scene(const Family& family, unsigned seed, int steps);

}  // namespace stokesbook::verification::suspension
