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
/// @param  text  any, on one line
/// @return       the text; in double quotes, with those in it doubled, if it has commas or quotes
std::string csv_cell(std::string_view text);

/// Returns the FileLock of who writes a file about the whole sweep.
///
/// @param  out  folder of the sweep
/// @return      path of `lock`
std::filesystem::path sweep_lock(const std::filesystem::path& out);

/// Lists the tasks of a sweep, and checks the scene of each.
///
/// @param  sweep  any
/// @return        text of `tasks.csv`: `task,folder`, the axes, `seed` if the sweep has seeds, and
///                `scene`, a fingerprint of all that the task's scene says
/// @throws SceneError as scene_of() does, and when two tasks have the same scene
std::string manifest(const Sweep& sweep);

/// Makes the folder of a sweep, or finds that it is the same sweep's.
///
/// @param  out       folder
/// @param  manifest  of the sweep
/// @throws RecordError when the folder cannot be written, or holds another sweep
void open_sweep(const std::filesystem::path& out, std::string_view manifest);

/// Checks that a folder holds a sweep, all of it.
///
/// @param  out       folder
/// @param  manifest  of the sweep
/// @throws RecordError when the folder holds no sweep or another one
void require_sweep(const std::filesystem::path& out, std::string_view manifest);

/// Checks that a folder holds the sweep, as far as one task tells.
///
/// @param  out    folder
/// @param  sweep  the sweep
/// @param  task   number of the task
/// @throws SceneError as scene_of() does
/// @throws RecordError when the folder holds no sweep, or the task has other
/// values or another scene
void require_task(const std::filesystem::path& out, const Sweep& sweep, std::size_t task);

/// @}

}  // namespace stokesbook
