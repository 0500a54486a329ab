#pragma once

#include <vector>

#include "trapezoid/grading.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The number of nodes of a component, and their grading.
struct Resolution {
  int n_nodes = 0;    ///< collocation nodes, even
  Grading grading{};  ///< where nodes crowd; without clusters: nowhere

  /// Returns whether nodes crowd anywhere.
  /// @return true when the grading has clusters
  bool is_graded() const { return !grading.clusters.empty(); }

  /// @return true when all members are equal
  bool operator==(const Resolution&) const = default;
};

/// The resolution of each component: bodies, then walls, in the scene's order.
using Resolutions = std::vector<Resolution>;

/// @}

}  // namespace stokesbook
