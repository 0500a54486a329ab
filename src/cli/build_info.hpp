#pragma once

#include <string>
#include <string_view>

namespace stokesbook {

/// The origin of this program, for `--version` and the record of a run.
struct BuildInfo {
  std::string_view version;     ///< version of the project, "0.1.0"
  std::string_view git_hash;    ///< commit, or "unknown"; ends in "-dirty" if the sources differ
  std::string_view compiler;    ///< name and version, "GNU 12.2.0"
  std::string_view build_type;  ///< "Release"
  std::string_view flags;       ///< flags of the compiler, without those for warnings
};

/// Returns the information compiled into this program.
BuildInfo build_info();

/// Returns the name of the processor that this program runs on, or "unknown".
std::string machine_name();

}  // namespace stokesbook
