#pragma once

#include <vector>

#include "record/run_data.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// A closed curve in its own frame, for pictures.
struct Outline {
  ComplexVector
      points;  ///< in order along the curve, without a repetition of the first point, length
  bool encloses = false;  ///< true: the fluid lies inside (outer wall)
};

/// Returns the points of an outline in the laboratory frame, \f$ c + e^{i\theta} x \f$.
///
/// @param  outline      in its own frame
/// @param  position     c, length
/// @param  orientation  theta, radians, counter-clockwise
/// @return              points in the outline's order, length
ComplexVector placed(const Outline& outline, Complex position, double orientation);

/// Checks that every body and wall of a frame has its outline, and that the components of every
/// contact exist.
///
/// @param  frame   states of bodies and walls
/// @param  bodies  outlines in the order of frame.bodies
/// @param  walls   outlines in the order of frame.walls
/// @throws std::invalid_argument when the numbers differ, or a contact names a body or wall that is
///         not in the frame
void require_outlines(const Frame& frame, const std::vector<Outline>& bodies,
                      const std::vector<Outline>& walls);

/// @}

}  // namespace stokesbook
