#pragma once

#include "suspension/contact/passing.hpp"
#include "suspension/motion/stepping.hpp"

namespace stokesbook {

/// Takes the steps of a scene without contact, by the Stepper of chapter 09.
///
/// A step that leads to an overlap, or closer than the nodes resolve, is halved; so is a step that
/// takes bodies through each other.
class FreeSteps : public Steps {
 public:
  /// All arguments must outlive this.
  FreeSteps(const SuspensionSolver& solver, const OutputSchedule& schedule, InstantSolver& instants,
            RunStatistics& statistics);

  /// Plans a step to the next event.
  StepStart begin(const RunState& state, TimedSolution flow) override;

  /// Takes a step.
  TakenStep advance(const RunState& state, StepStart start) override;

 private:
  StepResult take_step(const TimePoint& start, const StepMemory& memory, const Rates& rates) const;

  const OutputSchedule& schedule_;
  InstantSolver& instants_;
  RunStatistics& statistics_;
  SteppingSettings settings_;
  PassingTest passing_;
};

}  // namespace stokesbook
