#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "scene/table_reader.hpp"

/// The sections of a scene file, each read on its own.
namespace stokesbook::scene_text {

/// Reads the shape of a wall, body, list or fill.
///
/// @param  owner      table with the key `shape`
/// @param  directory  where files are looked for
/// @return            the shape, in its own frame
/// @throws SceneError at the first thing that is wrong
Shape read_shape(const TableReader& owner, const std::filesystem::path& directory);

/// Reads [[walls]].
///
/// @param  root       the whole scene
/// @param  directory  where files are looked for
/// @return            walls in file order, at most one of them outer
/// @throws SceneError at the first thing that is wrong
std::vector<Wall> read_walls(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[bodies]].
///
/// @param  root       the whole scene
/// @param  directory  where files are looked for
/// @return            bodies in file order
/// @throws SceneError at the first thing that is wrong
std::vector<Body> read_bodies(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[body_lists]]: each row of each file is a body.
///
/// @param  root       the whole scene
/// @param  directory  where files are looked for
/// @return            bodies in file order
/// @throws SceneError at the first thing that is wrong
std::vector<Body> read_body_lists(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[fill]].
///
/// @param  root       the whole scene
/// @param  directory  where files are looked for
/// @param  enclosed   whether there is an outer wall
/// @return            fills in file order
/// @throws SceneError at the first thing that is wrong
std::vector<Fill> read_fills(const TableReader& root, const std::filesystem::path& directory,
                             bool enclosed);

/// What drives the fluid from far away, and when all driving turns around.
struct FlowSection {
  BackgroundFlow flow;                 ///< quiescent where a wall encloses the fluid
  std::optional<double> gauge_length;  ///< Stokeslets are -log(r / gauge_length), length
  std::vector<double> reverse_at;      ///< ascending times > 0
};

/// Reads [flow].
///
/// @param  root      the whole scene
/// @param  enclosed  whether there is an outer wall
/// @return           the section, with defaults filled in
/// @throws SceneError at the first thing that is wrong
FlowSection read_flow(const TableReader& root, bool enclosed);

/// Reads [solver].
///
/// @param  root  the whole scene
/// @return       the section, with defaults filled in
/// @throws SceneError at the first thing that is wrong
SolverSettings read_solver(const TableReader& root);

/// Reads [time].
///
/// @param  root  the whole scene
/// @return       the section; none when the scene has none
/// @throws SceneError at the first thing that is wrong
std::optional<TimeSettings> read_time(const TableReader& root);

/// Reads [contact].
///
/// @param  root  the whole scene
/// @param  file  what was read of it before: bodies, fills and time, which must suit contact
/// @return        the section; none when the scene has none
/// @throws SceneError at the first thing that is wrong
std::optional<ContactSettings> read_contact(const TableReader& root, const SceneFile& file);

/// Reads [output].
///
/// @param  root  the whole scene
/// @return       the section, with defaults filled in
/// @throws SceneError at the first thing that is wrong
OutputSettings read_output(const TableReader& root);

}  // namespace stokesbook::scene_text
