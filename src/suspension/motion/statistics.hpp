#pragma once

#include <chrono>
#include <set>
#include <tuple>
#include <vector>

#include <Eigen/Core>

#include "record/run_data.hpp"
#include "record/run_info.hpp"
#include "suspension/contact/contact.hpp"
#include "suspension/solver/fields.hpp"
#include "suspension/solver/solver.hpp"
#include "time_stepping/step_control.hpp"

namespace stokesbook {

/// Returns the wall time that has passed since a start.
double seconds_since(std::chrono::steady_clock::time_point start);

/// The cost of a run, its resolution, and its estimated errors.
struct RunStatistics {
  RunTotals totals{};          ///< counts of work
  RunResolution resolution{};  ///< numbers of nodes, and estimates of errors
  Eigen::VectorXd errors;      ///< estimated errors of all steps, added up with their signs
  ErrorBound bound;            ///< its scale is the unit of these errors

  /// Counts a solve.
  void add_solve(const Solution& solution);

  /// Counts the iterations of a stage's contact, the solves for its mobility, and the wall time of
  /// both.
  void add_contact(const ContactOutcome& outcome, const ContactMobility& mobility, double seconds);

  /// Counts the work of an estimated field, and keeps the largest error of each quantity.
  void add_field(const EstimatedField& field);

  /// Keeps the largest numbers of nodes and the largest error estimate.
  void add_resolution(const Solution& solution);

  /// Counts a step that was taken, and returns it with its step_error. The argument is the
  /// estimated error of the state. Errors keep their signs: those of a closed orbit, or of a path
  /// there and back, cancel.
  StepInfo add_step(StepInfo step, const Eigen::VectorXd& error);
};

/// Begins to count what a step does, with the solution at its beginning and the wall time of that.
StepInfo begin_step(const Solution& first, double seconds);

/// Adds a solve and its wall time to what a step has done.
StepInfo with_solve(StepInfo step, const Solution& solution, double seconds);

/// Adds the contact of a stage to what a step has done, with cost and wall time of all attempts.
StepInfo with_contact(StepInfo step, const ContactOutcome& outcome, const SolveCost& cost,
                      double seconds);

/// Adds the cost, and nothing else, of a rejected attempt to what a step has done: `rejected` is
/// the step with the attempt, the result is the step for the next attempt.
StepInfo with_costs_of(StepInfo step, const StepInfo& rejected);

/// Adds residual, imbalances, power and energy of the contact in a stage of a step that is taken;
/// the contact forces act for the given duration.
StepInfo with_forces(StepInfo step, const ContactOutcome& outcome, double duration);

/// Lists the pairs with a contact force between them, each once, with the image of the second one.
std::set<std::tuple<ContactParty, ContactParty, LatticeIndex>> pairs_in_contact(
    const std::vector<ContactForce>& forces);

}  // namespace stokesbook
