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
/// @return bytes: what the machine has, or less where a limit is set
double available_memory();

/// Estimates the memory of a DiscretisedShape.
///
/// @param  n_nodes  N
/// @return          bytes: that of three dense matrices of 2 N rows
constexpr double memory_of_reference(int n_nodes) {
  return 3.0 * 8.0 * (2.0 * n_nodes) * (2.0 * n_nodes);
}

/// Explains which components take more memory than there is.
///
/// @param  scene        names components, and says which have the same shape
/// @param  resolutions  of each component
/// @param  available    bytes
/// @return              a message with numbers of nodes and bytes; empty when there is enough
std::string memory_error(const Scene& scene, const Resolutions& resolutions, double available);

/// @}

}  // namespace stokesbook
