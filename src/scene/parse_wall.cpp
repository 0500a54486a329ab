// Reads the sections [[walls]] of a scene file; each kind of motion has its own reader.
#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

using MotionReader = WallMotion (*)(const Node&);

WallMotion read_fixed(const Node& node) {
  const TableReader table(node, {"kind"});
  return FixedWall{};
}

WallMotion read_rotating(const Node& node) {
  return RotatingWall{TableReader(node, {"kind", "omega"}).require("omega", any_number)};
}

WallMotion read_translating(const Node& node) {
  return TranslatingWall{TableReader(node, {"kind", "velocity"}).require("velocity", any_vector)};
}

WallMotion read_linear_motion(const Node& node) {
  return LinearWall{TableReader(node, {"kind", "gradient"}).require("gradient", any_gradient)};
}

WallMotion read_radial(const Node& node) {
  return RadialWall{TableReader(node, {"kind", "speed"}).require("speed", any_number)};
}

constexpr Words<MotionReader, 5> motion_kinds{{
    {"fixed", read_fixed},
    {"rotating", read_rotating},
    {"translating", read_translating},
    {"linear", read_linear_motion},
    {"radial", read_radial},
}};

WallMotion read_motion(const TableReader& wall, const Shape& shape) {
  const Node* node = wall.find("motion");
  if (node == nullptr) return FixedWall{};
  const MotionReader read_kind = TableReader(*node).require("kind", motion_kinds);
  const WallMotion motion = read_kind(*node);
  if (std::holds_alternative<RadialWall>(motion) && !std::holds_alternative<Circle>(shape)) {
    fail(*node, "radial motion requires a wall whose shape is a circle");
  }
  return motion;
}

Wall read_wall(const Node& node, const std::filesystem::path& directory) {
  const TableReader table(node, {"role", "shape", "position", "orientation", "n_nodes", "motion"});
  Wall wall;
  wall.role = table.require("role", wall_roles);
  wall.shape = read_shape(table, directory);
  wall.position = table.get("position", any_vector).value_or(wall.position);
  wall.orientation = table.get("orientation", any_number).value_or(wall.orientation);
  wall.n_nodes = table.require("n_nodes", node_count);
  wall.motion = read_motion(table, wall.shape);
  return wall;
}

}  // namespace

std::vector<Wall> read_walls(const TableReader& root, const std::filesystem::path& directory) {
  std::vector<Wall> walls;
  const Node* outer = nullptr;
  for (const Node& node : root.tables("walls")) {
    walls.push_back(read_wall(node, directory));
    if (walls.back().role != WallRole::outer) continue;
    if (outer != nullptr) {
      fail(*TableReader(node).find("role"), "must be inner: the outer wall is " + outer->path);
    }
    outer = &node;
  }
  return walls;
}

}  // namespace stokesbook::scene_text
