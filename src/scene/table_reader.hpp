#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "scene/document.hpp"
#include "scene/words.hpp"
#include "text/word_list.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook::scene_text {

/// Throws the SceneError `where: path = value: problem` with the place of a value.
[[noreturn]] void fail(const Node& node, const std::string& problem);

/// Throws the same error with the place of the key, for a key that is not allowed.
[[noreturn]] void fail_at_key(const Node& node, const std::string& problem);

/// Returns the elements of an array.
/// @param  expected  completes "must be ..." in the error for other values
const Array& elements_of(const Node& node, std::string_view expected);

/// Converts a value to bool, int, std::int64_t, double, std::string, Complex, given as [x, y],
/// Eigen::Matrix2d, given as the list of its rows, or a list of four or any number of doubles.
/// An integer is accepted as a double.
/// @param  expected  completes "must be ..."
/// @throws SceneError when the value has another type, or is a number that is not finite or is too
///         small or large
template <class T>
T value_as(const Node& node, std::string_view expected);

/// Largest magnitude of a number; 1e-100 is the least, except for 0. The solver squares and
/// multiplies the numbers of a scene: the products must neither overflow nor underflow.
inline constexpr double largest_number = 1e100;

/// @name Rules
/// A rule states once which values are valid: `read(node, rule)` converts and checks a value or
/// throws a SceneError, and `describe(rule)` returns text that completes "must be ...".
/// @{

/// A rule for values of type T: a condition must hold.
template <class T>
struct Requirement {
  std::string_view expected;  ///< completes "must be ..."
  /// Returns whether a value is valid; by default, all values are.
  bool (*holds)(const T&) = [](const T&) { return true; };
};

/// Describes a requirement.
template <class T>
std::string describe(const Requirement<T>& rule) {
  return std::string(rule.expected);
}

/// Reads a value that meets a requirement.
template <class T>
T read(const Node& node, const Requirement<T>& rule) {
  T value = value_as<T>(node, rule.expected);
  if (!rule.holds(value)) fail(node, "must be " + describe(rule));
  return value;
}

/// Describes the words that a key accepts.
template <class T, std::size_t N>
std::string describe(const Words<T, N>& words) {
  return "one of " + joined(words, ", ", &Word<T>::name);
}

/// Reads a word, and returns its meaning.
template <class T, std::size_t N>
T read(const Node& node, const Words<T, N>& words) {
  const std::string name = value_as<std::string>(node, describe(words));
  for (const Word<T>& word : words) {
    if (word.name == name) return word.meaning;
  }
  fail(node, "must be " + describe(words));
}

/// A rule for a list of one or more distinct words.
template <class T, std::size_t N>
struct ListOf {
  const Words<T, N>& words;  ///< words that may be in the list
};

/// Deduces the type of `ListOf{words}`, which Clang 14 does not do by itself.
template <class T, std::size_t N>
ListOf(const Words<T, N>&) -> ListOf<T, N>;

/// Reads a list of words, and returns their meanings.
template <class T, std::size_t N>
std::vector<T> read(const Node& node, const ListOf<T, N>& rule) {
  const std::string expected =
      "a list of one or more of " + joined(rule.words, ", ", &Word<T>::name);
  std::vector<T> meanings;
  for (const Node& element : elements_of(node, expected)) {
    const T meaning = meanings.emplace_back(read(element, rule.words));
    if (std::ranges::count(meanings, meaning) > 1) fail(element, "is repeated in the list");
  }
  if (meanings.empty()) fail(node, "must be " + expected);
  return meanings;
}

inline constexpr Requirement<bool> any_flag{"true or false"};            ///< a truth value
inline constexpr Requirement<double> any_number{"a number"};             ///< a finite number
inline constexpr Requirement<Complex> any_vector{"two numbers [x, y]"};  ///< a plane vector

/// A 2 x 2 matrix.
inline constexpr Requirement<Eigen::Matrix2d> any_gradient{
    "two rows of two numbers [[a, b], [c, d]]"};

/// Corners of a box with positive sides.
inline constexpr Requirement<std::array<double, 4>> any_box{
    "[xmin, ymin, xmax, ymax] with xmin < xmax and ymin < ymax",
    [](const std::array<double, 4>& box) { return box[0] < box[2] && box[1] < box[3]; }};

/// A finite number > 0.
inline constexpr Requirement<double> positive_number{"a number > 0",
                                                     [](const double& x) { return x > 0.0; }};

/// A finite number >= 0.
inline constexpr Requirement<double> nonnegative_number{"a number >= 0",
                                                        [](const double& x) { return x >= 0.0; }};

/// A list of finite numbers.
inline constexpr Requirement<std::vector<double>> any_numbers{"a list of numbers"};

/// A part of a whole.
inline constexpr Requirement<double> proper_fraction{
    "a number > 0 and < 1", [](const double& x) { return x > 0.0 && x < 1.0; }};

/// A seed of random numbers.
inline constexpr Requirement<std::int64_t> any_seed{"an integer >= 0",
                                                    [](const std::int64_t& k) { return k >= 0; }};

/// An integer >= 1.
inline constexpr Requirement<int> positive_integer{"an integer >= 1",
                                                   [](const int& k) { return k >= 1; }};
/// @}

/// A reader for the keys of one table of the document, which must outlive the reader. All functions
/// throw a SceneError for nodes of wrong type, missing keys that are required, and invalid values.
class TableReader {
 public:
  /// Opens a table without a check of its keys, for tables whose keys depend on their kind.
  explicit TableReader(const Node& node);

  /// Opens a table, and refuses the first key that is not known; the message suggests the known
  /// key that was probably meant.
  TableReader(const Node& node, const std::vector<std::string_view>& known);

  /// Returns the value of a key; null if the key is missing.
  const Node* find(std::string_view key) const;

  /// Returns the value of a required key.
  /// @param  expected  completes "must be ..." in the error for a missing key
  const Node& at(std::string_view key, const std::string& expected) const;

  /// Reads the value of a key that may be missing; none if it is.
  template <class Rule>
  auto get(std::string_view key, const Rule& rule) const {
    const Node* value = find(key);
    return value ? std::optional(read(*value, rule)) : std::nullopt;
  }

  /// Reads the value of a key; a default if the key is missing.
  template <class T, class Rule>
  T get(std::string_view key, const Rule& rule, const T& otherwise) const {
    return get(key, rule).value_or(otherwise);
  }

  /// Reads the value of a required key.
  template <class Rule>
  auto require(std::string_view key, const Rule& rule) const {
    return read(at(key, describe(rule)), rule);
  }

  /// Refuses known keys that other keys of the table exclude, for the reason `problem`.
  void refuse(std::initializer_list<std::string_view> keys, const std::string& problem) const;

  /// Returns the tables `[[key]]`; none if the key is missing.
  std::span<const Node> tables(std::string_view key) const;

 private:
  const Node& node_;
  const std::vector<Node>& entries_;
};

}  // namespace stokesbook::scene_text
