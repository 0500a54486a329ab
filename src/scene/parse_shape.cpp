// Reads the shapes of a scene file; each kind of shape has its own reader.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "scene/csv_table.hpp"
#include "scene/polygon.hpp"
#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

using ShapeReader = Shape (*)(const Node&, const std::filesystem::path&);

constexpr Requirement<Complex> semi_axes{
    "two numbers > 0", [](const Complex& a) { return a.real() > 0.0 && a.imag() > 0.0; }};
constexpr Requirement<double> star_amplitude{
    "a number > -1 and < 1, so that the curve does not meet itself",
    [](const double& amplitude) { return std::abs(amplitude) < 1.0; }};
// At the largest power, the rounding of a corner takes about a thousandth of a side. No number of
// nodes that the solver accepts resolves sharper corners.
constexpr Requirement<int> even_power{
    "an even integer from 2 to 1000, for which the curve is analytic",
    [](const int& p) { return p >= 2 && p <= 1000 && p % 2 == 0; }};

Shape read_circle(const Node& node, const std::filesystem::path&) {
  const TableReader table(node, {"kind", "radius"});
  return Circle{table.require("radius", positive_number)};
}

Shape read_ellipse(const Node& node, const std::filesystem::path&) {
  const TableReader table(node, {"kind", "semi_axes"});
  const Complex axes = table.require("semi_axes", semi_axes);
  return Ellipse{axes.real(), axes.imag()};
}

Shape read_star(const Node& node, const std::filesystem::path&) {
  const TableReader table(node, {"kind", "radius", "amplitude", "arms"});
  return Star{table.require("radius", positive_number), table.require("amplitude", star_amplitude),
              table.require("arms", positive_integer)};
}

Shape read_superellipse(const Node& node, const std::filesystem::path&) {
  const TableReader table(node, {"kind", "semi_axes", "power"});
  const Complex axes = table.require("semi_axes", semi_axes);
  return Superellipse{axes.real(), axes.imag(), table.require("power", even_power)};
}

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

constexpr Words<ShapeReader, 5> shape_kinds{{{"circle", read_circle},
                                             {"ellipse", read_ellipse},
                                             {"star", read_star},
                                             {"superellipse", read_superellipse},
                                             {"nodes", read_nodes}}};

}  // namespace

Shape read_shape(const TableReader& owner, const std::filesystem::path& directory) {
  const Node& node = owner.at("shape", "a table, such as { kind = \"circle\", radius = 1.0 }");
  return TableReader(node).require("kind", shape_kinds)(node, directory);
}

}  // namespace stokesbook::scene_text
