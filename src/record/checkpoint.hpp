#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace stokesbook {

/// The data that a solver requires to continue exactly where it stopped.
struct Checkpoint {
  double t = 0.0;         ///< time reached; beginning of the step if a step is to be repeated
  long long step = 0;     ///< number of completed steps
  Eigen::VectorXd state;  ///< unknowns that the solver advances, in its own order
  /// Data from earlier times that the next steps require, by name, such as earlier rates, the
  /// length of the next step and the last written time.
  std::map<std::string, Eigen::VectorXd> history;
};

/// A checkpoint, and the extent of the run directory's files at that moment.
struct SavedRun {
  std::string scene;                                  ///< fingerprint of the scene
  std::string program;                                ///< fingerprint of the saving program
  std::map<std::string, std::uintmax_t> table_sizes;  ///< bytes of each growing file, by name
  std::vector<double> frame_times;                    ///< times of the written frames
  Checkpoint checkpoint;                              ///< data from which the solver continues
};

/// Writes a saved run as the text of a file `checkpoint`: JSON, with numbers that restore the
/// values exactly. The last line is the fingerprint of all text before it.
std::string to_text(const SavedRun& saved);

/// Reads a saved run from a file with the text of to_text(); all numbers are restored bit for bit.
/// @throws RecordError when the file is missing, of another kind, damaged or cut short
SavedRun read_saved_run(const std::filesystem::path& path);

}  // namespace stokesbook
