#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup record
/// @{

/// What a solver needs to go on exactly where it stopped.
struct Checkpoint {
  double t = 0.0;         ///< time reached, or the beginning of a step that is to be repeated
  long long step = 0;     ///< steps done
  Eigen::VectorXd state;  ///< what the solver advances, in its own order
  /// What the time stepper remembers, by name (one word each): earlier rates, the next step's
  /// length, the last time on record.
  std::map<std::string, Eigen::VectorXd> history;
};

/// A checkpoint, and what the run directory held at that moment.
struct SavedRun {
  std::string scene;                                  ///< fingerprint of the scene
  std::string program;                                ///< fingerprint of the program that saved it
  std::map<std::string, std::uintmax_t> table_sizes;  ///< bytes, by file name
  std::vector<double> frame_times;                    ///< one a written frame
  Checkpoint checkpoint;                              ///< what the solver goes on from
};

/// Returns 16 hexadecimal digits that differ when texts differ, but for a chance of 2^-64.
///
/// The 64-bit FNV-1a hash; it finds accidents, not forgeries.
/// @param  text  any bytes
/// @return       its hash
std::string fingerprint(std::string_view text);

/// Writes a saved run as text whose numbers are hexadecimal floats, hence exact, and whose last
/// line is the fingerprint of all before it.
///
/// @param  saved  names of tables and of the history are one word each
/// @return        text of the file `checkpoint`
/// @throws std::invalid_argument when a name of the history is not one word
std::string to_text(const SavedRun& saved);

/// Reads what to_text() wrote, bit for bit.
///
/// @param  path  of the file `checkpoint`
/// @return       what was saved
/// @throws RecordError when the file is missing, of another kind, damaged or cut short
SavedRun read_saved_run(const std::filesystem::path& path);

/// @}

}  // namespace stokesbook
