// Converts nodes of a TOML document into values, and throws a SceneError for invalid ones.
#include "scene/rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scene/error.hpp"

namespace stokesbook::scene_text {

namespace {

constexpr std::int64_t fewest_nodes = 8;        // fewer nodes resolve no curve
constexpr std::int64_t most_nodes = 1'000'000;  // more nodes do not fit into memory

std::string type_of(const Node& node) {
  if (const auto* array = std::get_if<Array>(&node.value)) {
    return "an array of " + std::to_string(array->size());
  }
  constexpr std::array scalars{"a boolean", "an integer", "a float", "a string", "a date or time"};
  return node.value.index() < scalars.size() ? scalars[node.value.index()] : "a table";
}

const Array& elements_of(const Node& node, std::string_view expected, std::size_t count) {
  const Array& elements = elements_of(node, expected);
  if (elements.size() != count) fail_type(node, expected);
  return elements;
}

template <class T>
T scalar_as(const Node& node, std::string_view expected) {
  const T* value = std::get_if<T>(&node.value);
  if (value == nullptr) fail_type(node, expected);
  return *value;
}

std::string problem_of(const Node& node, const std::string& problem) {
  const std::string assignment = node.text.empty() ? node.path : node.path + " = " + node.text;
  return assignment.empty() ? problem : assignment + ": " + problem;
}

}  // namespace

void fail(const Node& node, const std::string& problem) {
  throw SceneError(node.where + ": " + problem_of(node, problem));
}

void fail_at_key(const Node& node, const std::string& problem) {
  throw SceneError(node.key_where + ": " + problem_of(node, problem));
}

void fail_type(const Node& node, std::string_view expected) {
  fail(node, "must be " + std::string(expected) + ", not " + type_of(node));
}

const Array& elements_of(const Node& node, std::string_view expected) {
  const Array* elements = std::get_if<Array>(&node.value);
  if (elements == nullptr) fail_type(node, expected);
  return *elements;
}

template <>
bool value_as(const Node& node, std::string_view expected) {
  return scalar_as<bool>(node, expected);
}

template <>
std::string value_as(const Node& node, std::string_view expected) {
  return scalar_as<std::string>(node, expected);
}

template <>
std::int64_t value_as(const Node& node, std::string_view expected) {
  return scalar_as<std::int64_t>(node, expected);
}

template <>
int value_as(const Node& node, std::string_view expected) {
  const std::int64_t value = value_as<std::int64_t>(node, expected);
  if (!std::in_range<int>(value)) {
    fail(node, "must be " + std::string(expected) + ", and no larger than " +
                   std::to_string(std::numeric_limits<int>::max()));
  }
  return static_cast<int>(value);
}

template <>
double value_as(const Node& node, std::string_view expected) {
  if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
    return static_cast<double>(*integer);
  }
  const double value = scalar_as<double>(node, expected);
  if (!std::isfinite(value)) fail(node, "must be " + std::string(expected) + ", and finite");
  if (value != 0.0 && (std::abs(value) < smallest_number || std::abs(value) > largest_number)) {
    fail(node, "must be 0 or have a magnitude from 1e-100 to 1e100; change the units");
  }
  return value;
}

template <>
Complex value_as(const Node& node, std::string_view expected) {
  const Array& parts = elements_of(node, expected, 2);
  return {read(parts[0], any_number), read(parts[1], any_number)};
}

template <>
Eigen::Matrix2d value_as(const Node& node, std::string_view expected) {
  const Array& rows = elements_of(node, expected, 2);
  const Complex first = value_as<Complex>(rows[0], "a row of two numbers");
  const Complex second = value_as<Complex>(rows[1], "a row of two numbers");
  return Eigen::Matrix2d{{first.real(), first.imag()}, {second.real(), second.imag()}};
}

template <>
std::array<double, 4> value_as(const Node& node, std::string_view expected) {
  std::array<double, 4> values{};
  std::ranges::transform(elements_of(node, expected, values.size()), values.begin(),
                         [](const Node& element) { return read(element, any_number); });
  return values;
}

template <>
std::vector<double> value_as(const Node& node, std::string_view expected) {
  std::vector<double> values;
  for (const Node& element : elements_of(node, expected)) {
    values.push_back(read(element, any_number));
  }
  return values;
}

int read(const Node& node, NodeCount rule) {
  const auto* word = std::get_if<std::string>(&node.value);
  if (word != nullptr && *word == automatic_word) return automatic_nodes;
  const auto count = value_as<std::int64_t>(node, describe(rule));
  if (count > most_nodes) fail(node, "must be at most " + std::to_string(most_nodes));
  if (count < fewest_nodes || count % 2 != 0) {
    const std::int64_t next = std::max(fewest_nodes, count + 1);
    fail(node, "must be " + describe(rule) + " (try " + std::to_string(next) + ")");
  }
  return static_cast<int>(count);
}

std::string describe(NodeCount) {
  return "an even integer >= " + std::to_string(fewest_nodes) + " or \"" +
         std::string(automatic_word) + "\"";
}

}  // namespace stokesbook::scene_text
