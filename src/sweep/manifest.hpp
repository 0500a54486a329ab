#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "sweep/sweep.hpp"

namespace stokesbook {

/// Writes text on one line as a cell of a CSV file: if the text has commas or quotes, in double
/// quotes, with its own quotes doubled.
std::string csv_cell(std::string_view text);

/// Returns the path of the FileLock that protects the files of the whole sweep.
std::filesystem::path sweep_lock(const std::filesystem::path& out);

/// Writes `tasks.csv`, the list of a sweep's tasks, and checks the scene of each.
///
/// The columns are `task,folder`, the axes, `seed` if the sweep has seeds, and `scene`, a
/// fingerprint of the task's whole scene.
/// @throws SceneError as scene_of() does, and when two tasks have the same scene
std::string manifest(const Sweep& sweep);

/// Makes the folder of a sweep with its manifest and the folders of its tasks, or checks that an
/// existing folder belongs to the same sweep.
///
/// @throws SceneError as manifest() does
/// @throws RecordError when the folder cannot be written, or belongs to another sweep
void open_sweep(const std::filesystem::path& out, const Sweep& sweep);

/// Checks that a folder belongs to a sweep, by its whole manifest.
///
/// @throws SceneError as manifest() does
/// @throws RecordError when the folder belongs to no sweep or to another one
void require_sweep(const std::filesystem::path& out, const Sweep& sweep);

/// Checks that a folder belongs to a sweep, by the row of one task in the manifest.
///
/// @throws SceneError as scene_of() does
/// @throws RecordError when the folder belongs to no sweep, or when the task has other values or
///         another scene
void require_task(const std::filesystem::path& out, const Sweep& sweep, std::size_t task);

}  // namespace stokesbook
