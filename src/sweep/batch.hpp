#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// Quotes a word so that a POSIX shell takes it literally.
///
/// @param  word  any word
/// @return       the word, in single quotes unless all its characters are harmless
std::string shell_quoted(std::string_view word);

/// Escapes a path for Slurm, which replaces patterns such as `%a` in paths.
///
/// @param  path  any path
/// @return       the path, with each % doubled
std::string in_slurm(std::string_view path);

/// The commands of a sweep that is to be run elsewhere.
struct Batch {
  std::vector<std::string> task;     ///< words of the command for a task, without its number
  std::vector<std::string> collect;  ///< words of the command that writes the results
  std::string output;                ///< file for the output of Slurm's jobs; `%a`: the task
  std::size_t tasks = 1;             ///< number of tasks, at least one
  int threads = 1;                   ///< threads of each task
};

/// Writes commands that run tasks elsewhere: as an array of Slurm jobs, and with GNU parallel.
///
/// @param  batch  commands of the sweep
/// @return        commands for a POSIX shell, with their titles as comments
std::string batch_commands(const Batch& batch);

/// @}

}  // namespace stokesbook
