// Reads the shapes of a scene file, and the velocities along them: wall motions and slips. Checks
// the points of nodal curves, and the rows of velocity data.
#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include "scene/csv_table.hpp"
#include "scene/parameters.hpp"
#include "scene/polygon.hpp"
#include "scene/sections.hpp"
#include "text/number_text.hpp"

namespace stokesbook::scene_text {

namespace {

NodalCurve nodes_of_file(const Node& file, const std::filesystem::path& directory) {
  const CsvTable table = read_csv_file(file, directory, {"x,y"});
  ComplexVector points(static_cast<Eigen::Index>(table.rows.size()));
  std::ranges::transform(table.rows, points.begin(), [](const CsvRow& row) {
    return Complex{row.values[0], row.values[1]};
  });
  if (const auto fault = find_fault(points)) {
    if (!fault->point) fail(file, fault->problem);
    throw SceneError(table.rows[static_cast<std::size_t>(*fault->point)].where + ": " +
                     fault->problem);
  }
  return {std::move(points), (directory / std::get<std::string>(file.value)).string()};
}

NodalCurve inline_nodes(const Node& list) {
  const Array& elements = elements_of(list, "a list of points [[x, y], ...]");
  ComplexVector points(static_cast<Eigen::Index>(elements.size()));
  std::ranges::transform(elements, points.begin(),
                         [](const Node& element) { return read(element, any_vector); });
  if (const auto fault = find_fault(points)) {
    fail(fault->point ? elements[static_cast<std::size_t>(*fault->point)] : list, fault->problem);
  }
  return {std::move(points), {}};
}

Shape read_nodes(const Node& node, const std::filesystem::path& directory) {
  const TableReader table(node, {"kind", "file", "points"});
  const Node* points = table.find("points");
  if (points == nullptr) {
    const std::string file = describe(csv_file_name);
    return nodes_of_file(table.at("file", file + ", or points = [[x, y], ...]"), directory);
  }
  table.refuse({"file"}, "give file or points, not both");
  return inline_nodes(*points);
}

constexpr Requirement<std::vector<double>> data_row{
    "three numbers [t, u, v]", [](const std::vector<double>& row) { return row.size() == 3; }};

// Adds a row to velocity data. Returns what is wrong with its t; empty: nothing.
std::string add_row(VelocityData& data, const std::vector<double>& row) {
  const double t = row[0], before = data.rows.empty() ? -1.0 : data.rows.back()[0];
  data.rows.push_back({t, row[1], row[2]});
  if (t >= 0.0 && t < 2.0 * std::numbers::pi && t > before) return {};
  return std::string(t > before ? "t must be >= 0 and < 2 pi"
                                : "t must be larger than in the row before") +
         ", not " + short_number(t);
}

VelocityData read_data(const Node& node, const std::filesystem::path& directory) {
  const TableReader table(node, {"kind", "file", "rows"});
  const std::string expected = "rows = [[t, u, v], ...]";
  const Node* rows = table.find("rows");
  VelocityData data;
  if (rows == nullptr) {
    rows = &table.at("file", describe(csv_file_name) + ", or " + expected);
    for (const CsvRow& row : read_csv_file(*rows, directory, {"t,u,v"}).rows) {
      const std::string problem = add_row(data, row.values);
      if (!problem.empty()) throw SceneError(row.where + ": " + problem);
    }
  } else {
    table.refuse({"file"}, "give file or rows, not both");
    for (const Node& row : elements_of(*rows, "a list [[t, u, v], ...]")) {
      const std::string problem = add_row(data, read(row, data_row));
      if (!problem.empty()) fail(row, problem);
    }
  }
  if (data.rows.size() < 4) fail(*rows, "must hold at least 4 rows");
  return data;
}

// Reads a wall motion or a slip.
template <class Velocity>
Velocity read_velocity(const Velocity& kind, const Node& node,
                       const std::filesystem::path& directory) {
  if (std::holds_alternative<VelocityData>(kind)) return read_data(node, directory);
  return read_parameters(kind, node);
}

}  // namespace

Shape read_shape(const TableReader& owner, const std::filesystem::path& directory) {
  const Node& node = owner.at("shape", "a table, such as { kind = \"circle\", radius = 1.0 }");
  const Shape kind = TableReader(node).require("kind", shape_kinds);
  if (std::holds_alternative<NodalCurve>(kind)) return read_nodes(node, directory);
  return read_parameters(kind, node);
}

std::optional<Slip> read_slip(const TableReader& owner, const std::filesystem::path& directory) {
  const Node* node = owner.find("slip");
  if (node == nullptr) return std::nullopt;
  return read_velocity(TableReader(*node).require("kind", slip_kinds), *node, directory);
}

WallMotion read_motion(const TableReader& wall, const Shape& shape,
                       const std::filesystem::path& directory) {
  const Node* node = wall.find("motion");
  if (node == nullptr) return FixedWall{};
  const WallMotion motion =
      read_velocity(TableReader(*node).require("kind", motion_kinds), *node, directory);
  if (std::holds_alternative<RadialWall>(motion) && !std::holds_alternative<Circle>(shape)) {
    fail(*node, "radial motion requires a wall whose shape is a circle");
  }
  if (std::holds_alternative<ParabolicWall>(motion) &&
      !std::holds_alternative<Superellipse>(shape)) {
    fail(*node, "parabolic motion requires a wall whose shape is a superellipse");
  }
  return motion;
}

}  // namespace stokesbook::scene_text
