#pragma once

#include <cstddef>

#include "suspension/contact/contact.hpp"
#include "suspension/motion/instant_solver.hpp"
#include "suspension/motion/output_schedule.hpp"
#include "suspension/motion/taken_step.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Takes the steps of a scene with contact, by Euler's or Heun's method.
///
/// The velocity of a step is the one that keeps the separation at the step's end; the forces of
/// contact act from its beginning, and frames show them. By Heun's method contact is resolved a
/// second time, at the state that the first half leads to. Steps whose contact is not resolved are
/// halved. With time.tolerance steps are adapted by step_factor(): the error of a step is the
/// largest distance of a boundary point between the first half, which is Euler's method, and the
/// whole step. A step is also so short that bodies near each other do not move past each other by
/// more than the ratio of the smaller one's area and perimeter.
class ContactSteps {
 public:
  /// Takes the settings of a scene.
  ///
  /// All arguments must outlive this.
  /// @param  solver      of a scene with [contact]
  /// @param  schedule    that steps heed
  /// @param  instants    that solves the stages
  /// @param  statistics  that count the work of contact
  ContactSteps(const SuspensionSolver& solver, const OutputSchedule& schedule,
               InstantSolver& instants, RunStatistics& statistics);

  /// Finds the pairs that begin closer than the separation.
  ///
  /// @param  start  where the run begins
  /// @return        these pairs and their gaps
  /// @throws ConfigurationError as SuspensionContact::admit_start() does
  CloserPairs admit_start(const Configuration& start) const;

  /// Makes the step so short that only gaps as narrow as the separation may close: the fastest
  /// boundary moves by a hundredth of the separation.
  ///
  /// @param  flow  at the beginning of the step
  void step_for_an_instant(const Solution& flow);

  /// Resolves the contact with which a step begins. The contact depends on the length of the step:
  /// a step whose contact cannot be resolved is halved.
  ///
  /// @param  state  where it begins
  /// @param  flow   solution there, without contact forces
  /// @return        the flow, the contact, and the end of the step
  /// @throws SolverError when contact of steps down to time.dt_min is not resolved
  StepStart begin(const RunState& state, TimedSolution flow);

  /// Takes a step.
  ///
  /// @param  state  where it begins
  /// @param  start  as begin() returned it
  /// @return        the step
  /// @throws SolverError when steps down to time.dt_min lead to inadmissible configurations, or
  ///                have errors that are not allowed
  TakenStep advance(const RunState& state, StepStart start);

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  // A stage of a step. The mean velocity of the step is `known`, plus `share` times the velocity of
  // the flow and of contact at `acting`.
  struct Stage {
    double t;  // where its forces act
    double dt;
    Configuration start, acting;
    double share;
    Eigen::VectorXd known;
    std::size_t index;    // in its step
    int most_iterations;  // linear complementarity problems
  };
  struct ResolvedStage {
    TimedSolution flow;  // on as many nodes as the contact forces require
    StageContact contact;
  };
  // The second stage of a step by Heun's method.
  struct SecondStage {
    ContactOutcome outcome;  // with the mean velocity of the step
    Eigen::VectorXd error;   // of the first half
    double scaled_error;     // largest distance of a boundary point, over what is allowed
  };
  /// @endcond
  double planned_dt(const StepMemory& memory) const;
  double planned_end(const RunState& state) const;
  double end_within_scene(const RunState& state, const Solution& flow, double t_end) const;
  double end_within_reach(const RunState& state, const Solution& flow, double t_end) const;
  double shortened(double t, double t_end, double factor, const std::string& reason);
  StepStart begin(const RunState& state, TimedSolution flow, double t_end);
  ResolvedStage resolve(const Stage& stage, TimedSolution flow, const CloserPairs& closer);
  LoadedCheck check(const TimedSolution& flow, const StageContact& contact) const;
  SecondStage second_stage(const RunState& state, const StepStart& start, StepInfo& info);
  TakenStep finish(const RunState& state, const StepStart& start, const SecondStage* second,
                   StepInfo info, bool rejected);
  double next_dt(const RunState& state, const StepStart& start, const SecondStage* second,
                 bool rejected) const;
  void relax_contact(bool in_contact);

  const SuspensionSolver& solver_;
  const OutputSchedule& schedule_;
  InstantSolver& instants_;
  RunStatistics& statistics_;
  TimeSettings time_;
  SteppingSettings settings_;
  SuspensionContact contact_;
};

/// @}

}  // namespace stokesbook
