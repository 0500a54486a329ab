#pragma once

#include <Eigen/Core>

#include "suspension/bodies/configuration.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Packs poses into a state.
///
/// @param  configuration  K components
/// @return                3K numbers: x, y, orientation of every component
Eigen::VectorXd to_state(const Configuration& configuration);

/// Unpacks a state.
///
/// @param  state  3K numbers, as to_state() packs them
/// @return        poses of K components
Configuration to_configuration(const Eigen::VectorXd& state);

/// @}

}  // namespace stokesbook
