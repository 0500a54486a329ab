#pragma once

#include "suspension/contact/passing.hpp"
#include "suspension/motion/instant_solver.hpp"
#include "suspension/motion/output_schedule.hpp"
#include "suspension/motion/taken_step.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Takes the steps of a scene without contact, by the Stepper of chapter 09.
///
/// A step that leads to an overlap, or closer than the nodes resolve, is halved; so is a step that
/// takes bodies through each other.
class FreeSteps {
 public:
  /// Takes the settings of a scene.
  ///
  /// All arguments must outlive this.
  /// @param  solver      of the scene
  /// @param  schedule    that steps heed
  /// @param  instants    that solves the stages
  /// @param  statistics  that count rejected steps
  FreeSteps(const SuspensionSolver& solver, const OutputSchedule& schedule, InstantSolver& instants,
            RunStatistics& statistics);

  /// Prepares a step.
  ///
  /// @param  state  where it begins
  /// @param  flow   solution there
  /// @return        the flow
  StepStart begin(const RunState& state, TimedSolution flow) const;

  /// Takes a step.
  ///
  /// @param  state  where it begins
  /// @param  start  as begin() returned it
  /// @return        the step
  /// @throws SolverError when steps down to time.dt_min lead to inadmissible configurations, or
  ///                have errors that are not allowed
  /// @par Cost      a solve at the end, and one for each stage beyond the first
  TakenStep advance(const RunState& state, StepStart start);

 private:
  StepResult take_step(const TimePoint& start, const StepMemory& memory, const Rates& rates) const;

  const OutputSchedule& schedule_;
  InstantSolver& instants_;
  RunStatistics& statistics_;
  SteppingSettings settings_;
  PassingTest passing_;
};

/// @}

}  // namespace stokesbook
