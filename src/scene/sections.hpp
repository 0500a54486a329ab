#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "scene/table_reader.hpp"

/// Readers for the larger sections of a scene file, one function for each section. Each throws a
/// SceneError at the first error. `root` is the whole scene, `directory` the folder that file names
/// are relative to. Lists are in file order, and missing sections have their defaults.
namespace stokesbook::scene_text {

/// Reads the key `shape` of a wall, body, body list or fill.
Shape read_shape(const TableReader& owner, const std::filesystem::path& directory);

/// Reads the key `slip` of a body, body list or fill; none if the key is missing.
std::optional<Slip> read_slip(const TableReader& owner, const std::filesystem::path& directory);

/// Reads the key `motion` of a wall; a fixed wall if the key is missing.
WallMotion read_motion(const TableReader& wall, const Shape& shape,
                       const std::filesystem::path& directory);

/// Reads [[walls]], of which at most one may be outer.
std::vector<Wall> read_walls(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[bodies]], then [[body_lists]], in which each row of each file is a body.
std::vector<Body> read_bodies(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[fill]].
/// @param  enclosed  whether there is an outer wall
std::vector<Fill> read_fills(const TableReader& root, const std::filesystem::path& directory,
                             bool enclosed);

/// Reads [[tracers]]: the points of lists and grids.
std::vector<Complex> read_tracers(const TableReader& root);

/// Reads [time].
std::optional<TimeSettings> read_time(const TableReader& root);

/// Returns a scene whose solver.tolerance is at most most_solver_over_step times its
/// time.tolerance, if steps are adapted. The one that is not given follows the other.
/// @throws SceneError when both are given and do not match
Scene with_matched_tolerances(const TableReader& root, Scene scene);

/// Reads [contact].
/// @param  file  the sections read before: bodies, fills and time, which must allow contact
std::optional<ContactSettings> read_contact(const TableReader& root, const SceneFile& file);

/// Reads [cell], and refuses what a cell excludes.
/// @param  file  all other sections
std::optional<CellSettings> read_cell(const TableReader& root, const SceneFile& file);

/// Reads [output].
OutputSettings read_output(const TableReader& root);

}  // namespace stokesbook::scene_text
