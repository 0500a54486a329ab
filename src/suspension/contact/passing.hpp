#pragma once

#include <string>

#include "suspension/contact/gap_constraints.hpp"
#include "suspension/solver/solver.hpp"

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
  /// @param  closest  least gap at the start, length: shorter steps need no search
  /// @return          a message that names the first such pair; empty if there is none
  /// @par Cost        O(components) where all steps are shorter than the least gap; else that of
  ///                  interferences()
  std::string error(const Configuration& start, const Configuration& end, double closest) const;

 private:
  const SuspensionSolver& solver_;
  double sag_;  // of polygons, at most
  ContactShapes shapes_;
};

}  // namespace stokesbook
