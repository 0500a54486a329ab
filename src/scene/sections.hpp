#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "scene/table_reader.hpp"

/// The sections of a scene file, each read on its own. `directory` is where files are looked for;
/// all throw SceneError.
namespace stokesbook::scene_text {

/// Reads the shape of a wall, body, list or fill.
Shape read_shape(const TableReader& owner, const std::filesystem::path& directory);

/// Reads [[walls]].
std::vector<Wall> read_walls(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[bodies]].
std::vector<Body> read_bodies(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[body_lists]]: each row of each file is a body.
std::vector<Body> read_body_lists(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[fill]].
///
/// @param  root       the whole scene
/// @param  directory  of the scene file
/// @param  enclosed   whether there is an outer wall
std::vector<Fill> read_fills(const TableReader& root, const std::filesystem::path& directory,
                             bool enclosed);

/// What drives the fluid from far away, and when all driving turns around.
struct FlowSection {
  BackgroundFlow flow;
  std::optional<double> gauge_length;
  std::vector<double> reverse_at;
};

/// Reads [flow].
///
/// @param  root      the whole scene
/// @param  enclosed  whether there is an outer wall
FlowSection read_flow(const TableReader& root, bool enclosed);

/// Reads [solver].
SolverSettings read_solver(const TableReader& root);

/// Reads [time], nothing when the scene has none.
std::optional<TimeSettings> read_time(const TableReader& root);

/// Reads [output].
OutputSettings read_output(const TableReader& root);

}  // namespace stokesbook::scene_text
