#pragma once

#include <optional>
#include <string>

#include "trapezoid/plane.hpp"

namespace stokesbook::scene_text {

/// Why points do not go once around the origin.
struct PolygonFault {
  std::optional<Eigen::Index> point;  ///< where, if it is at one point
  std::string problem;                ///< what is wrong, for messages
};

/// Looks for what keeps points from being the closed curve of a body: at least 8 points, distinct
/// from their neighbours, joined by straight edges that do not meet, around the origin.
///
/// @param  points  in order along the curve, either sense
/// @return         the first fault; none: they are a closed curve
/// @par Cost       quadratic in the number of points
std::optional<PolygonFault> find_fault(const ComplexVector& points);

}  // namespace stokesbook::scene_text
