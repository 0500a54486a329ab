#pragma once

#include <string>

#include "suspension/contact/contact.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Sees where a step takes bodies through each other or through walls, in scenes without contact.
///
/// Neither end of such a step overlaps: bodies are on each other's sides.
class PassingTest {
 public:
  /// Takes the shapes of a scene.
  ///
  /// @param  solver  of the scene; must outlive the test
  explicit PassingTest(const SuspensionSolver& solver);

  /// Looks for pairs that overlap on straight paths, which turn evenly. Overlaps of less than a
  /// hundredth of the smallest body's radius of gyration are not seen.
  ///
  /// @param  start    where the paths begin, without overlaps
  /// @param  end      where they end
  /// @param  closest  least gap at their beginning, length: steps shorter than that need no look
  /// @return          a message naming the first such pair; empty where there is none
  /// @par Cost        O(components) where all steps are shorter than the least gap; else that of
  ///                  interferences()
  std::string error(const Configuration& start, const Configuration& end, double closest) const;

 private:
  bool is_short(const Configuration& start, const Configuration& end, double closest) const;

  const SuspensionSolver& solver_;
  double sag_;  // of polygons, at most
  ContactShapes shapes_;
};

/// @}

}  // namespace stokesbook
