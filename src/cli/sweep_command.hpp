#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace stokesbook {

/// Options of `stokes sweep`.
struct SweepOptions {
  std::filesystem::path file;
  std::filesystem::path out;        ///< empty: the name of the sweep, in out/
  std::optional<std::size_t> task;  ///< the only task to run
  int jobs = 0;                     ///< tasks at a time; 0: all processors
  int threads = 1;                  ///< threads of each task
  bool plan = false;
  bool collect = false;
  bool quiet = false;
};

/// Runs the tasks of a sweep that are not done and collects their results, or does only the part of
/// this that an option selects. Returns the exit code, which is exit_refused if a task failed.
/// @throws SceneError, SolverError, RecordError
int run_sweep(SweepOptions options);

}  // namespace stokesbook
