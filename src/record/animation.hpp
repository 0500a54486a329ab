#pragma once

#include <string>
#include <vector>

#include "record/outline.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Begins the page of an animation, which plays by itself in a browser, from a file and without
/// network.
///
/// The page is this text and an animation_frame() for each written time. It may end after any byte:
/// a frame that is not whole is not shown.
/// @param  title   of the page, any text
/// @param  bodies  outlines in the order of Frame::bodies
/// @param  walls   outlines in the order of Frame::walls
/// @return         HTML: the player, then title and outlines as JSON; equal outlines are written
///                 once
std::string animation_head(const std::string& title, const std::vector<Outline>& bodies,
                           const std::vector<Outline>& walls);

/// Writes a frame of an animation.
///
/// Times have twelve significant digits and all other numbers six, enough to be looked at: the
/// tables have the exact ones.
/// @param  frame  its fields are left out
/// @return        HTML, one line: `[t, bodies, walls, contacts]` as JSON. A body is `[x, y, theta,
///                ux, uy, omega, fx, fy, torque]`, a wall `[x, y, theta, fx, fy, torque]`, a
///                contact `[a, b, x, y, force, gap]`, where -1 is the first wall, -2 the next
/// @throws std::invalid_argument when a number is not finite, which JSON does not know
std::string animation_frame(const Frame& frame);

/// @}

}  // namespace stokesbook
