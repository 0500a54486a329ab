// Reads the sections [[body_lists]] of a scene file: each row of a CSV file becomes a body.
#include <string>

#include "scene/csv_file.hpp"
#include "scene/error.hpp"
#include "scene/sections.hpp"
#include "scene/toml_value.hpp"

namespace stokesbook::scene_text {

namespace {

constexpr std::string_view placements_header = "x,y,theta";
constexpr std::string_view ellipses_header = "cx,cy,semi_a,semi_b,theta";

double semi_axis(const CsvRow& row, std::size_t column, const std::string& name) {
  const double length = row.values[column];
  if (positive_number.holds(length)) return length;
  throw SceneError(row.where + ": " + name + " = " + toml_value(length) + ": must be " +
                   describe(positive_number));
}

Ellipse ellipse_of(const CsvRow& row) {
  return {semi_axis(row, 2, "semi_a"), semi_axis(row, 3, "semi_b")};
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
  body.force = table.get("force", any_vector).value_or(body.force);
  body.torque = table.get("torque", any_number).value_or(body.torque);
  body.n_nodes = table.require("n_nodes", node_count);

  std::vector<Body> bodies;
  for (const CsvRow& row : rows.rows) {
    if (ellipses) body.shape = ellipse_of(row);
    body.position = {row.values[0], row.values[1]};
    body.orientation = row.values.back();
    bodies.push_back(body);
  }
  return bodies;
}

}  // namespace

std::vector<Body> read_body_lists(const TableReader& root, const std::filesystem::path& directory) {
  std::vector<Body> bodies;
  for (const Node& node : root.tables("body_lists")) {
    const std::vector<Body> listed = read_body_list(node, directory);
    bodies.insert(bodies.end(), listed.begin(), listed.end());
  }
  return bodies;
}

}  // namespace stokesbook::scene_text
