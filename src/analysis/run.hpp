#pragma once

#include <filesystem>
#include <vector>

#include "record/csv.hpp"
#include "record/run_data.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// The scene and the tables of a run.
struct Run {
  std::filesystem::path path;  ///< folder
  Scene scene{};               ///< with all bodies
  NumberTable rheology{};      ///< a row for each written time
  NumberTable bodies{};        ///< a row for each body and written time
  NumberTable walls{};         ///< a row for each wall and written time; empty without walls
  NumberTable steps{};         ///< a row for each step

  /// Returns the written times.
  const std::vector<double>& times() const { return rheology["t"]; }
};

/// Reads a run from its folder.
/// @throws RecordError when the folder has no tables, or when a table is damaged
/// @throws SceneError when scene.toml is damaged
Run read_run(const std::filesystem::path& path);

/// Returns the pose and the motion of a body in a row of trajectory.csv; without its load.
BodyState body_state(const NumberTable& bodies, std::size_t row);

/// Returns the largest distance of a body's boundary from its position: the unit of errors of
/// positions, as for time.tolerance. Returns 1 if there are no bodies.
double largest_radius(const Scene& scene);

}  // namespace stokesbook
