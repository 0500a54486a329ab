#pragma once

#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// @name The state of a run
/// The state that time steppers advance holds the poses of the K components, 3K numbers as
/// to_state() packs them, and then the positions of the tracers, two numbers each.
/// @{

/// Returns the state at the start. Tracers that do not lie in the fluid are left out.
Eigen::VectorXd initial_state(const SuspensionSolver& solver);

/// Returns the poses of the components in a state.
Configuration configuration_of(const SuspensionSolver& solver, const Eigen::VectorXd& state);

/// Returns the positions of the tracers in a state.
ComplexVector tracers_of(const SuspensionSolver& solver, const Eigen::VectorXd& state);

/// Packs the motions of a solution as the rate of the components: 3K numbers, the velocity and the
/// angular velocity of each of K components.
Eigen::VectorXd to_rate(const Solution& solution);

/// Completes the velocities of the components, 3K numbers, to the rate of a state: the fluid of a
/// solution carries the tracers. Tracers that errors have taken into a body, or that have left
/// through a wall, move with this component.
///
/// @par Cost  that of SuspensionSolver::velocity(); none without tracers
Eigen::VectorXd with_tracers(const SuspensionSolver& solver, const Eigen::VectorXd& velocities,
                             const Solution& solution, const Eigen::VectorXd& state);

/// Returns the rate of a state: the motions of a solution, completed by with_tracers().
Eigen::VectorXd state_rate(const SuspensionSolver& solver, const Solution& solution,
                           const Eigen::VectorXd& state);

/// Returns configuration_of() a state to which a step leads.
///
/// The exact flow carries no tracer into a body: a step is too long if it takes a tracer farther in
/// than a thousandth of its distance from the body's position.
/// @throws ConfigurationError with the time, when a step is too long for a tracer
Configuration admitted_configuration(const SuspensionSolver& solver, double t,
                                     const Eigen::VectorXd& state);
/// @}

}  // namespace stokesbook
