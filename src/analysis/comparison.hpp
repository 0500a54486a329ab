#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/run.hpp"

namespace stokesbook {

/// The difference of two runs in one quantity.
struct Difference {
  std::string name;            ///< "positions"
  bool of_rheology;            ///< whether the quantity describes the whole suspension
  double unit;                 ///< unit of the errors, in the unit of the quantity
  std::vector<double> errors;  ///< at each common time, the largest of all bodies or walls
};

/// The differences of two runs at the written times that they have in common.
struct Comparison {
  std::vector<double> t;                ///< common times
  std::vector<Difference> differences;  ///< quantities that both scenes define
  std::vector<double> trajectory;       ///< larger error of positions and angles at each time

  /// Returns the errors of a quantity.
  /// @throws SceneError when the scenes do not define the quantity
  const std::vector<double>& operator[](std::string_view quantity) const;

  /// Returns the largest error of all quantities of the whole suspension; 0 if there are none.
  double rheology() const;
};

/// Compares two runs of scenes with the same numbers of bodies and walls, without interpolation.
///
/// Errors of positions are in units of the largest body's radius, and errors of angles in radians.
/// All other errors are relative to the largest magnitude of the quantity in the second run.
/// @throws RecordError when the numbers of bodies or walls differ, or no written time is common
Comparison compare(const Run& run, const Run& reference);

/// Writes a table for the terminal: for each quantity the largest error, its time, the error at
/// the end, and the unit.
std::string to_text(const Comparison& comparison);

/// Plots the errors over time as SVG.
std::string draw(const Comparison& comparison);

/// The growth of an error.
struct Growth {
  double at_end;                  ///< error at the end
  std::optional<double> exceeds;  ///< first time at which the error exceeds a bound
  std::optional<double> rate;     ///< rate of exponential growth, 1 / time; none: no such growth
};

/// Judges the growth of an error over time.
///
/// The largest error so far, E(t), grows exponentially if it grows by a factor of 100 or more, and
/// if log E is nearly a linear function of t: the square of their correlation is at least 0.9, and
/// larger than that of log E and log t. The rate is the slope. Zeros and t = 0 are left out, as are
/// errors above 0.1, which are too large to grow freely.
Growth judge_growth(const std::vector<double>& t, const std::vector<double>& errors, double bound);

}  // namespace stokesbook
