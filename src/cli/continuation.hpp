#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "record/run_directory.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// The way in which a run goes on.
struct Continuation {
  std::optional<ChangedScene> change{};  ///< none if the scene is that of the last checkpoint
  bool is_extension = false;  ///< only the end is later: the files become those of one longer run
  bool from_start = false;    ///< an extension, and every step depended on the end
  std::string keys{};         ///< keys that differ, "time.t_final = 2.0 (so far 1.0)"
};

/// Compares a scene with that of the run in a folder, and decides how the run goes on. An extended
/// run goes on from a checkpoint that does not depend on the end, other runs from the last one.
///
/// @param  text  resolved text of the scene
/// @throws SceneError that names each key that may not differ, with the reason
/// @throws RecordError when the files of the run cannot be read or do not match
Continuation find_continuation(const std::filesystem::path& out, const Scene& scene,
                               const std::string& text);

/// Places the bodies and walls of a scene, and in a periodic cell the lattice, where another run
/// has written them; all else is kept.
///
/// @param  path  folder of a run with tables
/// @param  time  a written time of the run; none: the last one
/// @throws SceneError when the run has other bodies or walls, or a cell of another area, or has not
///         written the state
/// @throws RecordError as read_run() does, and when the checkpoint of a run with walls cannot be
///         read
Scene start_from(Scene scene, const std::filesystem::path& path, std::optional<double> time);

}  // namespace stokesbook
