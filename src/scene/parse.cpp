// Reads a scene file: parses its text, sets the values of the command line, and reads all sections.
#include "scene/parse.hpp"

#include <optional>
#include <utility>

#include "scene/sections.hpp"
#include "text/text_file.hpp"

namespace stokesbook {

namespace {

using namespace scene_text;

constexpr Requirement<std::string> any_text{"text"};

SceneFile read_root(const Node& node, const std::filesystem::path& directory) {
  const TableReader root(node, {"title", "seed", "fluid", "flow", "walls", "bodies", "body_lists",
                                "fill", "solver", "time", "contact", "output"});
  SceneFile file;
  auto& [scene, fills] = file;
  scene.title = root.get("title", any_text, scene.title);
  scene.seed = static_cast<std::uint64_t>(root.get("seed", any_seed, std::int64_t{0}));
  if (const Node* fluid = root.find("fluid")) {
    const TableReader table(*fluid, {"viscosity"});
    scene.viscosity = table.get("viscosity", positive_number, scene.viscosity);
  }
  scene.walls = read_walls(root, directory);
  const bool enclosed = is_enclosed(scene);
  FlowSection flow = read_flow(root, enclosed);
  scene.flow = flow.flow;
  scene.gauge_length = flow.gauge_length;
  scene.reverse_at = std::move(flow.reverse_at);
  scene.bodies = read_bodies(root, directory);
  fills = read_fills(root, directory, enclosed);
  scene.solver = read_solver(root);
  scene.time = read_time(root);
  scene.contact = read_contact(root, file);
  scene.output = read_output(root);
  if (scene.walls.empty() && scene.bodies.empty() && fills.empty()) {
    fail(node, "a scene must have a wall, a body or a fill: write [[walls]], [[bodies]], ...");
  }
  return file;
}

}  // namespace

SceneFile read_scene(const std::filesystem::path& path, std::span<const std::string> overrides) {
  const std::optional<std::string> text = read_text_file(path);
  if (!text) throw SceneError(path.string() + ": the file does not exist or cannot be read");
  return parse_scene(*text, path.string(), path.parent_path(), overrides);
}

SceneFile parse_scene(std::string_view text, std::string_view file_name,
                      const std::filesystem::path& directory,
                      std::span<const std::string> overrides) {
  Node document = parse_document(text, file_name);
  for (const std::string& setting : overrides) {
    document = with_override(std::move(document), setting);
  }
  return read_root(document, directory);
}

}  // namespace stokesbook
