// Reads the keys of a TOML table. Unknown keys are errors, with a suggestion of the key meant.
#include "scene/table_reader.hpp"

#include <algorithm>

#include "text/word_list.hpp"

namespace stokesbook::scene_text {

namespace {

const std::vector<Node>& entries_of(const Node& node) {
  if (const auto* table = std::get_if<Table>(&node.value)) return table->entries;
  fail_type(node, "a table");
}

}  // namespace

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
