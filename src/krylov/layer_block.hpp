#pragma once

#include <functional>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup krylov
/// @{

/// A function that assembles the double layer of one component at the nodes of another: 2M x 2N,
/// dimensionless, interleaved, in the frame of the plane.
///
/// Several threads call the function at once.
using LayerBlock = std::function<Eigen::MatrixXd(std::size_t target, std::size_t source)>;

/// @}

}  // namespace stokesbook
