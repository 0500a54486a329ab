#pragma once

#include <optional>

#include "suspension/contact/contact.hpp"
#include "suspension/motion/instant_solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The contact of a stage, resolved or not.
struct StageContact {
  ContactOutcome outcome;  ///< forces, and how their iteration ended
  Solution solution;       ///< with the contact forces, where they are resolved
  SolveCost cost;          ///< of the forces, and of the flow on more nodes
  double seconds = 0.0;    ///< wall time of the same
};

/// A step that is about to be taken.
struct StepStart {
  TimedSolution flow;                     ///< where the step begins, without contact forces
  double t_end;                           ///< planned end
  std::optional<StageContact> contact{};  ///< that acts from the beginning, in scenes with contact

  /// Returns what a frame shows.
  /// @return the solution with the contact forces, if there are any
  const Solution& solution() const { return contact ? contact->solution : flow.solution; }
};

/// A step that was taken.
struct TakenStep {
  Step step;                            ///< from state to state
  StepMemory memory;                    ///< for the next step
  TimedSolution end;                    ///< the flow at the end
  std::optional<CloserPairs> closer{};  ///< pairs that are still closer than contact allows
  StepInfo info;                        ///< what the step did
  Eigen::VectorXd error;                ///< estimated, of the state
};

/// @}

}  // namespace stokesbook
