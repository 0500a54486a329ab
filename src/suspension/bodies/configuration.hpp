#pragma once

#include <vector>

#include <Eigen/Core>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// Poses of all components: bodies in the scene's order, then walls in the scene's order.
using Configuration = std::vector<Pose>;

/// Packs the poses of K components into the state vector that time steppers advance.
/// @return 3K numbers: x, y, orientation of every component
Eigen::VectorXd to_state(const Configuration& configuration);

/// Unpacks a state that to_state() packed.
Configuration to_configuration(const Eigen::VectorXd& state);

}  // namespace stokesbook
