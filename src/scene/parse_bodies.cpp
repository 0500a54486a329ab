// Reads the sections of a scene file that place curves in the plane: [[walls]], [[bodies]],
// [[body_lists]], in which each row of a CSV file becomes a body, and [[fill]], whose bodies
// place_fills() places later; and the points of [[tracers]].
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

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

Wall read_wall(const Node& node, const std::filesystem::path& directory) {
  const TableReader table(
      node, {"role", "shape", "position", "orientation", "n_nodes", "motion", "amplitude"});
  Wall wall;
  wall.role = table.require("role", wall_roles);
  wall.shape = read_shape(table, directory);
  wall.position = table.get("position", any_vector, wall.position);
  wall.orientation = table.get("orientation", any_number, wall.orientation);
  wall.n_nodes = read_node_count(table);
  wall.motion = read_motion(table, wall.shape, directory);
  if (std::holds_alternative<FixedWall>(wall.motion)) {
    table.refuse({"amplitude"}, "has no effect on a fixed wall: give a motion, or remove it");
  }
  wall.amplitude = table.get("amplitude", any_amplitude, wall.amplitude);
  return wall;
}

/// Reads the loads of bodies, lists and fills beside force and torque.
/// @param  has_weight  whether `density` is required in a scene with [gravity]
LoadLaws read_load_laws(const TableReader& owner, const TableReader& root, bool has_weight) {
  for (const auto& [key, section] :
       {std::pair{"density", "gravity"}, {"magnetic_moment", "magnetic_field"}}) {
    if (root.find(section) != nullptr) continue;
    owner.refuse({key}, "has no effect: write [" + std::string(section) + "], or remove it");
  }
  const LoadLaws loads = read_keys(LoadLaws{}, owner);
  if (has_weight && root.find("gravity") != nullptr) owner.require("density", nonnegative_number);
  return loads;
}

/// Returns a body with the keys that bodies, lists and fills have in common, besides the shape.
Body with_properties(Body body, const TableReader& table, const TableReader& root,
                     const std::filesystem::path& directory, bool has_weight) {
  body.force = table.get("force", any_vector, body.force);
  body.torque = table.get("torque", any_number, body.torque);
  body.n_nodes = read_node_count(table);
  body.loads = read_load_laws(table, root, has_weight);
  body.slip = read_slip(table, directory);
  return body;
}

Body read_body(const Node& node, const TableReader& root, const std::filesystem::path& directory) {
  const TableReader table(
      node, {"shape", "position", "orientation", "force", "torque", "held", "velocity", "omega",
             "n_nodes", "slip", "amplitude", "density", "trap", "magnetic_moment"});
  Body body;
  body.shape = read_shape(table, directory);
  body.position = table.get("position", any_vector, body.position);
  body.orientation = table.get("orientation", any_number, body.orientation);
  body.held = table.get("held", any_flag, body.held);
  if (body.held) {
    table.refuse({"force", "torque"},
                 "force and torque of a held body are results; remove them, or set held = false");
    table.refuse({"density", "trap", "magnetic_moment"},
                 "has no effect on a held body; remove it, or set held = false");
    table.refuse({"slip"}, "a held body has no slip; remove it, or set held = false");
  } else {
    table.refuse({"velocity", "omega"},
                 "velocity and omega of a free body are results; remove them, or set held = true");
  }
  body.velocity = table.get("velocity", any_vector, body.velocity);
  body.omega = table.get("omega", any_number, body.omega);
  return with_properties(body, table, root, directory, !body.held);
}

const CsvHeader list_header{
    "x,y,theta or cx,cy,theta with any of fx, fy, torque, density, and radius or semi_a, semi_b",
    [](const std::vector<std::string>& columns) {
      constexpr std::array known{"x",  "y",      "cx",      "cy",     "theta",  "fx",
                                 "fy", "torque", "density", "radius", "semi_a", "semi_b"};
      const auto has = [&](std::string_view name) {
        return std::ranges::count(columns, name) == 1;
      };
      const auto is_known = [&](const std::string& name) {
        return has(name) && std::ranges::count(known, name) == 1;
      };
      return std::ranges::all_of(columns, is_known) && has("theta") && has("x") != has("cx") &&
             has("x") == has("y") && has("cx") == has("cy") && has("semi_a") == has("semi_b") &&
             !(has("semi_a") && has("radius"));
    }};

std::vector<Body> read_body_list(const Node& node, const TableReader& root,
                                 const std::filesystem::path& directory) {
  const TableReader table(node, {"file", "shape", "force", "torque", "n_nodes", "slip", "amplitude",
                                 "density", "trap", "magnetic_moment"});
  const Node& file = table.at("file", describe(csv_file_name));
  const CsvTable rows = read_csv_file(file, directory, list_header);
  Body body;  // with the properties that all bodies of the list share
  const bool circles = rows.has("radius"), ellipses = rows.has("semi_a");
  if (circles || ellipses) {
    table.refuse({"shape"}, std::string("the file gives each body its own ") +
                                (circles ? "circle" : "ellipse") + "; remove shape");
  } else {
    body.shape = read_shape(table, directory);
  }
  for (const auto& [column, key] :
       {std::pair{"fx", "force"}, {"fy", "force"}, {"torque", "torque"}, {"density", "density"}}) {
    if (rows.has(column)) table.refuse({key}, "the file has the column " + std::string(column));
  }
  if (rows.has("density") && root.find("gravity") == nullptr) {
    fail(file, "the column density has no effect: write [gravity], or remove it");
  }
  body = with_properties(body, table, root, directory, !rows.has("density"));

  std::vector<Body> bodies;
  for (const CsvRow& row : rows.rows) {
    const auto number = [&](std::string_view column, double otherwise = 0.0) {
      return rows.value(row, column).value_or(otherwise);
    };
    const auto checked = [&](std::string_view column, const Requirement<double>& rule) {
      if (rule.holds(number(column))) return number(column);
      throw SceneError(row.where + ": " + std::string(column) + " = " + toml_value(number(column)) +
                       ": must be " + describe(rule));
    };
    if (circles) body.shape = Circle{checked("radius", positive_number)};
    if (ellipses) {
      body.shape = Ellipse{checked("semi_a", positive_number), checked("semi_b", positive_number)};
    }
    body.position = {number("x", number("cx")), number("y", number("cy"))};
    body.orientation = number("theta");
    body.force = {number("fx", body.force.real()), number("fy", body.force.imag())};
    body.torque = number("torque", body.torque);
    if (rows.has("density")) body.loads.density = checked("density", nonnegative_number);
    bodies.push_back(body);
  }
  return bodies;
}

/// Returns the box, or no value if the region is the whole fluid.
std::optional<std::array<double, 4>> read_region(const TableReader& fill, const TableReader& root,
                                                 bool enclosed) {
  if (root.find("cell") != nullptr) {
    fill.refuse({"region"}, "not allowed with [cell]: a fill takes the whole cell");
    return std::nullopt;
  }
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
    part.body.shape = scaled(fill.body.shape, size);
    part.area_fraction = area * *fill.area_fraction;
  }
  if (fills.empty()) fail(list, "must be " + expected);
  for (Fill& part : fills) *part.area_fraction /= areas;
  return fills;
}

std::vector<Fill> read_fill(const Node& node, const TableReader& root,
                            const std::filesystem::path& directory, bool enclosed) {
  const TableReader table(
      node, {"shape", "sizes", "area_fraction", "count", "region", "clearance", "n_nodes", "force",
             "torque", "slip", "amplitude", "density", "trap", "magnetic_moment"});
  Fill fill;
  fill.body.shape = read_shape(table, directory);
  fill.area_fraction = table.get("area_fraction", proper_fraction);
  fill.count = table.get("count", positive_integer);
  if (fill.area_fraction.has_value() == fill.count.has_value()) {
    fail(node, "must hold area_fraction or count, and not both");
  }
  if (fill.count) table.refuse({"sizes"}, "sizes require area_fraction; remove count");
  fill.box = read_region(table, root, enclosed);
  fill.clearance = table.get("clearance", nonnegative_number, fill.clearance);
  fill.body = with_properties(fill.body, table, root, directory, true);
  const Node* sizes = table.find("sizes");
  return sizes ? split_by_size(*sizes, fill) : std::vector{fill};
}

/// Reads points, or the points of a grid that begins at the lower left corner of a box.
std::vector<Complex> read_points(const Node& node) {
  const TableReader table(node, {"points", "box", "spacing"});
  std::vector<Complex> points;
  if (table.find("box") == nullptr) {
    const std::string expected = "a list of points [[x, y], ...]";
    for (const Node& point :
         elements_of(table.at("points", expected + ", or give a box"), expected)) {
      points.push_back(read(point, any_vector));
    }
    return points;
  }
  table.refuse({"points"}, "give points or a box, not both");
  const auto [left, bottom, right, top] = table.require("box", any_box);
  const double spacing = table.require("spacing", positive_number);
  constexpr double most = 1e6, rounding = 1e-9;
  const double columns = std::floor((right - left) / spacing + rounding) + 1.0,
               rows = std::floor((top - bottom) / spacing + rounding) + 1.0;
  if (columns * rows > most) {
    fail(*table.find("spacing"), "must be larger: the grid has more than 1000000 points");
  }
  for (double row = 0.0; row < rows; ++row) {
    for (double column = 0.0; column < columns; ++column) {
      points.emplace_back(left + column * spacing, bottom + row * spacing);
    }
  }
  return points;
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
  for (const Node& node : root.tables("bodies")) bodies.push_back(read_body(node, root, directory));
  for (const Node& node : root.tables("body_lists")) {
    std::ranges::move(read_body_list(node, root, directory), std::back_inserter(bodies));
  }
  return bodies;
}

std::vector<Fill> read_fills(const TableReader& root, const std::filesystem::path& directory,
                             bool enclosed) {
  std::vector<Fill> fills;
  for (const Node& node : root.tables("fill")) {
    std::ranges::move(read_fill(node, root, directory, enclosed), std::back_inserter(fills));
  }
  return fills;
}

std::vector<Complex> read_tracers(const TableReader& root) {
  std::vector<Complex> tracers;
  for (const Node& node : root.tables("tracers")) {
    std::ranges::copy(read_points(node), std::back_inserter(tracers));
  }
  return tracers;
}

}  // namespace stokesbook::scene_text
