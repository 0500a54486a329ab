#pragma once

#include <array>
#include <optional>
#include <utility>

#include "record/checkpoint.hpp"
#include "suspension/contact/contact.hpp"
#include "suspension/motion/statistics.hpp"
#include "suspension/solver/density_history.hpp"
#include "time_stepping/stepper.hpp"

namespace stokesbook {

/// The results of earlier solves with which a solve begins.
struct SolveMemory {
  DensityHistory densities;            ///< from which GMRES begins
  DensityHistory stage_deviations{2};  ///< see InstantSolver::solve_stage()
  double stage_dt = 0.0;  ///< length of the step whose stage was the latest solve; 0: it was none
  std::vector<RigidMotion> motions{};  ///< of the latest solve, where a LoadFunction takes them
  MobilityColumns columns{};           ///< columns of the contact mobility in the stage before
  std::array<Eigen::VectorXd, 2>
      contact_velocities{};           ///< velocities that contact added in a step's stages
  Resolutions contact_resolutions{};  ///< nodes that the contact forces require; empty: none
  int steps_kept = 0;                 ///< steps taken with these resolutions
  double gmres_tolerance = 0.0;       ///< tolerance that the contact forces require
  double error_estimate = 0.0;        ///< the latest
  int solves_since_estimate = 0;      ///< solves since the latest error estimate
};

/// All that the rest of a run depends on.
struct RunState {
  TimePoint now;       ///< time and configuration, without a rate
  StepMemory steps{};  ///< memory of the steps so far
  SolveMemory solves;  ///< before the solve at `now`, which a resumed run takes again
  std::optional<CloserGaps> closer{};  ///< pairs that began closer than contact allows, and their
                                       ///< gaps; none in scenes without contact
  double last_written = -1.0;          ///< latest written time; -1: none
};

/// Packs a run for its checkpoint. Counts of work are left out: a resumed run takes the step under
/// way again, and would count that work twice.
Checkpoint to_checkpoint(const RunState& state, const RunStatistics& statistics);

/// Unpacks a run of the same scene, from its state at the start and statistics of no steps: the run
/// continues as if it had not stopped, bit for bit.
///
/// @throws std::out_of_range when the checkpoint lacks something
std::pair<RunState, RunStatistics> from_checkpoint(const Checkpoint& checkpoint, RunState state,
                                                   RunStatistics statistics);

}  // namespace stokesbook
