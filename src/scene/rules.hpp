#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "scene/document.hpp"
#include "scene/words.hpp"
#include "text/word_list.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook::scene_text {

/// Throws the SceneError `where: path = value: problem` with the place of the value.
///
/// @param  node     the value
/// @param  problem  what is wrong with the value
/// @throws SceneError always
[[noreturn]] void fail(const Node& node, const std::string& problem);

/// Throws the same error with the place of the key, for a key that is not allowed.
///
/// @param  node     the value of the key
/// @param  problem  what is wrong with the key
/// @throws SceneError always
[[noreturn]] void fail_at_key(const Node& node, const std::string& problem);

/// Throws the SceneError "must be `expected`, not a string", with the actual type of the value.
///
/// @param  node      the value
/// @param  expected  completes "must be ..."
/// @throws SceneError always
[[noreturn]] void fail_type(const Node& node, std::string_view expected);

/// Converts a value to the type T, which must be one of the specialisations. An integer is accepted
/// as a double, which must be finite; a Complex is [x, y], a matrix is the list of its rows.
///
/// @param  node      the value
/// @param  expected  completes "must be ..."
/// @return           the value
/// @throws SceneError when the value has another type, which the message names, or a number is not
///         finite or too small or large
template <class T>
T value_as(const Node& node, std::string_view expected);

/// @cond
template <>
bool value_as(const Node& node, std::string_view expected);
template <>
int value_as(const Node& node, std::string_view expected);
template <>
std::int64_t value_as(const Node& node, std::string_view expected);
template <>
double value_as(const Node& node, std::string_view expected);
template <>
std::string value_as(const Node& node, std::string_view expected);
template <>
Complex value_as(const Node& node, std::string_view expected);
template <>
Eigen::Matrix2d value_as(const Node& node, std::string_view expected);
template <>
std::array<double, 4> value_as(const Node& node, std::string_view expected);
template <>
std::vector<double> value_as(const Node& node, std::string_view expected);
/// @endcond

/// Returns the elements of an array.
///
/// @param  node      the value
/// @param  expected  completes "must be ..."
/// @return           the elements, which the node owns
/// @throws SceneError when the value is not an array
const Array& elements_of(const Node& node, std::string_view expected);

/// @name Size of numbers
/// The solver squares and multiplies the numbers of a scene. Beyond these bounds the products would
/// underflow to zero or overflow to infinity.
/// @{
inline constexpr double smallest_number = 1e-100;  ///< least magnitude, except for zero
inline constexpr double largest_number = 1e100;    ///< largest magnitude
/// @}

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

/// Reads a value that meets a requirement.
///
/// @param  node  the value
/// @param  rule  the requirement
/// @return       the value as T
/// @throws SceneError when the value has another type or the condition does not hold
template <class T>
T read(const Node& node, const Requirement<T>& rule) {
  T value = value_as<T>(node, rule.expected);
  if (!rule.holds(value)) fail(node, "must be " + std::string(rule.expected));
  return value;
}

/// Describes a requirement.
///
/// @param  rule  the requirement
/// @return       text that completes "must be ..."
template <class T>
std::string describe(const Requirement<T>& rule) {
  return std::string(rule.expected);
}

/// Lists the names of words.
///
/// @param  words  the words that a key accepts
/// @return        the names in order, "outer, inner"
template <class T, std::size_t N>
std::string list_of(const Words<T, N>& words) {
  std::vector<std::string_view> names;
  for (const Word<T>& word : words) names.push_back(word.name);
  return joined(names);
}

/// Describes the words that a key accepts.
///
/// @param  words  the words
/// @return        text that completes "must be ..."
template <class T, std::size_t N>
std::string describe(const Words<T, N>& words) {
  return "one of " + list_of(words);
}

/// Reads a word that stands for a value of type T.
///
/// @param  node   the value
/// @param  words  the words that the key accepts
/// @return        the meaning of the word
/// @throws SceneError when the word is unknown
template <class T, std::size_t N>
T read(const Node& node, const Words<T, N>& words) {
  const std::string expected = describe(words);
  const std::string name = value_as<std::string>(node, expected);
  for (const Word<T>& word : words) {
    if (word.name == name) return word.meaning;
  }
  fail(node, "must be " + expected);
}

/// Reads a list of one or more distinct words.
///
/// @param  node   the value
/// @param  words  the words that the list accepts
/// @return        the meanings of the words, in order
/// @throws SceneError when the value is not a list, the list is empty, or a word is unknown or
///         repeated
template <class T, std::size_t N>
std::vector<T> read_distinct(const Node& node, const Words<T, N>& words) {
  const std::string expected = "a list of one or more of " + list_of(words);
  std::vector<T> meanings;
  for (const Node& element : elements_of(node, expected)) {
    const T meaning = read(element, words);
    if (std::ranges::find(meanings, meaning) != meanings.end()) {
      fail(element, "is repeated in the list");
    }
    meanings.push_back(meaning);
  }
  if (meanings.empty()) fail(node, "must be " + expected);
  return meanings;
}

/// The type of the rule for numbers of collocation nodes of a curve.
struct NodeCount {};

/// The rule for numbers of collocation nodes of a curve.
inline constexpr NodeCount node_count;

/// Reads a number of collocation nodes.
///
/// @param  node  the value
/// @param  rule  #node_count
/// @return       number of nodes, or automatic_nodes
/// @throws SceneError when the value is neither "auto" nor an even integer from 8 to 1000000; the
///         message names the nearest valid number
int read(const Node& node, NodeCount rule);

/// Describes the valid numbers of nodes.
///
/// @param  rule  #node_count
/// @return       text that completes "must be ..."
std::string describe(NodeCount rule);

/// A truth value.
inline constexpr Requirement<bool> any_flag{"true or false"};

/// A finite number.
inline constexpr Requirement<double> any_number{"a number"};

/// A plane vector.
inline constexpr Requirement<Complex> any_vector{"two numbers [x, y]"};

/// A 2 x 2 matrix.
inline constexpr Requirement<Eigen::Matrix2d> any_gradient{
    "two rows of two numbers [[a, b], [c, d]]"};

/// Corners of a box whose sides are positive and finite.
inline constexpr Requirement<std::array<double, 4>> any_box{
    "[xmin, ymin, xmax, ymax] with finite sides, xmin < xmax and ymin < ymax",
    [](const std::array<double, 4>& box) {
      const double width = box[2] - box[0], height = box[3] - box[1];
      return width > 0.0 && height > 0.0 && std::isfinite(width) && std::isfinite(height);
    }};

/// A finite number > 0.
inline constexpr Requirement<double> positive_number{"a number > 0",
                                                     [](const double& x) { return x > 0.0; }};

/// A seed of random numbers.
inline constexpr Requirement<std::int64_t> any_seed{"an integer >= 0",
                                                    [](const std::int64_t& k) { return k >= 0; }};

/// An integer >= 1.
inline constexpr Requirement<int> positive_integer{"an integer >= 1",
                                                   [](const int& k) { return k >= 1; }};
/// @}

}  // namespace stokesbook::scene_text
