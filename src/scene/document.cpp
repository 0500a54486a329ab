// Parses TOML with the library toml++ into nodes that keep their place in the file for messages.
// Sets values of a document, as the command line's `--set time.dt=0.01` requests.
#include "scene/document.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

#include <toml++/toml.h>

#include "scene/write.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook::scene_text {

namespace {

// Largest number of parts of a key; a.b.c has three. The limit protects the stack: the parser and
// the functions for nested tables call themselves once for each part.
constexpr int most_key_parts = 1000;

using Locate = std::function<std::string(const toml::source_position&)>;

Node convert(const toml::node& source, const std::string& path, const Locate& locate);

Table convert_entries(const toml::table& source, const std::string& path, const Locate& locate) {
  using Entry = std::pair<const toml::key*, const toml::node*>;
  std::vector<Entry> in_file_order;
  for (const auto& [key, node] : source) in_file_order.emplace_back(&key, &node);
  std::ranges::sort(in_file_order, {}, [](const Entry& e) { return e.first->source().begin; });

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
  const std::string text = joined(elements, ", ", [](const Node& element) {
    return element.text.empty() ? "{...}" : element.text;
  });
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
      Array elements;
      for (const toml::node& element : typed) {
        const std::string index = "[" + std::to_string(elements.size()) + "]";
        elements.push_back(convert(element, path + index, locate));
      }
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

// Refuses keys of too many parts, counted as dots between characters that end a key.
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

// Parses one TOML value. `path` is its path in the document, `where` its place in messages.
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

// Returns the entry of a table, which is added if it is missing, or the element of an array.
Node& child(Node& parent, std::string_view name, const std::string& where) {
  if (auto* table = std::get_if<Table>(&parent.value)) {
    const auto found = std::ranges::find(table->entries, name, &Node::key);
    if (found != table->entries.end()) return *found;
    return table->entries.emplace_back(
        Node{std::string(name), child_path(parent.path, name), where, where, {}, Table{}});
  }
  auto* elements = std::get_if<Array>(&parent.value);
  if (elements == nullptr) {
    throw SceneError(where + ": " + parent.path + " = " + parent.text + ": has no '" +
                     std::string(name) + "' in it");
  }
  const std::optional<std::size_t> k = parse_number<std::size_t>(name);
  if (!k || *k >= elements->size()) {
    throw SceneError(where + ": " + parent.path + " has " + std::to_string(elements->size()) +
                     " elements, numbered from 0; there is no element '" + std::string(name) + "'");
  }
  return (*elements)[*k];
}

// Returns whether a value is a word that lacks quotation marks, such as fmm in
// solver.summation=fmm. Such a word has letters, digits, _ and -, begins with a letter, and is not
// a TOML value itself.
bool is_word(std::string_view text) {
  const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  return text.find_first_of(letters) == 0 &&
         text.find_first_not_of(letters + "0123456789_-") == std::string_view::npos &&
         text != "true" && text != "false" && text != "inf" && text != "nan";
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

Node with_override(Node document, std::string_view setting) {
  const std::size_t equals = setting.find('=');
  std::string_view path = setting.substr(0, equals);
  path = path.substr(0, path.find_last_not_of(' ') + 1);  // removes the blank in time.dt = 0.01
  const std::string where = "--set " + std::string(path);
  if (path.empty() || equals == std::string_view::npos) {
    throw SceneError(where + ": must have the form key=value, such as time.dt=0.01");
  }
  std::string dotted(path);  // bodies[0].n_nodes becomes bodies.0.n_nodes
  std::ranges::replace(dotted, '[', '.');
  std::erase(dotted, ']');
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

std::string child_path(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

}  // namespace stokesbook::scene_text
