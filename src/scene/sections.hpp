#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "scene/table_reader.hpp"

/// Readers for the sections of a scene file, one function for each section.
namespace stokesbook::scene_text {

/// Reads the shape of a wall, body, body list or fill.
///
/// @param  owner      table with the key `shape`
/// @param  directory  folder that file names are relative to
/// @return            the shape, in its own frame
/// @throws SceneError at the first error
Shape read_shape(const TableReader& owner, const std::filesystem::path& directory);

/// Reads [[walls]].
///
/// @param  root       the whole scene
/// @param  directory  folder that file names are relative to
/// @return            walls in file order, at most one of them outer
/// @throws SceneError at the first error
std::vector<Wall> read_walls(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[bodies]].
///
/// @param  root       the whole scene
/// @param  directory  folder that file names are relative to
/// @return            bodies in file order
/// @throws SceneError at the first error
std::vector<Body> read_bodies(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[body_lists]]: each row of each file is a body.
///
/// @param  root       the whole scene
/// @param  directory  folder that file names are relative to
/// @return            bodies in file order
/// @throws SceneError at the first error
std::vector<Body> read_body_lists(const TableReader& root, const std::filesystem::path& directory);

/// Reads [[fill]].
///
/// @param  root       the whole scene
/// @param  directory  folder that file names are relative to
/// @param  enclosed   whether there is an outer wall
/// @return            fills in file order
/// @throws SceneError at the first error
std::vector<Fill> read_fills(const TableReader& root, const std::filesystem::path& directory,
                             bool enclosed);

/// The section [flow]: the background flow, and the times at which all driving changes sign.
struct FlowSection {
  BackgroundFlow flow;                 ///< quiescent if a wall encloses the fluid
  std::optional<double> gauge_length;  ///< length in the Stokeslets' -log(r / gauge_length)
  std::vector<double> reverse_at;      ///< ascending times > 0
};

/// Reads [flow].
///
/// @param  root      the whole scene
/// @param  enclosed  whether there is an outer wall
/// @return           the section, with defaults filled in
/// @throws SceneError at the first error
FlowSection read_flow(const TableReader& root, bool enclosed);

/// Reads [solver].
///
/// @param  root  the whole scene
/// @return       the section, with defaults filled in
/// @throws SceneError at the first error
SolverSettings read_solver(const TableReader& root);

/// Reads [time].
///
/// @param  root  the whole scene
/// @return       the section; none if the scene does not have it
/// @throws SceneError at the first error
std::optional<TimeSettings> read_time(const TableReader& root);

/// Reads [contact].
///
/// @param  root  the whole scene
/// @param  file  the sections read before: bodies, fills and time, which must allow contact
/// @return        the section; none if the scene does not have it
/// @throws SceneError at the first error
std::optional<ContactSettings> read_contact(const TableReader& root, const SceneFile& file);

/// Reads [output].
///
/// @param  root  the whole scene
/// @return       the section, with defaults filled in
/// @throws SceneError at the first error
OutputSettings read_output(const TableReader& root);

}  // namespace stokesbook::scene_text
