// Reads the sections [[bodies]] of a scene file.
#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

Body read_body(const Node& node, const std::filesystem::path& directory) {
  const TableReader table(node, {"shape", "position", "orientation", "force", "torque", "held",
                                 "velocity", "omega", "n_nodes"});
  Body body;
  body.shape = read_shape(table, directory);
  body.position = table.get("position", any_vector).value_or(body.position);
  body.orientation = table.get("orientation", any_number).value_or(body.orientation);
  body.held = table.get("held", any_flag).value_or(body.held);
  if (body.held) {
    table.refuse({"force", "torque"},
                 "force and torque of a held body are results; remove them, or set held = false");
  } else {
    table.refuse({"velocity", "omega"},
                 "velocity and omega of a free body are results; remove them, or set held = true");
  }
  body.force = table.get("force", any_vector).value_or(body.force);
  body.torque = table.get("torque", any_number).value_or(body.torque);
  body.velocity = table.get("velocity", any_vector).value_or(body.velocity);
  body.omega = table.get("omega", any_number).value_or(body.omega);
  body.n_nodes = table.require("n_nodes", node_count);
  return body;
}

}  // namespace

std::vector<Body> read_bodies(const TableReader& root, const std::filesystem::path& directory) {
  std::vector<Body> bodies;
  for (const Node& node : root.tables("bodies")) bodies.push_back(read_body(node, directory));
  return bodies;
}

}  // namespace stokesbook::scene_text
