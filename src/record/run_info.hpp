#pragma once

#include <string>
#include <vector>

namespace stokesbook {

/// @addtogroup record
/// @{

/// What a run has cost.
struct RunTotals {
  long long steps = 0;             ///< of time
  long long rejected_steps = 0;    ///< tries that were longer than the step that was taken
  long long solves = 0;            ///< of the linear system
  long long gmres_iterations = 0;  ///< of all solves
  long long matvecs = 0;           ///< applications of the operator
};

/// How finely a run was resolved, and how well.
struct RunResolution {
  std::vector<int> first_nodes;  ///< of each component at its first solve: bodies, then walls
  std::vector<int> most_nodes;   ///< largest of all its solves
  double error_estimate = 0.0;   ///< largest of all its solves
};

/// Where a run came from, what it decided and how it ended.
struct RunInfo {
  std::string version;            ///< of the program
  std::string git_hash;           ///< commit that was built
  std::string compiler;           ///< name and version
  std::string flags;              ///< of the compiler
  std::string machine;            ///< where it ran
  int threads = 1;                ///< in parallel regions
  std::vector<std::string> plan;  ///< one decision with its reason a line
  RunTotals totals;               ///< what it has cost
  RunResolution resolution;       ///< how well it was resolved
  double wall_seconds = 0.0;      ///< how long it took
  long long peak_memory = 0;      ///< largest resident set, bytes
  int exit_status = 0;            ///< of the program
  std::string message;            ///< how the run ended, for people
};

/// Returns the text of `run.json`, keys in the order of the struct.
///
/// @param  info  of one run
/// @return       a JSON object in UTF-8; bytes that are not are replaced
std::string to_json(const RunInfo& info);

/// @}

}  // namespace stokesbook
