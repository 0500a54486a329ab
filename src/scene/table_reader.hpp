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

/// A table of the document, all of whose keys are known.
class TableReader {
 public:
  /// Takes a first look at a table whose keys depend on its kind: any key will do.
  ///
  /// @param  node  the table, which must outlive the reader
  /// @throws SceneError when the node is no table
  explicit TableReader(const Node& node);

  /// Takes a table and checks its keys.
  ///
  /// @param  node   the table, which must outlive the reader
  /// @param  known  keys that may stand in it
  /// @throws SceneError when the node is no table, or at the first key that is not among `known`,
  ///         with the known key that may have been meant
  TableReader(const Node& node, std::span<const std::string_view> known);

  /// Takes a table and checks its keys.
  ///
  /// @param  node   the table, which must outlive the reader
  /// @param  known  keys that may stand in it
  /// @throws SceneError as with a span of keys
  TableReader(const Node& node, std::initializer_list<std::string_view> known)
      : TableReader(node, std::span(known.begin(), known.size())) {}

  /// Looks for a key.
  ///
  /// @param  key  its name
  /// @return      its value, or null
  const Node* find(std::string_view key) const;

  /// Returns the value of a key.
  ///
  /// @param  key       its name
  /// @param  expected  completes "must be ..."
  /// @return           its value
  /// @throws SceneError when the key is missing
  const Node& at(std::string_view key, const std::string& expected) const;

  /// Reads the value of a key that may be missing.
  ///
  /// @param  key   its name
  /// @param  rule  what its value must be
  /// @return       what the rule reads; none when the key is missing
  /// @throws SceneError when the value is wrong
  template <class Rule>
  auto get(std::string_view key, const Rule& rule) const {
    const Node* value = find(key);
    return value ? std::optional(read(*value, rule)) : std::nullopt;
  }

  /// Reads the value of a key.
  ///
  /// @param  key   its name
  /// @param  rule  what its value must be
  /// @return       what the rule reads
  /// @throws SceneError when the key is missing or its value wrong
  template <class Rule>
  auto require(std::string_view key, const Rule& rule) const {
    return read(at(key, describe(rule)), rule);
  }

  /// Refuses keys that are known, but may not stand here.
  ///
  /// @param  keys     their names
  /// @param  problem  why they may not
  /// @throws SceneError when one of the keys is there
  void refuse(std::initializer_list<std::string_view> keys, const std::string& problem) const;

  /// Returns the tables `[[key]]`.
  ///
  /// @param  key  their name
  /// @return      the elements of the array; none when the key is missing
  /// @throws SceneError when the value is no array
  std::span<const Node> tables(std::string_view key) const;

 private:
  const Node& node_;
  const std::vector<Node>& entries_;
};

}  // namespace stokesbook::scene_text
