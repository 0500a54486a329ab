#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace stokesbook {

/// @addtogroup record
/// @{

/// A file could not be read or written; the message names the file and the reason.
struct RecordError : std::runtime_error {
  /// Says what is wrong with a file.
  /// @param  path    of the file
  /// @param  reason  what is wrong, to follow its name
  RecordError(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error(path.string() + ": " + reason) {}

  /// Says what the system refused.
  /// @param  path    of the file
  /// @param  action  what failed: "writing"
  /// @param  cause   the system's reason
  RecordError(const std::filesystem::path& path, const std::string& action, std::error_code cause)
      : RecordError(path, action + " failed: " + cause.message()) {}
};

/// @}

}  // namespace stokesbook
