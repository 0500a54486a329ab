#pragma once

#include <string>
#include <string_view>

namespace stokesbook {

/// What this program was built from, for `--version` and the record of a run.
struct BuildInfo {
  std::string_view version;  ///< of the project, "0.1.0"
  std::string_view
      git_hash;  ///< commit, with "-dirty" where the sources differ from it; or "unknown"
  std::string_view compiler;    ///< name and version, "GNU 12.2.0"
  std::string_view build_type;  ///< "Release"
  std::string_view flags;       ///< of the compiler, warnings left out
};

/// Returns the information compiled into this program.
BuildInfo build_info();

/// Returns the name of the processor that this program runs on, or "unknown".
std::string machine_name();

}  // namespace stokesbook
