// Sets one value of a scene document, as the command line's `--set time.dt=0.01` requests.
#include "scene/override.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string>
#include <utility>

#include "scene/csv_table.hpp"
#include "scene/error.hpp"

namespace stokesbook::scene_text {

namespace {

Node& entry(Node& parent, std::string_view key, const std::string& where) {
  std::vector<Node>& entries = std::get<Table>(parent.value).entries;
  const auto found = std::ranges::find(entries, key, &Node::key);
  if (found != entries.end()) return *found;
  return entries.emplace_back(
      Node{std::string(key), child_path(parent.path, key), where, where, {}, Table{}});
}

Node& element(Node& parent, std::string_view index, const std::string& where) {
  Array& elements = std::get<Array>(parent.value);
  std::size_t k = 0;
  const auto [end, status] = std::from_chars(index.data(), index.data() + index.size(), k);
  if (status != std::errc{} || end != index.data() + index.size() || k >= elements.size()) {
    throw SceneError(where + ": " + parent.path + " has " + std::to_string(elements.size()) +
                     " elements, numbered from 0; there is no element '" + std::string(index) +
                     "'");
  }
  return elements[k];
}

/// Rewrites a path in the style of messages, bodies[0].n_nodes, as bodies.0.n_nodes.
std::string with_dots(std::string_view path) {
  std::string dotted(path);
  std::ranges::replace(dotted, '[', '.');
  std::erase(dotted, ']');
  return dotted;
}

Node& child(Node& parent, std::string_view name, const std::string& where) {
  if (std::holds_alternative<Table>(parent.value)) return entry(parent, name, where);
  if (std::holds_alternative<Array>(parent.value)) return element(parent, name, where);
  throw SceneError(where + ": " + parent.path + " = " + parent.text + ": has no '" +
                   std::string(name) + "' in it");
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Returns whether a value is a word that lacks quotation marks, such as fmm in
/// solver.summation=fmm. Such a word has letters, digits, _ and -, begins with a letter, and is not
/// a TOML value itself.
bool is_word(std::string_view text) {
  constexpr std::string_view values[] = {"true", "false", "inf", "nan"};
  const auto is_of_word = [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && is_letter(text.front()) && std::ranges::all_of(text, is_of_word) &&
         std::ranges::find(values, text) == std::end(values);
}

}  // namespace

Node with_override(Node document, std::string_view setting) {
  const std::size_t equals = setting.find('=');
  std::string_view path = setting.substr(0, equals);
  path = path.substr(0, path.find_last_not_of(' ') + 1);  // removes the blank in time.dt = 0.01
  const std::string where = "--set " + std::string(path);
  if (path.empty() || equals == std::string_view::npos) {
    throw SceneError(where + ": must have the form key=value, such as time.dt=0.01");
  }
  const std::string dotted = with_dots(path);
  if (std::ranges::count(dotted, '.') >= most_key_parts) {
    throw SceneError("--set: a key must have at most " + std::to_string(most_key_parts) + " parts");
  }
  Node* target = &document;
  for (const std::string_view name : split(dotted, '.')) target = &child(*target, name, where);
  std::string text(setting.substr(equals + 1));
  if (is_word(text)) text = '"' + text + '"';
  Node value = parse_value(text, target->path, where);
  value.key = target->key;
  *target = std::move(value);
  return document;
}

}  // namespace stokesbook::scene_text
