#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "suspension/nodes/random_fill.hpp"

namespace stokesbook {

/// @name Exit codes
/// @{
inline constexpr int exit_done = 0;
inline constexpr int exit_bad_usage = 1;  ///< command line or scene
inline constexpr int exit_refused = 2;    ///< the solver refused; earlier results are kept
inline constexpr int exit_io = 3;
inline constexpr int exit_internal = 4;  ///< a defect of the program
/// @}

/// Options of `stokes run` and `stokes solve`.
struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path out;  ///< empty: the name of the scene, in out/
  std::vector<std::string> overrides;
  std::filesystem::path from{};       ///< folder of a run whose state is the start; empty: none
  std::optional<double> from_time{};  ///< time of this state; none: the last
  int threads = 0;                    ///< 0: all processors
  bool once = false;                  ///< true for stokes solve
  bool matrices = false;              ///< with once: also write the matrices of the free bodies
  bool dry_run = false;
  bool resume = false;
  bool overwrite = false;
  bool quiet = false;
  bool verify = false;  ///< true: a second run shows the error of the run
  double bound = 0.01;  ///< error of positions in radii, and of angles, for verification_report()
};

/// Reads a scene and places its fills.
/// @throws SceneError
FilledScene load_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                       bool needs_time = true);

/// Runs a scene, writes its files, and returns the exit code.
/// @throws SceneError, SolverError, RecordError
int run_scene(const RunOptions& options);

}  // namespace stokesbook
