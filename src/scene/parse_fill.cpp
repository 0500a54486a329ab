// Reads the sections [[fill]] of a scene file; place_fills() places their bodies later.
#include <string>

#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

constexpr Requirement<double> fraction{"a number > 0 and < 1",
                                       [](const double& x) { return x > 0.0 && x < 1.0; }};
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

Fill read_fill(const Node& node, const std::filesystem::path& directory, bool enclosed) {
  const TableReader table(node,
                          {"shape", "area_fraction", "count", "region", "clearance", "n_nodes"});
  Fill fill;
  fill.shape = read_shape(table, directory);
  fill.area_fraction = table.get("area_fraction", fraction);
  fill.count = table.get("count", positive_integer);
  if (fill.area_fraction.has_value() == fill.count.has_value()) {
    fail(node, "must hold area_fraction or count, and not both");
  }
  fill.box = read_region(table, enclosed);
  fill.clearance = table.get("clearance", gap).value_or(fill.clearance);
  fill.n_nodes = table.require("n_nodes", node_count);
  return fill;
}

}  // namespace

std::vector<Fill> read_fills(const TableReader& root, const std::filesystem::path& directory,
                             bool enclosed) {
  std::vector<Fill> fills;
  for (const Node& node : root.tables("fill")) {
    fills.push_back(read_fill(node, directory, enclosed));
  }
  return fills;
}

}  // namespace stokesbook::scene_text
