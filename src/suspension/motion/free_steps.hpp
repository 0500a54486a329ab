#pragma once

#include <optional>
#include <string>

#include "suspension/contact/gap_constraints.hpp"
#include "suspension/motion/stepping.hpp"

namespace stokesbook {

/// Finds steps that take bodies through each other or through walls, in scenes without contact.
/// Neither end of such a step has an overlap: the bodies have changed sides.
class PassingTest {
 public:
  /// Takes the shapes of a scene. The solver must outlive the test.
  explicit PassingTest(const SuspensionSolver& solver);

  /// Looks for pairs that overlap on straight paths with uniform rotations. Overlaps of less than a
  /// hundredth of the smallest body's radius of gyration are not found.
  ///
  /// In a periodic cell, pairs of a component and an image are tested, too.
  ///
  /// @param  closest  least gap at the start, length: shorter steps need no search
  /// @param  start    poses on paths
  /// @param  lattice  of the step, in a periodic cell
  /// @return          a message that names the first such pair; empty if there is none
  /// @par Cost        O(components) where all steps are shorter than the least gap; else that of
  ///                  interferences()
  std::string describe_passing(const Configuration& start, const Configuration& end, double closest,
                               const std::optional<LatticeStep>& lattice = {}) const;

 private:
  const SuspensionSolver& solver_;
  double sag_;  // largest sag of the polygons
  ContactShapes shapes_;
};

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

  const SuspensionSolver& solver_;
  const OutputSchedule& schedule_;
  InstantSolver& instants_;
  RunStatistics& statistics_;
  SteppingSettings settings_;
  PassingTest passing_;
};

}  // namespace stokesbook
