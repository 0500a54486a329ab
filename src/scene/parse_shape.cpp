// Reads the shapes of a scene file, and checks the points of nodal curves.
#include <algorithm>
#include <string>
#include <utility>

#include "scene/csv_table.hpp"
#include "scene/parameters.hpp"
#include "scene/polygon.hpp"
#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

const CsvHeader points_header{"x,y", [](const std::vector<std::string>& columns) {
                                return columns == std::vector<std::string>{"x", "y"};
                              }};

NodalCurve nodes_of_file(const Node& file, const std::filesystem::path& directory) {
  const CsvTable table = read_csv_file(file, directory, points_header);
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

}  // namespace

Shape read_shape(const TableReader& owner, const std::filesystem::path& directory) {
  const Node& node = owner.at("shape", "a table, such as { kind = \"circle\", radius = 1.0 }");
  const Shape kind = TableReader(node).require("kind", shape_kinds);
  if (std::holds_alternative<NodalCurve>(kind)) return read_nodes(node, directory);
  return read_parameters(kind, node);
}

}  // namespace stokesbook::scene_text
