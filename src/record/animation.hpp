#pragma once

#include <string>
#include <string_view>

#include "record/run_data.hpp"

namespace stokesbook {

/// The page that plays a run, without data; the build makes it from the files of the folder player.
extern const std::string_view player_page;

/// Writes the head of an animation, a page of HTML that plays in a browser, from a file and without
/// a network.
///
/// The head contains the player, then title and outlines as JSON; equal outlines are written once.
/// One animation_frame() follows for each written time. The page may end after any byte: the player
/// ignores an incomplete frame.
std::string animation_head(const std::string& title, const Outlines& outlines);

/// Writes a frame of an animation; the frame's field is not written.
///
/// Times have twelve significant digits and all other numbers six, which is enough for a display;
/// the tables have the exact numbers.
/// @return  HTML, one line: `[t, bodies, walls, contacts]` as JSON. A body is
///          `[x, y, theta, ux, uy, omega, fx, fy, torque]`, a wall `[x, y, theta, fx, fy, torque]`,
///          a contact `[a, b, x, y, force, gap]`, where a and b are ContactParty::id(); with a
///          periodic cell also `[cx, cy, ax, ay, bx, by]`, its centre and the vectors of its
///          lattice with twelve digits, bodies have the velocities of their images in the cell, and
///          contacts end with the two numbers of ContactForce::image
/// @throws std::invalid_argument when a number is not finite, since JSON cannot represent it
std::string animation_frame(const Frame& frame);

}  // namespace stokesbook
