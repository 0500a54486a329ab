#pragma once

#include <set>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "record/run_data.hpp"
#include "record/run_info.hpp"
#include "suspension/contact/contact.hpp"
#include "suspension/contact/contact_mobility.hpp"
#include "suspension/solver/fields.hpp"
#include "suspension/solver/solver.hpp"
#include "time_stepping/step_control.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// What a run has cost, how finely it was resolved, and how wrong it may be.
struct RunStatistics {
  RunTotals totals{};          ///< counts of work
  RunResolution resolution{};  ///< numbers of nodes, and estimates of errors
  Eigen::VectorXd errors;      ///< estimated errors of all steps, added up with their signs
  ErrorBound bound;            ///< its scale is the unit of these errors

  /// Counts a solve.
  /// @param  solution  of it
  void add_solve(const Solution& solution);

  /// Counts the solves for contact forces.
  /// @param  mobility  of the stage
  void add_solves(const ContactMobility& mobility);

  /// Counts the work of an estimated field, and keeps the largest error of each quantity.
  /// @param  field  with its estimates
  void add_field(const EstimatedField& field);

  /// Keeps the largest numbers of nodes and the largest error estimate.
  /// @param  solution  with its estimate
  void add_resolution(const Solution& solution);

  /// Counts a step that was taken.
  ///
  /// Errors keep their signs: those of a closed orbit, or of a path there and back, cancel.
  /// @param  step   what it did
  /// @param  error  estimated, of the state
  /// @return        the same, with the step's error
  StepInfo add_step(StepInfo step, const Eigen::VectorXd& error);
};

/// Begins to count what a step does.
///
/// @param  first    solution at its beginning
/// @param  seconds  wall time of that
/// @return          counts of that solve
StepInfo begun_step(const Solution& first, double seconds);

/// Adds a solve to what a step has done.
///
/// @param  step      so far
/// @param  solution  of the solve
/// @param  seconds   wall time of it
/// @return           counts with the solve
StepInfo with_solve(StepInfo step, const Solution& solution, double seconds);

/// Adds the contact of a stage to what a step has done.
///
/// @param  step     so far
/// @param  outcome  of the stage
/// @param  cost     of its responses, those of all tries
/// @param  seconds  wall time, likewise
/// @return          counts with these
StepInfo with_contact(StepInfo step, const ContactOutcome& outcome, const SolveCost& cost,
                      double seconds);

/// Adds what a try that was rejected has cost, nothing else of it.
///
/// @param  step      before the try
/// @param  rejected  the same with the try
/// @return           counts for the next try
StepInfo with_costs_of(StepInfo step, const StepInfo& rejected);

/// Adds what contact did in a stage of a step that is taken.
///
/// @param  step      so far
/// @param  outcome   of the stage
/// @param  duration  for which its forces act
/// @return           with residual, imbalances, power and energy
StepInfo with_forces(StepInfo step, const ContactOutcome& outcome, double duration);

/// Lists the pairs that are in contact.
///
/// @param  forces  of a stage
/// @return         pairs with a force between them, each once
std::set<std::pair<ContactParty, ContactParty>> pairs_in_contact(
    const std::vector<ContactForce>& forces);

/// @}

}  // namespace stokesbook
