#pragma once

#include <string>
#include <vector>

#include "record/outline.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Writes the head of an animation, a page that plays in a browser, from a file and without a
/// network.
///
/// The page consists of this text and one animation_frame() for each written time. The page may end
/// after any byte: the player ignores an incomplete frame.
/// @param  title   title of the page, any text
/// @param  bodies  outlines in the order of Frame::bodies
/// @param  walls   outlines in the order of Frame::walls
/// @return         HTML: the player, then title and outlines as JSON; equal outlines are written
///                 once
std::string animation_head(const std::string& title, const std::vector<Outline>& bodies,
                           const std::vector<Outline>& walls);

/// Writes a frame of an animation.
///
/// Times have twelve significant digits and all other numbers six, which is enough for a display;
/// the tables have the exact numbers.
/// @param  frame  the configuration at a written time; its field is not written
/// @return        HTML, one line: `[t, bodies, walls, contacts]` as JSON. A body is `[x, y, theta,
///                ux, uy, omega, fx, fy, torque]`, a wall `[x, y, theta, fx, fy, torque]`, a
///                contact `[a, b, x, y, force, gap]`, where a and b are numbers of bodies, or -1
///                for the first wall, -2 for the next
/// @throws std::invalid_argument when a number is not finite, since JSON cannot represent it
std::string animation_frame(const Frame& frame);

/// @}

}  // namespace stokesbook
