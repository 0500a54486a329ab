#pragma once

#include <optional>
#include <string>

#include "trapezoid/plane.hpp"

namespace stokesbook::scene_text {

/// The reason why points do not form the closed curve of a body.
struct PolygonFault {
  std::optional<Eigen::Index> point;  ///< index of the wrong point, if there is one
  std::string problem;                ///< text for messages
};

/// Finds the first fault of points that should form the closed curve of a body: at least 8 points,
/// distinct from their neighbours, joined by straight edges that do not meet and that go around the
/// origin once.
/// @param  points  in order along the curve, either sense
/// @par Cost       quadratic in the number of points
std::optional<PolygonFault> find_fault(const ComplexVector& points);

}  // namespace stokesbook::scene_text
