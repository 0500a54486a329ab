#pragma once

#include <compare>
#include <limits>
#include <optional>
#include <vector>

#include "record/field.hpp"
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
  double torque = 0.0;       ///< by the body on the fluid, about position, counter-clockwise, force
};

/// A wall at one time, in the user's units.
struct WallLoad {
  Complex position;          ///< length
  double orientation = 0.0;  ///< radians, counter-clockwise
  Complex force;             ///< by the wall on the fluid, force / length
  double torque = 0.0;       ///< by the wall on the fluid, about position, counter-clockwise, force
};

/// Properties of a suspension as a whole; not a number where the scene does not define them.
struct Rheology {
  static constexpr double undefined = std::numeric_limits<double>::quiet_NaN();  ///< not a number

  double dissipation = undefined;           ///< power, force length / (length time)
  double torque_ratio = undefined;          ///< of a Couette cell, with bodies over without
  double order_parameter = undefined;       ///< 1 for long axes along the flow, -1 across it
  Complex stresslet{undefined, undefined};  ///< S_11 + i S_12 of all that is in the fluid, force
  Complex uniform_velocity{undefined, undefined};  ///< of the fluid at infinity beside the
                                                   ///< background, where none is given
};

/// One of two components that are in contact.
struct ContactParty {
  bool is_wall = false;    ///< a wall, not a body
  std::size_t number = 0;  ///< in the scene's list of bodies or walls
  /// Compares kinds, then numbers.
  friend auto operator<=>(const ContactParty&, const ContactParty&) = default;
};

/// A force between two components that are kept apart.
struct ContactForce {
  ContactParty a;      ///< one of them
  ContactParty b;      ///< the other
  Complex point;       ///< where it acts, length
  Complex normal;      ///< of the force on a, unit
  double force = 0.0;  ///< >= 0, force / length
  double gap = 0.0;    ///< of the curves at the end of the step that the force is for, length
};

/// The configuration at a written time, and what the flow does there.
struct Frame {
  double t = 0.0;                        ///< time
  std::vector<BodyState> bodies;         ///< in the scene's order
  std::vector<WallLoad> walls;           ///< in the scene's order
  Rheology rheology{};                   ///< of the whole
  std::vector<ContactForce> contacts{};  ///< that keep components apart
  std::optional<Field> field{};          ///< where it was asked for
};

/// What one time step did.
struct StepInfo {
  double t = 0.0;               ///< time at the end of the step
  double dt = 0.0;              ///< length of the step, time
  int gmres_iterations = 0;     ///< of all its solves
  int matvecs = 0;              ///< applications of the operator
  int ncp_iterations = 0;       ///< of the contact solver; 0 without contact
  int contacts = 0;             ///< pairs in contact
  double min_gap = 0.0;         ///< least distance of two curves, length; infinite for a single one
  double residual = 0.0;        ///< largest relative residual of its linear solves
  double velocity_error = 0.0;  ///< estimate of its beginning, or the latest before: of velocities,
                                ///< relative to their scale
  double step_error = 0.0;      ///< estimate of what the step itself errs by: of positions in units
                                ///< of the largest body's radius, and of angles
  double seconds = 0.0;         ///< wall time of its solves
  double kkt_residual = 0.0;  ///< of contact, in minimum separations: the largest violation of the
                              ///< separation, or gap beyond it across which a force acts
  double force_imbalance = 0.0;   ///< net contact force over the largest
  double torque_imbalance = 0.0;  ///< net torque over the largest force and its distance
  double contact_power = 0.0;     ///< of the forces of contact on all components at the end of the
                                  ///< step, force / time; negative where they hold against motion
  double energy_injected = 0.0;   ///< work of contact where it drives, force
};

/// @}

}  // namespace stokesbook
