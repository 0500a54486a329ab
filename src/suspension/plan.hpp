#pragma once

#include <string>
#include <vector>

#include "double_layer/stresslet_sum.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// What a scene needs, decided from the scene alone; nothing that is not in the plan is built.
struct Plan {
  /// One decision with its reason, for the reader.
  struct Line {
    std::string topic, decision, reason;
  };

  Eigen::Index n_nodes = 0;      ///< in all components
  bool null_space_fix = false;   ///< a wall encloses the fluid
  bool near_correction = false;  ///< components may come close
  bool block_diagonal = false;   ///< precondition by the components' own blocks
  KernelStorage storage = KernelStorage::streamed;
  double gmres_tolerance = 0.0;  ///< relative residual
  double near_tolerance = 0.0;   ///< of the sums' quadrature, relative to the density
  std::vector<Line> lines;
};

/// Decides what a scene without fills needs.
Plan make_plan(const Scene& scene);

/// @}

}  // namespace stokesbook
