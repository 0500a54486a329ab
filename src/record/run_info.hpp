#pragma once

#include <string>
#include <vector>

namespace stokesbook {

/// @addtogroup record
/// @{

/// What a run has cost.
struct RunTotals {
  long long steps = 0;
  long long solves = 0;
  long long gmres_iterations = 0;
  long long matvecs = 0;
};

/// Where a run came from, what it decided and how it ended.
struct RunInfo {
  std::string version;
  std::string git_hash;
  std::string compiler;
  std::string flags;
  std::string machine;
  int threads = 1;
  std::vector<std::string> plan;  ///< one decision with its reason a line
  RunTotals totals;
  double wall_seconds = 0.0;
  int exit_status = 0;
  std::string message;  ///< how the run ended, for people
};

/// Returns the text of run.json, keys in the order of the struct.
std::string to_json(const RunInfo& info);

/// @}

}  // namespace stokesbook
