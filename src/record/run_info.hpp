#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// What a run has cost. Counts and seconds of a resumed run, but for its steps, are those of its last
/// start; all else is of the whole run.
struct RunTotals {
  long long steps = 0;                    ///< of time
  long long rejected_steps = 0;           ///< tries that were longer than the step that was taken
  long long solves = 0;                   ///< of the linear system
  long long gmres_iterations = 0;         ///< of all solves
  long long matvecs = 0;                  ///< applications of the operator
  long long ncp_iterations = 0;           ///< of all contact solves
  long long contact_solves = 0;           ///< of the linear system, for forces of contact
  double contact_seconds = 0.0;           ///< wall time that contact took
  long long halved_by_contact = 0;        ///< rejected steps whose contact was not resolved
  double largest_force_imbalance = 0.0;   ///< net contact force over the largest, of any step
  double largest_torque_imbalance = 0.0;  ///< net torque over the largest force and its distance
  double energy_injected = 0.0;           ///< work of contact on the bodies, force
};

/// How finely a run was resolved, and how well.
struct RunResolution {
  std::vector<int> first_nodes;      ///< of each component at its first solve: bodies, then walls
  std::vector<int> most_nodes;       ///< largest of all its solves
  double velocity_error = 0.0;       ///< largest estimate of all its solves
  double configuration_error = 0.0;  ///< of the errors of its steps, estimated and added up, the
                                     ///< largest: of positions in radii, and of angles
  std::map<std::string, double, std::less<>> field_errors{};  ///< by quantity, the largest estimate
                                                              ///< of all frames
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
  bool has_contact = false;       ///< whether contact is resolved: its totals are written then
  RunTotals totals;               ///< what it has cost
  RunResolution resolution;       ///< how well it was resolved
  std::optional<Complex> uniform_velocity;  ///< of the fluid at infinity at the end, where it is
                                            ///< solved for, length / time
  double wall_seconds = 0.0;                ///< how long it took since the last start
  long long peak_memory = 0;                ///< largest resident set since the last start, bytes
  std::optional<int> exit_status;           ///< of the program; none while it runs
  std::string message;                      ///< how the run ended, for people
};

/// Returns the text of `run.json`, keys in the order of the struct.
///
/// @param  info  of one run
/// @return       a JSON object in UTF-8; bytes that are not are replaced
std::string to_json(const RunInfo& info);

/// Reads how a run ended from its `run.json`.
///
/// @param  run  directory of the run
/// @return      its exit status; none where the run has not ended
/// @throws RecordError when the file cannot be read or is damaged
std::optional<int> exit_status_of(const std::filesystem::path& run);

/// @}

}  // namespace stokesbook
