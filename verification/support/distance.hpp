#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "closure/closure.hpp"

namespace stokesbook::test {

/// Returns the largest difference of two motions; angular velocities are multiplied by `length`.
inline double distance(const RigidMotion& p, const RigidMotion& q, double length = 1.0) {
  return std::max(std::abs(p.velocity - q.velocity), length * std::abs(p.omega - q.omega));
}

/// Returns the largest difference of two loads; torques are divided by `length`.
inline double distance(const Load& p, const Load& q, double length = 1.0) {
  return std::max(std::abs(p.force - q.force), std::abs(p.torque - q.torque) / length);
}

/// Returns the largest difference of loads, relative to the largest expected load.
inline double relative_distance(const std::vector<Load>& found, const std::vector<Load>& expected,
                                double length = 1.0) {
  double error = 0.0, scale = 0.0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    error = std::max(error, distance(found[k], expected[k], length));
    scale = std::max(scale, distance(expected[k], Load{}, length));
  }
  return error / scale;
}

}  // namespace stokesbook::test
