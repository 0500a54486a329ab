#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "sweep/sweep.hpp"

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// A value that a task sets.
struct Setting {
  std::string key;   ///< path in the scene
  AxisValue chosen;  ///< of the axis
};

/// One run of a sweep, which depends on no other.
struct Task {
  std::size_t number;             ///< from 0
  std::vector<Setting> settings;  ///< one an axis, then the seed if the sweep has seeds

  /// Writes the values as the command line takes them.
  /// @return `key=value`, one a setting
  std::vector<std::string> overrides() const;

  /// Says which task this is.
  /// @return "task 7: fill.0.area_fraction = 0.1, seed = 3"
  std::string description() const;
};

/// Counts the runs that differ in their seeds only.
///
/// @param  sweep  any
/// @return        runs a combination of the axes' values, 1 without seeds
std::size_t runs_per_combination(const Sweep& sweep);

/// Counts the tasks.
///
/// @param  sweep  any
/// @return        number of combinations times runs_per_combination()
std::size_t task_count(const Sweep& sweep);

/// Returns a task. Runs that differ in their seeds only follow each other.
///
/// @param  sweep   any
/// @param  number  from 0 to task_count() - 1
/// @return         its values
Task task_of(const Sweep& sweep, std::size_t number);

/// Reads the scene of a task and checks that it defines the quantities to collect, and that seeds,
/// if there are several, change it.
///
/// @param  sweep  the sweep
/// @param  task   of the sweep
/// @return        the scene, checked as far as one can without solving
/// @throws SceneError at the first thing that is wrong; where it is a value of the sweep, its place
///         is that in the sweep file
SceneFile scene_of(const Sweep& sweep, const Task& task);

/// @}

}  // namespace stokesbook
