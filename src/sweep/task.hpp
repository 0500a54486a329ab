#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "sweep/sweep.hpp"

namespace stokesbook {

/// A key of the scene and the value that a task sets.
struct Setting {
  std::string key;   ///< path in the scene
  AxisValue chosen;  ///< value of the axis
};

/// A run of a sweep, independent of all other runs.
struct Task {
  std::size_t number;  ///< from 0; gives its folder, and stays when a sweep takes more values
  std::vector<Setting> settings;  ///< one for each key, then the seed if the sweep has seeds

  /// Writes each setting in the form of the command line, `key=value`.
  std::vector<std::string> overrides() const;

  /// Describes the task in one line, "task 7: fill.0.area_fraction = 0.1, seed = 3".
  std::string description() const;
};

/// Counts the tasks: the number of combinations times runs_per_combination().
std::size_t task_count(const Sweep& sweep);

/// Returns the task at a place below task_count(), with this place as its number. Tasks that differ
/// only in their seeds have consecutive places.
Task task_of(const Sweep& sweep, std::size_t place);

/// Reads the scene of a task, and checks it as far as is possible without a solve. The function
/// also checks that the scene defines the quantities to collect, and that several seeds give
/// different runs.
///
/// @throws SceneError at the first error; for a value of the sweep, the message names its place in
///         the sweep file
SceneFile scene_of(const Sweep& sweep, const Task& task);

}  // namespace stokesbook
