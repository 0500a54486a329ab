#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document.hpp"
#include "scene/rules.hpp"

namespace stokesbook::scene_text {

/// A reader for the keys of one table of the document, which must outlive the reader.
class TableReader {
 public:
  /// Opens a table without a check of its keys, for tables whose keys depend on their kind.
  /// @throws SceneError when the node is not a table
  explicit TableReader(const Node& node);

  /// Opens a table and checks its keys.
  /// @throws SceneError when the node is not a table, or at the first key that is not known; the
  ///         message suggests the known key that was probably meant
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
