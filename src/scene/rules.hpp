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
#include "scene/joined.hpp"
#include "scene/words.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook::scene_text {

/// Throws the SceneError `where: path = value: problem`, where the value stands.
///
/// @param  node     the value
/// @param  problem  what is wrong with it
/// @throws SceneError always
[[noreturn]] void fail(const Node& node, const std::string& problem);

/// Throws the same where the key stands, for a key that should not be there at all.
///
/// @param  node     the value of the key
/// @param  problem  what is wrong with the key
/// @throws SceneError always
[[noreturn]] void fail_at_key(const Node& node, const std::string& problem);

/// Throws the SceneError "must be `expected`, not a string", or whatever the type of the value is.
///
/// @param  node      the value
/// @param  expected  completes "must be ..."
/// @throws SceneError always
[[noreturn]] void fail_type(const Node& node, std::string_view expected);

/// Returns a value as T, one of those below. Integers will do for double, which must be finite; a
/// Complex is [x, y], a matrix is a list of its rows.
///
/// @param  node      the value
/// @param  expected  completes "must be ..."
/// @return           the value
/// @throws SceneError when the value has another type, saying which
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
/// @return           its elements, part of the node
/// @throws SceneError when the value is no array
const Array& elements_of(const Node& node, std::string_view expected);

/// @name Size of numbers
/// A solver squares and multiplies what a scene gives; of numbers beyond these the products are zero
/// or infinite.
/// @{
inline constexpr double smallest_number = 1e-100;  ///< but for zero
inline constexpr double largest_number = 1e100;    ///< in magnitude
/// @}

/// @name Rules
/// What a value must be, said once: `read(node, rule)` converts and checks it or throws a
/// SceneError, `describe(rule)` completes "must be ...".
/// @{

/// A value of type T for which a condition holds.
template <class T>
struct Requirement {
  std::string_view expected;  ///< completes "must be ..."
  /// Tells whether a value is right; unless given, all are.
  bool (*holds)(const T&) = [](const T&) { return true; };
};

/// Reads a value that meets a requirement.
///
/// @param  node  the value
/// @param  rule  what it must be
/// @return       the value as T
/// @throws SceneError when it has another type or the condition does not hold
template <class T>
T read(const Node& node, const Requirement<T>& rule) {
  T value = value_as<T>(node, rule.expected);
  if (!rule.holds(value)) fail(node, "must be " + std::string(rule.expected));
  return value;
}

/// Says what a requirement asks.
///
/// @param  rule  the requirement
/// @return       text that completes "must be ..."
template <class T>
std::string describe(const Requirement<T>& rule) {
  return std::string(rule.expected);
}

/// Lists the words.
///
/// @param  words  all that may stand in one place
/// @return        "outer, inner"
template <class T, std::size_t N>
std::string list_of(const Words<T, N>& words) {
  std::vector<std::string_view> names;
  for (const Word<T>& word : words) names.push_back(word.name);
  return joined(names);
}

/// Says which words may stand in a place.
///
/// @param  words  all of them
/// @return        text that completes "must be ..."
template <class T, std::size_t N>
std::string describe(const Words<T, N>& words) {
  return "one of " + list_of(words);
}

/// Reads a word that stands for a T.
///
/// @param  node   the value
/// @param  words  all that may stand in its place
/// @return        its meaning
/// @throws SceneError when it is another word
template <class T, std::size_t N>
T read(const Node& node, const Words<T, N>& words) {
  const std::string expected = describe(words);
  const std::string name = value_as<std::string>(node, expected);
  for (const Word<T>& word : words) {
    if (word.name == name) return word.meaning;
  }
  fail(node, "must be " + expected);
}

/// Reads a list of one or more words, none of them twice.
///
/// @param  node   the value
/// @param  words  all that may stand in the list
/// @return        their meanings, in order
/// @throws SceneError when it is no list, is empty, or holds another word or one twice
template <class T, std::size_t N>
std::vector<T> read_distinct(const Node& node, const Words<T, N>& words) {
  const std::string expected = "a list of one or more of " + list_of(words);
  std::vector<T> meanings;
  for (const Node& element : elements_of(node, expected)) {
    const T meaning = read(element, words);
    if (std::ranges::find(meanings, meaning) != meanings.end()) fail(element, "is there already");
    meanings.push_back(meaning);
  }
  if (meanings.empty()) fail(node, "must be " + expected);
  return meanings;
}

/// Number of collocation nodes of a curve.
struct NodeCount {};

/// The only rule of its kind.
inline constexpr NodeCount node_count;

/// Reads a number of collocation nodes.
///
/// @param  node  the value
/// @param  rule  #node_count
/// @return       number of nodes, or automatic_nodes
/// @throws SceneError when it is neither an even integer from 8 to 1000000, the nearest of which the
///         message names, nor "auto"
int read(const Node& node, NodeCount rule);

/// Says what a number of nodes must be.
///
/// @param  rule  #node_count
/// @return       text that completes "must be ..."
std::string describe(NodeCount rule);

/// A Boolean.
inline constexpr Requirement<bool> any_flag{"true or false"};

/// A finite number.
inline constexpr Requirement<double> any_number{"a number"};

/// A plane vector.
inline constexpr Requirement<Complex> any_vector{"two numbers [x, y]"};

/// A 2 x 2 matrix.
inline constexpr Requirement<Eigen::Matrix2d> any_gradient{
    "two rows of two numbers [[a, b], [c, d]]"};

/// Corners of a box that is not empty, with sides that are numbers.
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
