#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// Totals of a run. For a resumed run, counts and seconds begin at the last start, except the
/// number of steps; the number of steps, the imbalances and the energy are those of the whole run.
struct RunTotals {
  long long steps = 0;                    ///< time steps
  long long rejected_steps = 0;           ///< attempts with a longer step than the accepted one
  long long solves = 0;                   ///< solves of the linear system
  long long gmres_iterations = 0;         ///< GMRES iterations of all solves
  long long matvecs = 0;                  ///< applications of the operator
  long long ncp_iterations = 0;           ///< iterations of the contact solver
  long long contact_solves = 0;           ///< solves of the linear system for contact forces
  double contact_seconds = 0.0;           ///< wall time of the contact solver
  long long halved_by_contact = 0;        ///< rejected steps whose contact was not resolved
  double largest_force_imbalance = 0.0;   ///< largest StepInfo::force_imbalance
  double largest_torque_imbalance = 0.0;  ///< largest StepInfo::torque_imbalance
  double energy_injected = 0.0;           ///< sum of StepInfo::energy_injected, force
};

/// Numbers of nodes and error estimates of a run.
struct RunResolution {
  std::vector<int> first_nodes;  ///< nodes of each component at the first solve: bodies, then walls
  std::vector<int> most_nodes;   ///< largest number of nodes of each component in all solves
  double velocity_error = 0.0;   ///< largest estimate of all solves, relative
  double configuration_error = 0.0;  ///< largest component of the sum of all estimated step errors:
                                     ///< positions in radii, angles in radians
  std::map<std::string, double, std::less<>> field_errors{};  ///< largest of all frames,
                                                              ///< by quantity
};

/// Origin, plan, results and end of a run, for `run.json`.
struct RunInfo {
  std::string version;            ///< version of the program
  std::string git_hash;           ///< commit of the sources
  std::string compiler;           ///< name and version
  std::string flags;              ///< flags of the compiler
  std::string machine;            ///< name of the processor
  int threads = 1;                ///< in parallel regions
  std::vector<std::string> plan;  ///< one line for each decision and its reason
  bool has_contact = false;       ///< whether contact is resolved; if so, its totals are written
  RunTotals totals;               ///< cost of the run
  RunResolution resolution;       ///< nodes and error estimates
  /// Velocity of the fluid at infinity at the last frame, if it is solved for, length / time.
  std::optional<Complex> uniform_velocity;
  double wall_seconds = 0.0;       ///< wall time since the last start
  long long peak_memory = 0;       ///< largest resident set since the last start, bytes
  std::optional<int> exit_status;  ///< exit status of the program; none while it runs
  std::string message;             ///< description of how the run ended
};

/// Returns the text of `run.json`: a JSON object in UTF-8, keys in the order of the struct. Bytes
/// that are not valid UTF-8 are replaced.
std::string to_json(const RunInfo& info);

/// Reads the exit status of a run from the `run.json` in its directory; none if the run has not
/// ended or not begun.
/// @throws RecordError when the file cannot be read or is damaged
std::optional<int> exit_status_of(const std::filesystem::path& run);

/// Reads RunResolution::most_nodes of a run that has ended.
/// @throws RecordError when the file cannot be read or is damaged
std::vector<int> most_nodes_of(const std::filesystem::path& run);

}  // namespace stokesbook
