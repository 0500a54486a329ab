// Reads the keys of TOML tables, and converts their values. Unknown keys and invalid values are
// errors; for a misspelt key, the message suggests the key meant.
#include "scene/table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <utility>

namespace stokesbook::scene_text {

namespace {

std::string type_of(const Node& node) {
  if (const auto* array = std::get_if<Array>(&node.value)) {
    return "an array of " + std::to_string(array->size());
  }
  constexpr std::array scalars{"a boolean", "an integer", "a float", "a string", "a date or time"};
  return node.value.index() < scalars.size() ? scalars[node.value.index()] : "a table";
}

[[noreturn]] void fail_type(const Node& node, std::string_view expected) {
  fail(node, "must be " + std::string(expected) + ", not " + type_of(node));
}

const Array& elements_of(const Node& node, std::string_view expected, std::size_t count) {
  const Array& elements = elements_of(node, expected);
  if (elements.size() != count) fail_type(node, expected);
  return elements;
}

std::string problem_of(const Node& node, const std::string& problem) {
  const std::string assignment = node.text.empty() ? node.path : node.path + " = " + node.text;
  return assignment.empty() ? problem : assignment + ": " + problem;
}

const std::vector<Node>& entries_of(const Node& node) {
  if (const auto* table = std::get_if<Table>(&node.value)) return table->entries;
  fail_type(node, "a table");
}

}  // namespace

void fail(const Node& node, const std::string& problem) {
  throw SceneError(node.where + ": " + problem_of(node, problem));
}

void fail_at_key(const Node& node, const std::string& problem) {
  throw SceneError(node.key_where + ": " + problem_of(node, problem));
}

const Array& elements_of(const Node& node, std::string_view expected) {
  const Array* elements = std::get_if<Array>(&node.value);
  if (elements == nullptr) fail_type(node, expected);
  return *elements;
}

template <class T>
T value_as(const Node& node, std::string_view expected) {
  if constexpr (std::same_as<T, int>) {
    const auto value = value_as<std::int64_t>(node, expected);
    if (std::in_range<int>(value)) return static_cast<int>(value);
    fail(node, "must be " + std::string(expected) + ", and no larger than " +
                   std::to_string(std::numeric_limits<int>::max()));
  } else if constexpr (std::same_as<T, double>) {
    if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
      return static_cast<double>(*integer);
    }
    const auto* number = std::get_if<double>(&node.value);
    if (number == nullptr) fail_type(node, expected);
    if (!std::isfinite(*number)) fail(node, "must be " + std::string(expected) + ", and finite");
    const double size = std::abs(*number);
    if (size != 0.0 && (size < 1e-100 || size > largest_number)) {
      fail(node, "must be 0 or have a magnitude from 1e-100 to 1e100; change the units");
    }
    return *number;
  } else if constexpr (std::same_as<T, Complex>) {
    const Array& parts = elements_of(node, expected, 2);
    return {read(parts[0], any_number), read(parts[1], any_number)};
  } else if constexpr (std::same_as<T, Eigen::Matrix2d>) {
    const Array& rows = elements_of(node, expected, 2);
    const auto first = value_as<Complex>(rows[0], "a row of two numbers");
    const auto second = value_as<Complex>(rows[1], "a row of two numbers");
    return Eigen::Matrix2d{{first.real(), first.imag()}, {second.real(), second.imag()}};
  } else if constexpr (std::same_as<T, std::array<double, 4>>) {
    const Array& corners = elements_of(node, expected, 4);
    return {read(corners[0], any_number), read(corners[1], any_number),
            read(corners[2], any_number), read(corners[3], any_number)};
  } else if constexpr (std::same_as<T, std::vector<double>>) {
    std::vector<double> values;
    for (const Node& element : elements_of(node, expected)) {
      values.push_back(read(element, any_number));
    }
    return values;
  } else {  // a type of TOML
    const T* value = std::get_if<T>(&node.value);
    if (value == nullptr) fail_type(node, expected);
    return *value;
  }
}

template bool value_as(const Node&, std::string_view);
template int value_as(const Node&, std::string_view);
template std::int64_t value_as(const Node&, std::string_view);
template double value_as(const Node&, std::string_view);
template std::string value_as(const Node&, std::string_view);
template Complex value_as(const Node&, std::string_view);
template Eigen::Matrix2d value_as(const Node&, std::string_view);
template std::array<double, 4> value_as(const Node&, std::string_view);
template std::vector<double> value_as(const Node&, std::string_view);

TableReader::TableReader(const Node& node) : node_(node), entries_(entries_of(node)) {}

TableReader::TableReader(const Node& node, const std::vector<std::string_view>& known)
    : TableReader(node) {
  for (const Node& entry : entries_) {
    if (std::ranges::find(known, entry.key) != known.end()) continue;
    const std::optional<std::string_view> meant = nearest_word(entry.key, known);
    fail_at_key(entry, meant ? "unknown key, did you mean '" + std::string(*meant) + "'?"
                             : "unknown key; valid keys: " + joined(known));
  }
}

const Node* TableReader::find(std::string_view key) const {
  const auto found = std::ranges::find(entries_, key, &Node::key);
  return found == entries_.end() ? nullptr : &*found;
}

const Node& TableReader::at(std::string_view key, const std::string& expected) const {
  if (const Node* value = find(key)) return *value;
  throw SceneError(node_.where + ": " + child_path(node_.path, key) + " is missing: must be " +
                   expected);
}

void TableReader::refuse(std::initializer_list<std::string_view> keys,
                         const std::string& problem) const {
  for (const std::string_view key : keys) {
    if (const Node* value = find(key)) fail_at_key(*value, problem);
  }
}

std::span<const Node> TableReader::tables(std::string_view key) const {
  const Node* value = find(key);
  if (value == nullptr) return {};
  return elements_of(*value, "an array of tables: write [[" + std::string(key) + "]]");
}

}  // namespace stokesbook::scene_text
