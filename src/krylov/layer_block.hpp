#pragma once

#include <functional>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup krylov
/// @{

/// Assembles the double layer of one component at the nodes of another: 2M x 2N, dimensionless,
/// interleaved, in the plane's frame. It is called by several threads at once.
using LayerBlock = std::function<Eigen::MatrixXd(std::size_t target, std::size_t source)>;

/// @}

}  // namespace stokesbook
