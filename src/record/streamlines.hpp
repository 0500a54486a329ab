#pragma once

#include <vector>

#include "record/field.hpp"

namespace stokesbook {

/// A streamline: a line along the velocity.
struct Streamline {
  std::vector<Complex> points;  ///< in order, length; about two for each cell of the grid
  bool closed = false;          ///< whether the last point joins the first
};

/// Covers a field evenly with streamlines, in the direction of the flow.
///
/// A line starts at each grid point that is at least a separation away from all earlier lines. The
/// line is followed in both directions until it closes, comes within half a separation of another
/// line, or leaves the grid or the fluid. Velocities are interpolated bilinearly between the points
/// of the grid; a cell with a corner outside the fluid has no velocity. Lines shorter than the
/// separation are left out.
/// @param  separation  distance of neighbouring lines, > 0, length
/// @throws std::invalid_argument when the field has no velocity
/// @par Not for        anything but pictures: lines drift by the error of the interpolation
/// @sa source: Jobard and Lefer, Visualization in Scientific Computing '97, 43
std::vector<Streamline> streamlines(const Field& field, double separation);

}  // namespace stokesbook
