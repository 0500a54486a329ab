#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// Writes a word so that a POSIX shell takes it as it is.
///
/// @param  word  any
/// @return       the word; in single quotes unless it is made of harmless letters
std::string shell_quoted(std::string_view word);

/// Writes a path so that Slurm takes it as it is, where it looks for patterns such as `%a`.
///
/// @param  path  any
/// @return       the path, each % doubled
std::string in_slurm(std::string_view path);

/// What is to be run elsewhere.
struct Batch {
  std::vector<std::string> task;     ///< words of the command that runs a task, but its number
  std::vector<std::string> collect;  ///< words of the command that writes the results
  std::string output;                ///< what Slurm's jobs print; `%a` stands for the task
  std::size_t tasks = 1;             ///< how many there are, one at least
  int threads = 1;                   ///< of each
};

/// Says how to run tasks elsewhere: as an array of jobs of Slurm, and by GNU parallel.
///
/// @param  batch  what is to be run
/// @return        commands for a POSIX shell, with their titles as comments
std::string batch_commands(const Batch& batch);

/// @}

}  // namespace stokesbook
