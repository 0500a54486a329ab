#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// A scene file as a tree of TOML values, before the meaning of the values is checked.
namespace stokesbook::scene_text {

struct Node;

/// A date or time: a TOML value that no key of a scene accepts.
struct DateTime {};

/// Elements of a TOML array, in order.
using Array = std::vector<Node>;

/// Entries of a TOML table: keys and their values.
struct Table {
  std::vector<Node> entries;  ///< in the order of the file
};

/// A value of a TOML document and its place in the file.
struct Node {
  std::string key;        ///< name in its table; empty in an array
  std::string path;       ///< path from the root, "bodies[0].n_nodes"
  std::string key_where;  ///< place of the key
  std::string where;      ///< place of the value, "couette.toml:12:11" or "--set time.dt"
  std::string text;       ///< the value as messages show it; empty for a table
  /// The value itself.
  std::variant<bool, std::int64_t, double, std::string, DateTime, Array, Table> value;
};

/// Largest number of parts of a key; a.b.c has three. The limit protects the stack: the parser and
/// the functions for nested tables call themselves once for each part.
inline constexpr int most_key_parts = 1000;

/// Parses a TOML document.
///
/// @param  text       TOML
/// @param  file_name  name of the file in messages
/// @return            the whole document, a Table
/// @throws SceneError when the text is not valid TOML
Node parse_document(std::string_view text, std::string_view file_name);

/// Parses one TOML value. Messages about errors in the value name the place `where`.
///
/// @param  text   the value
/// @param  path   path of the value in its document
/// @param  where  place of the value in messages
/// @return        the value, without a key
/// @throws SceneError when the text is not a single TOML value
Node parse_value(std::string_view text, const std::string& path, const std::string& where);

/// Returns the path of an entry of a table.
///
/// @param  path  path of the table; empty for the whole document
/// @param  key   key of the entry
/// @return       the path of the entry, "time.dt"
std::string child_path(const std::string& path, std::string_view key);

}  // namespace stokesbook::scene_text
