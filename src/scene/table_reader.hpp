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
  /// For a first look at a table whose keys depend on its kind: any key will do.
  /// @throws SceneError when the node is no table
  explicit TableReader(const Node& node);

  /// @throws SceneError when the node is no table, or at the first key that is not among `known`,
  ///         with the known key that may have been meant
  TableReader(const Node& node, std::span<const std::string_view> known);
  TableReader(const Node& node, std::initializer_list<std::string_view> known)
      : TableReader(node, std::span(known.begin(), known.size())) {}

  const Node& node() const { return node_; }

  /// Returns the value of a key, or null.
  const Node* find(std::string_view key) const;

  /// Returns the value of a key.
  ///
  /// @param  key       its name
  /// @param  expected  completes "must be ..."
  /// @throws SceneError when the key is missing
  const Node& at(std::string_view key, const std::string& expected) const;

  /// Returns what the rule reads, or nothing when the key is missing.
  template <class Rule>
  auto get(std::string_view key, const Rule& rule) const {
    const Node* value = find(key);
    return value ? std::optional(read(*value, rule)) : std::nullopt;
  }

  /// Returns what the rule reads.
  ///
  /// @throws SceneError when the key is missing
  template <class Rule>
  auto require(std::string_view key, const Rule& rule) const {
    return read(at(key, describe(rule)), rule);
  }

  /// @throws SceneError when one of the keys is there
  void refuse(std::initializer_list<std::string_view> keys, const std::string& problem) const;

  /// Returns the tables `[[key]]`, none when the key is missing.
  ///
  /// @throws SceneError when the value is no array
  std::span<const Node> tables(std::string_view key) const;

 private:
  const Node& node_;
  const std::vector<Node>& entries_;
};

}  // namespace stokesbook::scene_text
