#pragma once

#include <algorithm>
#include <cmath>

#include "closure/closure.hpp"

namespace stokesbook::test {

/// Largest difference of two motions, with turns taken at the distance `length` from the centre.
inline double distance(const RigidMotion& p, const RigidMotion& q, double length = 1.0) {
  return std::max(std::abs(p.velocity - q.velocity), length * std::abs(p.omega - q.omega));
}

/// Largest difference of two loads, with torques as forces at the distance `length` from the
/// centre.
inline double distance(const Load& p, const Load& q, double length = 1.0) {
  return std::max(std::abs(p.force - q.force), std::abs(p.torque - q.torque) / length);
}

}  // namespace stokesbook::test
