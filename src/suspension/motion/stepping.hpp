#pragma once

#include "record/checkpoint.hpp"
#include "suspension/solver/solver.hpp"
#include "time_stepping/stepper.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Packs the motions of a solution as the rate of a state.
///
/// @param  solution  of K components
/// @return           3K numbers: velocity and angular velocity of every component
Eigen::VectorXd to_rate(const Solution& solution);

/// Returns the tolerance to which the lengths of steps are adapted.
///
/// @param  time  settings of a method with adapted steps
/// @return       time.tolerance, or the default if the scene gives none
double step_tolerance(const TimeSettings& time);

/// Measures the distance between two configurations.
///
/// @param  discretisation  of each component
/// @param  p               one configuration
/// @param  q               the other configuration
/// @return                 largest distance between the two positions of a node, length
double largest_distance(const Discretisation& discretisation, const Configuration& p,
                        const Configuration& q);

/// Returns the settings with which a stepper advances the state of a scene.
///
/// The errors of positions are measured in units of the largest radius of a body, which is the
/// largest distance of its boundary from its position; the errors of orientations are measured in
/// radians. The results therefore do not depend on the units of length and time in a scene.
/// @param  solver  of the scene, with or without [time]
/// @return         settings with the scene's limits, or the defaults of TimeSettings
SteppingSettings stepping_settings(const SuspensionSolver& solver);

/// The numbers that a checkpoint stores about the steps, by name.
using History = std::map<std::string, Eigen::VectorXd>;

/// Packs the memory of a stepper for a checkpoint.
///
/// @param  memory  of a stepper
/// @return         its numbers, by name
History to_history(const StepMemory& memory);

/// Unpacks the memory of a stepper from a checkpoint.
///
/// @param  history  numbers, as to_history() packs them
/// @return          memory of a stepper
/// @throws std::out_of_range when a number is missing
StepMemory to_memory(const History& history);

/// @}

}  // namespace stokesbook
