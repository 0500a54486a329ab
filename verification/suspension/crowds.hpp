#pragma once

#include "scene/scene.hpp"

namespace stokesbook::verification::suspension {

/// The flow or force that drives a crowd.
enum class Drive { rotating_container, shear, extension, vortices, settling };

/// The shapes of a crowd's bodies.
enum class Crowd { circles, ellipses, stars };

inline constexpr int drives = 5, crowds = 3;

/// A family of random dense scenes.
struct Family {
  Drive drive;
  Crowd crowd;
};

/// Generates five to fifteen bodies in a flow (at most eight in a container) with contact. The area
/// fraction is 0.2 to 0.6, or less if the bodies do not find room. The steps, by Euler's or Heun's
/// method, are 1 to 20 times 1/50 of the flow's time. Shear and extension reverse every two units
/// of time, so that the bodies stay together.
///
/// @return  the same scene on every machine
Scene crowded_scene(const Family& family, unsigned seed, int steps);

}  // namespace stokesbook::verification::suspension
