#pragma once

#include <string>
#include <vector>

#include "record/run_data.hpp"
#include "scene/scene.hpp"
#include "study/study.hpp"

namespace stokesbook::verification::suspension {

/// How a published experiment is run. All take own blocks as preconditioner, as published, so that
/// an iteration means the same, and guesses from earlier steps.
enum class Way {
  published,  ///< equal nodes as the scene has them, interpolation near curves, Euler's method
  steps,      ///< the same nodes, steps adapted to a tolerance: what steps alone gain
  ours        ///< automatic nodes, steps adapted to a tolerance
};

/// A published experiment, and what of it is compared.
struct Trial {
  std::string key;                      ///< of the figure
  std::string title;                    ///< of the figure
  std::string error;                    ///< of what is observed
  Scene (*scene)();                     ///< with published nodes, time.t_final and output.dt_write
  SteppingMethod adapted;               ///< that ours steps by
  std::vector<double> steps = {};       ///< of Euler's method, descending; the full study goes on
  std::vector<double> tolerances = {};  ///< of adapted steps, descending; the full study goes on
  /// What is observed of a run's frames: the bodies at the end, unless it is something else.
  std::vector<double> (*observed)(const std::vector<Frame>& frames) = nullptr;
  /// What errors are seen against, from the scene; none: bodies end where they began.
  Scene (*reference)(Scene scene) = nullptr;
  study::Size least = study::Size::full;  ///< least size of the study that has this trial
};

/// What a run has come to, and what it took.
struct Outcome {
  double error;  ///< largest of what is observed
  double pairs;  ///< millions, of nodes: applications of the operator to the most nodes of the run
  double steps;  ///< of time
  double seconds;  ///< of one thread
};

/// Runs a trial a way, from the longest step or loosest tolerance on.
///
/// The published method, which estimates no errors, is not charged for the operator's applications
/// in estimates, but for their seconds.
std::vector<Outcome> outcomes(const Trial& trial, Way way, study::Size size);

}  // namespace stokesbook::verification::suspension
