#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "sweep/sweep.hpp"

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// Writes text as one cell of a CSV file.
///
/// @param  text  any text on one line
/// @return       the text; if it has commas or quotes, in double quotes, with its own quotes
///               doubled
std::string csv_cell(std::string_view text);

/// Returns the path of the FileLock that protects the files of the whole sweep.
///
/// @param  out  folder of the sweep
/// @return      path of the file `lock`
std::filesystem::path sweep_lock(const std::filesystem::path& out);

/// Lists the tasks of a sweep, and checks the scene of each.
///
/// @param  sweep  any sweep
/// @return        text of `tasks.csv`: `task,folder`, the axes, `seed` if the sweep has seeds, and
///                `scene`, a fingerprint of the task's whole scene
/// @throws SceneError as scene_of() does, and when two tasks have the same scene
std::string manifest(const Sweep& sweep);

/// Makes the folder of a sweep, or checks that an existing folder belongs to the same sweep.
///
/// @param  out       folder of the sweep
/// @param  manifest  manifest of the sweep
/// @throws RecordError when the folder cannot be written, or belongs to another sweep
void open_sweep(const std::filesystem::path& out, std::string_view manifest);

/// Checks that a folder belongs to a sweep, by its whole manifest.
///
/// @param  out       folder of the sweep
/// @param  manifest  manifest of the sweep
/// @throws RecordError when the folder belongs to no sweep or to another one
void require_sweep(const std::filesystem::path& out, std::string_view manifest);

/// Checks that a folder belongs to a sweep, by the row of one task in the manifest.
///
/// @param  out    folder of the sweep
/// @param  sweep  the sweep
/// @param  task   number of the task
/// @throws SceneError as scene_of() does
/// @throws RecordError when the folder belongs to no sweep, or when the task has other values or
///         another scene
void require_task(const std::filesystem::path& out, const Sweep& sweep, std::size_t task);

/// @}

}  // namespace stokesbook
