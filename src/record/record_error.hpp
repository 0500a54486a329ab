#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace stokesbook {

/// A file could not be read or written; the message names the file and the reason.
struct RecordError : std::runtime_error {
  /// Constructs the message `path: reason`.
  RecordError(const std::filesystem::path& path, const std::string& reason)
      : std::runtime_error(path.string() + ": " + reason) {}

  /// Constructs the message `path: action failed: cause`, with an action such as "writing".
  RecordError(const std::filesystem::path& path, const std::string& action, std::error_code cause)
      : RecordError(path, action + " failed: " + cause.message()) {}
};

}  // namespace stokesbook
