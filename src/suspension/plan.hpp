#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// What a scene needs, decided from the scene alone; nothing that is not in the plan is built.
struct Plan {
  /// One decision with its reason, for the reader.
  struct Line {
    std::string topic,  ///< what is decided
        decision,       ///< how
        reason;         ///< why
  };

  bool null_space_fix = false;   ///< a wall encloses the fluid
  bool near_correction = false;  ///< components may come close
  bool block_diagonal = false;   ///< precondition by the components' own blocks
  double gmres_tolerance = 0.0;  ///< relative residual
  double near_tolerance = 0.0;   ///< of the sums' quadrature, relative to the density
  std::vector<Line> lines;       ///< all decisions, in the order in which they are told
};

/// Decides what a scene needs.
///
/// @param  scene  without fills: with_fills_placed() comes first
/// @return        what is to be built, and why
Plan make_plan(const Scene& scene);

/// @}

}  // namespace stokesbook
