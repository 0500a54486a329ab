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

/// Returns the error to which steps are adapted.
///
/// @param  time  settings of a method that adapts them
/// @return       time.tolerance, or the default where it is not given
double step_tolerance(const TimeSettings& time);

/// Measures how far two configurations are apart.
///
/// @param  discretisation  of each component
/// @param  p               one configuration
/// @param  q               the other one
/// @return                 largest distance between the two places of a node, length
double largest_distance(const Discretisation& discretisation, const Configuration& p,
                        const Configuration& q);

/// Says how the state of a scene is advanced.
///
/// Errors of positions count in units of the largest body's radius, the largest distance of its
/// boundary from its position, those of orientations in radians; so it does not matter in which
/// units of length and time a scene is written.
/// @param  solver  of the scene, with its [time] or none
/// @return         settings with the scene's limits, or the defaults of TimeSettings
SteppingSettings stepping_settings(const SuspensionSolver& solver);

/// What a checkpoint keeps of steps, by name.
using History = std::map<std::string, Eigen::VectorXd>;

/// Packs what steps remember.
///
/// @param  memory  of a stepper
/// @return         for a checkpoint
History to_history(const StepMemory& memory);

/// Unpacks what steps remember.
///
/// @param  history  as to_history() packs it
/// @return          for a stepper
/// @throws std::out_of_range when something is missing
StepMemory to_memory(const History& history);

/// @}

}  // namespace stokesbook
