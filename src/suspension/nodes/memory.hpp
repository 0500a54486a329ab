#pragma once

#include <string>

#include "scene/scene.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Returns how much memory the process may take.
///
/// @return bytes: the memory of the machine, or the process's address-space limit if it is less
double available_memory();

/// Estimates the memory of a DiscretisedShape.
///
/// @param  n_nodes  N
/// @return          bytes of three dense matrices, 2 N x 2 N each
constexpr double memory_of_discretised_shape(int n_nodes) {
  return 3.0 * 8.0 * (2.0 * n_nodes) * (2.0 * n_nodes);
}

/// Explains that the matrices of all shapes take more memory than is available.
///
/// @param  scene        scene with the shapes and the names of the components
/// @param  resolutions  of each component
/// @param  available    bytes
/// @return              a message with numbers of nodes and bytes; empty if the memory suffices
std::string memory_error(const Scene& scene, const Resolutions& resolutions, double available);

/// @}

}  // namespace stokesbook
