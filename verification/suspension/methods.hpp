#pragma once

#include <string>
#include <vector>

#include "record/run_data.hpp"
#include "scene/scene.hpp"
#include "study/study.hpp"

namespace stokesbook::verification::suspension {

/// The methods by which a published experiment is run. All methods precondition with the inverse of
/// each body's own block, as published, so that an iteration costs the same. All methods start from
/// guesses of earlier steps.
enum class Way {
  published,  ///< the published equal nodes, interpolation near curves, Euler's method
  steps,      ///< the same nodes, steps adapted to a tolerance: shows the gain by the steps alone
  ours        ///< automatic nodes, steps adapted to a tolerance
};

/// A published experiment, and the quantity that is compared.
struct Trial {
  std::string key;         ///< key of the figure
  std::string title;       ///< title of the figure
  std::string error;       ///< label of the error
  Scene (*scene)();        ///< returns the scene: published nodes, time.t_final, output.dt_write
  SteppingMethod adapted;  ///< method of the adapted steps
  std::vector<double> steps = {};       ///< Euler's steps, descending; the full study adds two
  std::vector<double> tolerances = {};  ///< step tolerances, descending; the full study adds two
  /// Returns the compared quantities of a run's frames; by default the bodies' states at the end.
  std::vector<double> (*observed)(const std::vector<Frame>& frames) = nullptr;
  /// Returns the scene of the reference; by default bodies must end where they began.
  Scene (*reference)(Scene scene) = nullptr;
  study::Size least = study::Size::full;  ///< least size of the study that has this trial
};

/// Error and cost of a run.
struct Outcome {
  double error;    ///< largest error of the compared quantities
  double pairs;    ///< millions: operator applications times (most nodes of the run)^2
  double steps;    ///< time steps
  double seconds;  ///< seconds of one thread
};

/// Runs a trial by a method, beginning with the longest step or loosest tolerance.
///
/// The published method estimates no errors. Its pairs therefore exclude the operator's
/// applications for estimates; its seconds include them.
std::vector<Outcome> outcomes(const Trial& trial, Way way, study::Size size);

}  // namespace stokesbook::verification::suspension
