// Parses TOML with the library toml++ into nodes that keep their place in the file for messages.
#include "scene/document.hpp"

#include <algorithm>
#include <functional>
#include <sstream>
#include <type_traits>
#include <utility>

#include <toml++/toml.h>

#include "scene/error.hpp"
#include "scene/toml_value.hpp"

namespace stokesbook::scene_text {

namespace {

using Locate = std::function<std::string(const toml::source_position&)>;

Node convert(const toml::node& source, const std::string& path, const Locate& locate);

Array convert_elements(const toml::array& source, const std::string& path, const Locate& locate) {
  Array elements;
  for (const toml::node& element : source) {
    elements.push_back(
        convert(element, path + "[" + std::to_string(elements.size()) + "]", locate));
  }
  return elements;
}

Table convert_entries(const toml::table& source, const std::string& path, const Locate& locate) {
  using Entry = std::pair<const toml::key*, const toml::node*>;
  std::vector<Entry> in_file_order;
  for (const auto& [key, node] : source) in_file_order.emplace_back(&key, &node);
  const auto position = [](const Entry& entry) {
    const toml::source_position& begin = entry.first->source().begin;
    return std::pair(begin.line, begin.column);
  };
  std::ranges::sort(in_file_order, {}, position);

  Table table;
  for (const auto& [key, node] : in_file_order) {
    Node entry = convert(*node, child_path(path, key->str()), locate);
    entry.key = key->str();
    entry.key_where = locate(key->source().begin);
    table.entries.push_back(std::move(entry));
  }
  return table;
}

std::string shown(const Array& elements) {
  constexpr std::size_t longest = 60;  // longer values would hide the message
  std::string text;
  for (const Node& element : elements) {
    if (!text.empty()) text += ", ";
    text += element.text.empty() ? "{...}" : element.text;
  }
  return text.size() > longest ? "[...]" : "[" + text + "]";
}

Node convert(const toml::node& source, const std::string& path, const Locate& locate) {
  Node node;
  node.path = path;
  node.where = node.key_where = locate(source.source().begin);
  source.visit([&](const auto& typed) {
    using Type = std::decay_t<decltype(typed)>;
    if constexpr (std::is_same_v<Type, toml::table>) {
      node.value = convert_entries(typed, path, locate);
    } else if constexpr (std::is_same_v<Type, toml::array>) {
      Array elements = convert_elements(typed, path, locate);
      node.text = shown(elements);
      node.value = std::move(elements);
    } else if constexpr (toml::is_chronological<Type>) {
      std::ostringstream text;
      text << typed;
      node.text = text.str();
      node.value = DateTime{};
    } else {
      node.text = toml_value(typed.get());
      node.value = typed.get();
    }
  });
  return node;
}

/// Refuses keys of more than most_key_parts parts: the parser calls itself once for each part, and
/// would exhaust its stack. The parts are counted as dots between characters that end a key.
void bound_keys(std::string_view text, const Locate& locate) {
  constexpr std::string_view ends = "\n,=[]{}";
  int dots = 0;
  toml::source_position at{1, 1};
  for (const char c : text) {
    if (ends.find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && ++dots >= most_key_parts) {
      throw SceneError(locate(at) + ": a key must have at most " + std::to_string(most_key_parts) +
                       " parts");
    }
    at.column = c == '\n' ? 1 : at.column + 1;
    if (c == '\n') ++at.line;
  }
}

}  // namespace

Node parse_document(std::string_view text, std::string_view file_name) {
  const Locate locate = [&](const toml::source_position& position) {
    return std::string(file_name) + ":" + std::to_string(position.line) + ":" +
           std::to_string(position.column);
  };
  bound_keys(text, locate);
  try {
    return convert(toml::parse(text), {}, locate);
  } catch (const toml::parse_error& error) {
    throw SceneError(locate(error.source().begin) + ": " + std::string(error.description()));
  }
}

Node parse_value(std::string_view text, const std::string& path, const std::string& where) {
  const Locate locate = [&](const toml::source_position&) { return where; };
  const std::string problem = where + ": " + path + " = " + std::string(text) +
                              ": must be a TOML value (write text in double quotes)";
  bound_keys(text, locate);
  try {
    const toml::table document = toml::parse("value = " + std::string(text));
    if (document.size() != 1) throw SceneError(problem);
    return convert(*document.get("value"), path, locate);
  } catch (const toml::parse_error&) {
    throw SceneError(problem);
  }
}

std::string child_path(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

}  // namespace stokesbook::scene_text
