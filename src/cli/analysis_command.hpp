#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/search.hpp"

namespace stokesbook {

/// Prints the differences of two runs, and writes their picture into a directory unless it is empty.
/// @throws SceneError, RecordError
int compare_runs(const std::filesystem::path& run, const std::filesystem::path& reference,
                 const std::filesystem::path& out);

/// Writes the pictures of a run.
/// @param  bodies  bodies whose paths are drawn; empty: those of bodies_to_draw()
/// @param  out     directory; empty: that of the run
/// @throws SceneError, RecordError
int plot_run(const std::filesystem::path& run, std::vector<std::size_t> bodies,
             const std::filesystem::path& out);

/// Options of `stokes precision`.
struct PrecisionOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;
  Request request;
  std::filesystem::path out;  ///< empty: the name of the scene and "_precision", in out/
};

/// Searches for the cheapest settings of a scene, and writes a scene with them. Each run is a process
/// with one thread. Returns the exit code, which is exit_refused if there are no such settings.
/// @throws SceneError, RecordError
int find_precision(const PrecisionOptions& options);

/// Reports the error of a run, estimated by the run of its tightened() scene in the subfolder
/// "verify": at the end, when it exceeds a bound, and whether it grows exponentially.
/// @throws SceneError, RecordError
std::string verification_report(const std::filesystem::path& run, double bound);

}  // namespace stokesbook
