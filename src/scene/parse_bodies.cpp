// Reads the sections of a scene file that place curves in the plane: [[walls]], [[bodies]],
// [[body_lists]], in which each row of a CSV file becomes a body, and [[fill]], whose bodies
// place_fills() places later.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>

#include "scene/csv_table.hpp"
#include "scene/parameters.hpp"
#include "scene/sections.hpp"
#include "scene/write.hpp"

namespace stokesbook::scene_text {

namespace {

/// Reads the number of nodes, an even integer from 8 to 1000000 or the word "auto". The message
/// about another number suggests the next valid one.
int read_node_count(const TableReader& owner) {
  constexpr std::int64_t fewest = 8;        // fewer nodes resolve no curve
  constexpr std::int64_t most = 1'000'000;  // more nodes do not fit into memory
  const std::string expected = "an even integer >= " + std::to_string(fewest) + " or \"auto\"";
  const Node& node = owner.at("n_nodes", expected);
  const auto* word = std::get_if<std::string>(&node.value);
  if (word != nullptr && *word == automatic_word) return automatic_nodes;
  const auto count = value_as<std::int64_t>(node, expected);
  if (count > most) fail(node, "must be at most " + std::to_string(most));
  if (count < fewest || count % 2 != 0) {
    const std::int64_t next = std::max(fewest, count + 1);
    fail(node, "must be " + expected + " (try " + std::to_string(next) + ")");
  }
  return static_cast<int>(count);
}

WallMotion read_motion(const TableReader& wall, const Shape& shape) {
  const Node* node = wall.find("motion");
  if (node == nullptr) return FixedWall{};
  const WallMotion motion =
      read_parameters(TableReader(*node).require("kind", motion_kinds), *node);
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
  wall.position = table.get("position", any_vector, wall.position);
  wall.orientation = table.get("orientation", any_number, wall.orientation);
  wall.n_nodes = read_node_count(table);
  wall.motion = read_motion(table, wall.shape);
  return wall;
}

Body read_body(const Node& node, const std::filesystem::path& directory) {
  const TableReader table(node, {"shape", "position", "orientation", "force", "torque", "held",
                                 "velocity", "omega", "n_nodes"});
  Body body;
  body.shape = read_shape(table, directory);
  body.position = table.get("position", any_vector, body.position);
  body.orientation = table.get("orientation", any_number, body.orientation);
  body.held = table.get("held", any_flag, body.held);
  if (body.held) {
    table.refuse({"force", "torque"},
                 "force and torque of a held body are results; remove them, or set held = false");
  } else {
    table.refuse({"velocity", "omega"},
                 "velocity and omega of a free body are results; remove them, or set held = true");
  }
  body.force = table.get("force", any_vector, body.force);
  body.torque = table.get("torque", any_number, body.torque);
  body.velocity = table.get("velocity", any_vector, body.velocity);
  body.omega = table.get("omega", any_number, body.omega);
  body.n_nodes = read_node_count(table);
  return body;
}

constexpr std::string_view placements_header = "x,y,theta";
constexpr std::string_view ellipses_header = "cx,cy,semi_a,semi_b,theta";

double semi_axis(const CsvRow& row, std::size_t column, const std::string& name) {
  const double length = row.values[column];
  if (positive_number.holds(length)) return length;
  throw SceneError(row.where + ": " + name + " = " + toml_value(length) + ": must be " +
                   describe(positive_number));
}

std::vector<Body> read_body_list(const Node& node, const std::filesystem::path& directory) {
  const TableReader table(node, {"file", "shape", "force", "torque", "n_nodes"});
  const CsvTable rows = read_csv_file(table.at("file", describe(csv_file_name)), directory,
                                      {placements_header, ellipses_header});
  const bool ellipses = rows.header == ellipses_header;
  Body body;
  if (ellipses) {
    table.refuse({"shape"}, "the file gives each body its own ellipse; remove shape");
  } else {
    body.shape = read_shape(table, directory);
  }
  body.force = table.get("force", any_vector, body.force);
  body.torque = table.get("torque", any_number, body.torque);
  body.n_nodes = read_node_count(table);

  std::vector<Body> bodies;
  for (const CsvRow& row : rows.rows) {
    if (ellipses) body.shape = Ellipse{semi_axis(row, 2, "semi_a"), semi_axis(row, 3, "semi_b")};
    body.position = {row.values[0], row.values[1]};
    body.orientation = row.values.back();
    bodies.push_back(body);
  }
  return bodies;
}

constexpr Requirement<double> gap{"a number >= 0", [](const double& x) { return x >= 0.0; }};

/// Returns the box, or no value if the region is the whole fluid.
std::optional<std::array<double, 4>> read_region(const TableReader& fill, bool enclosed) {
  const std::string box = "{ box = [xmin, ymin, xmax, ymax] }";
  const std::string expected =
      enclosed ? "\"fluid\" or " + box : box + " (\"fluid\" requires an outer wall)";
  const Node* given = fill.find("region");
  if (given == nullptr && enclosed) return std::nullopt;
  const Node& region = fill.at("region", expected);
  if (std::holds_alternative<Table>(region.value)) {
    return TableReader(region, {"box"}).require("box", any_box);
  }
  if (value_as<std::string>(region, expected) != "fluid" || !enclosed) {
    fail(region, "must be " + expected);
  }
  return std::nullopt;
}

/// Reads the sizes and shares of a fill's bodies, and makes one fill for each size.
std::vector<Fill> split_by_size(const Node& list, const Fill& fill) {
  const std::string expected = "a list of one or more sizes and shares, [[size, share], ...]";
  std::vector<Fill> fills;
  double areas = 0.0;
  for (const Node& element : elements_of(list, expected)) {
    const Complex pair = read(element, semi_axes);
    const double size = pair.real(), area = pair.imag() * size * size;
    areas += area;
    Fill& part = fills.emplace_back(fill);
    part.shape = scaled(fill.shape, size);
    part.area_fraction = area * *fill.area_fraction;
  }
  if (fills.empty()) fail(list, "must be " + expected);
  for (Fill& part : fills) *part.area_fraction /= areas;
  return fills;
}

std::vector<Fill> read_fill(const Node& node, const std::filesystem::path& directory,
                            bool enclosed) {
  const TableReader table(
      node, {"shape", "sizes", "area_fraction", "count", "region", "clearance", "n_nodes"});
  Fill fill;
  fill.shape = read_shape(table, directory);
  fill.area_fraction = table.get("area_fraction", proper_fraction);
  fill.count = table.get("count", positive_integer);
  if (fill.area_fraction.has_value() == fill.count.has_value()) {
    fail(node, "must hold area_fraction or count, and not both");
  }
  if (fill.count) table.refuse({"sizes"}, "sizes require area_fraction; remove count");
  fill.box = read_region(table, enclosed);
  fill.clearance = table.get("clearance", gap, fill.clearance);
  fill.n_nodes = read_node_count(table);
  const Node* sizes = table.find("sizes");
  return sizes ? split_by_size(*sizes, fill) : std::vector{fill};
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

std::vector<Body> read_bodies(const TableReader& root, const std::filesystem::path& directory) {
  std::vector<Body> bodies;
  for (const Node& node : root.tables("bodies")) bodies.push_back(read_body(node, directory));
  for (const Node& node : root.tables("body_lists")) {
    std::ranges::move(read_body_list(node, directory), std::back_inserter(bodies));
  }
  return bodies;
}

std::vector<Fill> read_fills(const TableReader& root, const std::filesystem::path& directory,
                             bool enclosed) {
  std::vector<Fill> fills;
  for (const Node& node : root.tables("fill")) {
    std::ranges::move(read_fill(node, directory, enclosed), std::back_inserter(fills));
  }
  return fills;
}

}  // namespace stokesbook::scene_text
