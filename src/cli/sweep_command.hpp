#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

namespace stokesbook {

/// What the command line asks of `stokes sweep`.
struct SweepOptions {
  std::filesystem::path program;  ///< name that this program was called by
  std::filesystem::path file;
  std::filesystem::path out;        ///< empty: out/ and the name of the sweep
  std::optional<std::size_t> task;  ///< this one only
  int jobs = 0;                     ///< tasks at a time; 0: all processors
  int threads = 1;                  ///< of each task
  bool plan = false;
  bool collect = false;
  bool quiet = false;
};

/// Runs the tasks of a sweep that are not done and collects their results, or one part of that;
/// returns the exit code, exit_refused if a task failed.
///
/// @throws SceneError, NumericsRefused, RecordError
int run_sweep(const SweepOptions& options);

}  // namespace stokesbook
