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

/// A reader for the keys of one table of the document.
class TableReader {
 public:
  /// Opens a table without a check of its keys, for tables whose keys depend on their kind.
  ///
  /// @param  node  the table, which must outlive the reader
  /// @throws SceneError when the node is not a table
  explicit TableReader(const Node& node);

  /// Opens a table and checks its keys.
  ///
  /// @param  node   the table, which must outlive the reader
  /// @param  known  keys that the table may have
  /// @throws SceneError when the node is not a table, or at the first unknown key; the message
  ///         suggests the known key that was probably meant
  TableReader(const Node& node, std::span<const std::string_view> known);

  /// Opens a table and checks its keys.
  ///
  /// @param  node   the table, which must outlive the reader
  /// @param  known  keys that the table may have
  /// @throws SceneError as the constructor with a span of keys does
  TableReader(const Node& node, std::initializer_list<std::string_view> known)
      : TableReader(node, std::span(known.begin(), known.size())) {}

  /// Looks for a key.
  ///
  /// @param  key  its name
  /// @return      its value; null if the key is missing
  const Node* find(std::string_view key) const;

  /// Returns the value of a required key.
  ///
  /// @param  key       its name
  /// @param  expected  completes "must be ..."
  /// @return           its value
  /// @throws SceneError when the key is missing
  const Node& at(std::string_view key, const std::string& expected) const;

  /// Reads the value of a key that may be missing.
  ///
  /// @param  key   its name
  /// @param  rule  rule for its value
  /// @return       the value that the rule reads; none if the key is missing
  /// @throws SceneError when the value is wrong
  template <class Rule>
  auto get(std::string_view key, const Rule& rule) const {
    const Node* value = find(key);
    return value ? std::optional(read(*value, rule)) : std::nullopt;
  }

  /// Reads the value of a required key.
  ///
  /// @param  key   its name
  /// @param  rule  rule for its value
  /// @return       the value that the rule reads
  /// @throws SceneError when the key is missing or its value is wrong
  template <class Rule>
  auto require(std::string_view key, const Rule& rule) const {
    return read(at(key, describe(rule)), rule);
  }

  /// Refuses known keys that other keys of the table exclude.
  ///
  /// @param  keys     their names
  /// @param  problem  the reason, for the message
  /// @throws SceneError when the table has one of the keys
  void refuse(std::initializer_list<std::string_view> keys, const std::string& problem) const;

  /// Returns the tables `[[key]]`.
  ///
  /// @param  key  their name
  /// @return      the elements of the array; none if the key is missing
  /// @throws SceneError when the value is not an array
  std::span<const Node> tables(std::string_view key) const;

 private:
  const Node& node_;
  const std::vector<Node>& entries_;
};

}  // namespace stokesbook::scene_text
