#pragma once

#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// A body at one time, in the user's units.
struct BodyState {
  Complex position;          ///< length
  double orientation = 0.0;  ///< radians, counter-clockwise
  Complex velocity;          ///< length / time
  double omega = 0.0;        ///< counter-clockwise, 1 / time
  Complex force;             ///< by the body on the fluid, force / length
  double torque = 0.0;       ///< by the body on the fluid, about position, counter-clockwise
};

/// A wall at one time, in the user's units.
struct WallLoad {
  Complex position;          ///< length
  double orientation = 0.0;  ///< radians, counter-clockwise
  Complex force;             ///< by the wall on the fluid, force / length
  double torque = 0.0;       ///< by the wall on the fluid, about position, counter-clockwise
};

/// The configuration at a written time.
struct Frame {
  double t = 0.0;
  std::vector<BodyState> bodies;
  std::vector<WallLoad> walls;
};

/// What one time step did.
struct StepInfo {
  double t = 0.0;   ///< time at the end of the step
  double dt = 0.0;  ///< length of the step
  int gmres_iterations = 0;
  int matvecs = 0;
  int ncp_iterations = 0;
  int contacts = 0;             ///< pairs in contact
  double min_gap = 0.0;         ///< least distance of two curves, length
  double residual = 0.0;        ///< relative, of the last linear solve
  double error_estimate = 0.0;  ///< of the time step
  double seconds = 0.0;         ///< wall time
};

/// @}

}  // namespace stokesbook
