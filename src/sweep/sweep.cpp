// Reads a sweep file: the scene, the axes with their values, the seeds, and what to collect.
#include "sweep/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <string_view>

#include "record/csv.hpp"
#include "scene/table_reader.hpp"
#include "scene/write.hpp"
#include "text/number_text.hpp"
#include "text/text_file.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

using namespace scene_text;

/// Tables of a run, with a row for each time, or for each time and body or wall; and their headers.
constexpr Words<std::string_view, 4> tables{{{"rheology.csv", rheology_header},
                                             {"steps.csv", steps_header},
                                             {"trajectory.csv", trajectory_header},
                                             {"walls.csv", walls_header}}};

constexpr Words<Reduction, 4> reductions{{{"last", Reduction::last},
                                          {"least", Reduction::least},
                                          {"largest", Reduction::largest},
                                          {"sum", Reduction::sum}}};

/// Words for the spacing of a range, with whether it is logarithmic.
constexpr Words<bool, 2> spacings{{{"linear", false}, {"logarithmic", true}}};

constexpr Requirement<std::string> file_name{"the name of a scene file, relative to this file"};
constexpr Requirement<std::string> scene_key{
    "a key of the scene, such as \"time.dt\" or \"fill.0.area_fraction\"",
    [](const std::string& key) {
      return !key.empty() && key.find_first_of(" =\"'") == std::string::npos;
    }};
constexpr Requirement<std::string> column_name{
    "a name of letters, digits and _", [](const std::string& name) { return is_name(name); }};
/// Largest number of tasks: queues of clusters accept no more, and each task has a folder.
constexpr int most_tasks = 100'000;
constexpr Requirement<int> several{"an integer from 2 to 100000",
                                   [](const int& k) { return k >= 2 && k <= most_tasks; }};
constexpr Requirement<int> number_of_seeds{"an integer from 1 to 100000",
                                           [](const int& k) { return k >= 1 && k <= most_tasks; }};
constexpr Requirement<std::int64_t> first_seed{
    "an integer from 0 to 9223372036854675807", [](const std::int64_t& k) {
      return k >= 0 && k <= std::numeric_limits<std::int64_t>::max() - most_tasks;
    }};
constexpr Requirement<int> item_number{"an integer >= 0", [](const int& k) { return k >= 0; }};
constexpr Requirement<std::vector<double>> time_interval{
    "two times [begin, end] with 0 <= begin < end", [](const std::vector<double>& times) {
      return times.size() == 2 && times[0] >= 0.0 && times[0] < times[1];
    }};

/// Returns a value in TOML's syntax; the text of a node is not used, since messages shorten it.
std::string toml_text(const Node& node) {
  if (const auto* elements = std::get_if<Array>(&node.value)) {
    return std::string("[").append(joined(*elements, ", ", toml_text)) + "]";
  }
  if (const auto* table = std::get_if<Table>(&node.value)) {
    const auto text_of = [](const Node& entry) { return entry.key + " = " + toml_text(entry); };
    return std::string("{ ").append(joined(table->entries, ", ", text_of)) + " }";
  }
  return node.text;
}

using AxisValues = std::vector<std::vector<AxisValue>>;

/// Reads the values of one key, or lists with a value for each of several keys.
AxisValues read_values(const Node& node, std::size_t keys = 1) {
  const std::string expected = "a list of " + std::to_string(keys) + " values, one for each key";
  AxisValues values;
  std::set<std::string> texts;
  for (const Node& element : elements_of(node, "a list of values")) {
    if (!texts.insert(toml_text(element)).second) fail(element, "is repeated in the list");
    std::vector<AxisValue>& value = values.emplace_back();
    const std::span parts =
        keys > 1 ? std::span(elements_of(element, expected)) : std::span(&element, 1);
    if (parts.size() != keys) fail(element, "must be " + expected);
    for (const Node& part : parts) value.push_back({toml_text(part), part.where});
  }
  if (values.empty()) fail(node, "must be a list of one or more values");
  return values;
}

AxisValues read_range(const Node& node) {
  const TableReader table(node, {"from", "to", "count", "spacing"});
  const double from = table.require("from", any_number);
  const double to = table.require("to", any_number);
  const int count = table.require("count", several);
  const bool is_logarithmic = table.get("spacing", spacings, false);
  if (from == to) fail(*table.find("to"), "must differ from where the range begins");
  if (is_logarithmic && (from <= 0.0 || to <= 0.0)) {
    fail(*table.find(from <= 0.0 ? "from" : "to"), "must be > 0 where the spacing is logarithmic");
  }
  // With s_k = k / (count - 1): x_k = from + s_k (to - from), or from (to / from)^{s_k}.
  AxisValues values;
  for (int k = 0; k < count; ++k) {
    const double s = static_cast<double>(k) / (count - 1);
    const double between = is_logarithmic ? from * std::pow(to / from, s) : from + s * (to - from);
    values.push_back({{toml_value(k == count - 1 ? to : between), node.where}});
  }
  return values;
}

/// Reads a key, or a list of keys that change together.
std::vector<std::string> read_keys(const Node& node) {
  std::vector<std::string> keys;
  const auto* list = std::get_if<Array>(&node.value);
  if (list != nullptr && list->size() < 2) fail(node, "must be one key, or a list of several");
  for (const Node& key : list != nullptr ? std::span(*list) : std::span(&node, 1)) {
    keys.push_back(read(key, scene_key));
    if (keys.back() == "seed") fail(key, "seeds are not an axis; list them in the key seeds");
  }
  return keys;
}

Axis read_axis(const Node& node) {
  const TableReader table(node, {"key", "name", "values", "range"});
  Axis axis;
  axis.keys = axis.names = read_keys(table.at("key", describe(scene_key)));
  if (axis.keys.size() > 1) {
    table.refuse({"name", "range"}, "not allowed with a list of keys, which requires values");
  } else if (const auto name = table.get("name", column_name)) {
    axis.names = {*name};
  }
  const Node *values = table.find("values"), *range = table.find("range");
  if ((values == nullptr) == (range == nullptr)) fail(node, "must hold values or range, not both");
  axis.values = values != nullptr ? read_values(*values, axis.keys.size()) : read_range(*range);
  return axis;
}

AxisValues read_seeds(const TableReader& root) {
  const Node* node = root.find("seeds");
  if (node == nullptr) return {};
  if (std::holds_alternative<Table>(node->value)) {
    const TableReader table(*node, {"first", "count"});
    const std::int64_t first = table.require("first", first_seed);
    const int count = table.require("count", number_of_seeds);
    AxisValues seeds;
    for (int k = 0; k < count; ++k) seeds.push_back({{toml_value(first + k), node->where}});
    return seeds;
  }
  for (const Node& element : elements_of(*node, "a list of integers or { first, count }")) {
    read(element, any_seed);
  }
  return read_values(*node);
}

/// Returns the columns of a header, whose line has an end.
std::vector<std::string_view> columns_in(std::string_view header) {
  header.remove_suffix(1);
  return split(header, ',');
}

/// Returns the columns that a table has only in scenes with a periodic cell.
std::vector<std::string_view> cell_columns(std::string_view table) {
  if (table == "rheology.csv") return columns_in(cell_rheology_columns);
  if (table == "trajectory.csv") return columns_in(cell_trajectory_columns);
  return {};
}

void read_column(const TableReader& table, std::string_view header, Quantity& quantity) {
  std::vector<std::string_view> columns = columns_in(header);
  const std::string expected = "a column of " + quantity.table;
  const Node& node = table.at("column", expected);
  quantity.column = value_as<std::string>(node, expected);
  const auto is_listed = [&] { return std::ranges::count(columns, quantity.column) > 0; };
  quantity.needs_cell = !is_listed();
  std::ranges::copy(cell_columns(quantity.table), std::back_inserter(columns));
  if (!is_listed()) {
    const std::string more = joined(cell_columns(quantity.table), ",");
    const auto meant = nearest_word(quantity.column, columns);
    fail(node, "is not " + expected +
                   (meant ? ", did you mean '" + std::string(*meant) + "'?"
                          : "; its columns are " + joined(columns_in(header), ",") +
                                (more.empty() ? "" : ", and in scenes with [cell] " + more)));
  }
  for (const std::string_view item : {"body", "wall"}) {
    if (columns[1] == item) {
      quantity.item = table.require(item, item_number);
    } else {
      table.refuse({item}, quantity.table + " has no column '" + std::string(item) + "'");
    }
  }
}

Quantity read_quantity(const Node& node) {
  const TableReader table(node, {"name", "table", "column", "body", "wall", "average", "take"});
  Quantity quantity;
  const std::string_view header = table.require("table", tables);
  quantity.table = name_of(header, tables);
  quantity.where = node.where;
  read_column(table, header, quantity);
  quantity.name = table.get("name", column_name).value_or(quantity.column);
  const auto times = table.get("average", time_interval);
  const auto reduction = table.get("take", reductions);
  if (times.has_value() == reduction.has_value()) {
    fail(node, "must hold average = [begin, end] or take, " + describe(reductions));
  }
  quantity.reduction = reduction.value_or(Reduction::average);
  if (times) {
    quantity.from = times->front();
    quantity.to = times->back();
  }
  return quantity;
}

void require_distinct(const std::string& column, std::vector<std::string>& columns,
                      const Node& node) {
  if (std::ranges::find(columns, column) != columns.end()) {
    fail(node, "would give the tables two columns '" + column + "'; set another name");
  }
  columns.push_back(column);
}

/// Refuses too many tasks. Their number is computed in floating point, which does not overflow.
void require_few_tasks(const Node& document, const Sweep& sweep) {
  auto tasks = static_cast<double>(runs_per_combination(sweep));
  for (const Axis& axis : sweep.axes) tasks *= static_cast<double>(axis.values.size());
  if (tasks <= most_tasks) return;
  fail(document, "has " + short_number(tasks, 6) + " tasks: at most " + std::to_string(most_tasks) +
                     " may be in one sweep");
}

}  // namespace

std::array<std::string, 3> columns_of(const Quantity& quantity) {
  return {quantity.name, quantity.name + "_standard_error", quantity.name + "_interval"};
}

std::size_t runs_per_combination(const Sweep& sweep) {
  return std::max<std::size_t>(1, sweep.seeds.values.size());
}

Sweep read_sweep(const std::filesystem::path& path) {
  const std::optional<std::string> text = read_text_file(path);
  if (!text) throw SceneError(path.string() + ": the file does not exist or cannot be read");
  const Node document = parse_document(*text, path.string());
  const TableReader root(document, {"scene", "seeds", "axes", "collect"});
  Sweep sweep;
  sweep.scene = path.parent_path() / root.require("scene", file_name);
  if (!read_text_file(sweep.scene)) {
    fail(*root.find("scene"),
         "the file " + sweep.scene.string() + " does not exist or cannot be read");
  }
  // Column names that are taken: the tables of every sweep have these columns.
  std::vector<std::string> columns{"task", "folder", "seed",      "scene",
                                   "runs", "failed", "unfinished"};
  std::set<std::string> keys;
  for (const Node& node : root.tables("axes")) {
    const Axis& axis = sweep.axes.emplace_back(read_axis(node));
    for (const std::string& name : axis.names) {
      require_distinct(name, columns, node);
      sweep.columns.push_back(name);
    }
    for (const std::string& key : axis.keys) {
      if (!keys.insert(key).second) fail(node, "the axes set " + key + " twice");
    }
  }
  sweep.seeds.values = read_seeds(root);
  for (const Node& node : root.tables("collect")) {
    const Quantity& quantity = sweep.quantities.emplace_back(read_quantity(node));
    for (const std::string& column : columns_of(quantity)) require_distinct(column, columns, node);
  }
  if (sweep.axes.empty() && sweep.seeds.values.empty()) {
    fail(document, "a sweep must vary something: write [[axes]] or seeds");
  }
  require_few_tasks(document, sweep);
  return sweep;
}

}  // namespace stokesbook
