#pragma once

#include "suspension/motion/stepping.hpp"

namespace stokesbook {

/// Takes the steps of a scene with contact, by Euler's or Heun's method.
///
/// The velocity of a step is the one that keeps the separation at the step's end; the forces of
/// contact act from its beginning, and frames show them. By Heun's method contact is resolved a
/// second time, at the state that the first half leads to. Steps whose contact is not resolved are
/// halved. With time.tolerance steps are adapted by step_factor(): the error of a step is the
/// largest distance of a boundary point between the first half, which is Euler's method, and the
/// whole step. A step is also so short that bodies near each other do not move past each other by
/// more than the ratio of the smaller one's area and perimeter.
class ContactSteps : public Steps {
 public:
  /// Requires the solver of a scene with [contact]. All arguments must outlive this.
  ContactSteps(const SuspensionSolver& solver, const OutputSchedule& schedule,
               InstantSolver& instants, RunStatistics& statistics);

  /// Finds the pairs that begin closer than the separation.
  std::optional<CloserGaps> admit_start(const TimePoint& start) const override;

  /// Resolves the contact with which a step begins. The contact depends on the length of the step:
  /// a step whose contact cannot be resolved is halved.
  ///
  /// In a scene without [time] the step is so short that only gaps as narrow as the separation may
  /// close: the fastest boundary moves by a hundredth of the separation.
  StepStart begin(const RunState& state, TimedSolution flow) override;

  /// Takes a step.
  TakenStep advance(const RunState& state, StepStart start) override;

 private:
  // The second stage of a step by Heun's method.
  struct SecondStage {
    StepInfo info;           // data of the step so far
    ContactOutcome outcome;  // with the mean velocity of the step
    Eigen::VectorXd rate;    // mean velocity of the step
    Eigen::VectorXd error;   // error of the first half
    double scaled_error;     // largest distance of a boundary point, over what is allowed
  };
  double planned_end(const RunState& state) const;
  Placement placement(double t, const Configuration& paths) const;
  double shorten(double t, double t_end, double factor, const std::string& reason);
  StepStart begin(const RunState& state, TimedSolution flow, double t_end);
  SecondStage second_stage(const RunState& state, const StepStart& start, const StepInfo& info);
  TakenStep finish(const RunState& state, const StepStart& start,
                   const std::optional<SecondStage>& second, StepInfo info, bool rejected);
  std::string warning(const StepMemory& memory);
  double next_dt(const RunState& state, const StepStart& start,
                 const std::optional<SecondStage>& second, bool rejected) const;

  const SuspensionSolver& solver_;
  const OutputSchedule& schedule_;
  InstantSolver& instants_;
  RunStatistics& statistics_;
  TimeSettings time_;
  SteppingSettings settings_;
  SuspensionContact contact_;
  ContactStages stages_;
  std::string limit_;        // why a step was shortened last
  bool has_warned_ = false;  // of steps that are far shorter than time.dt
};

}  // namespace stokesbook
