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

/// Parses a TOML document; returns a Table. Messages contain the name of the file.
/// @throws SceneError when the text is not valid TOML
Node parse_document(std::string_view text, std::string_view file_name);

/// Returns the document with one value set from the command line. Missing tables are added.
/// @param  setting  `time.dt=0.01`, `bodies.0.n_nodes=64` or `bodies[0].n_nodes=64`: path, `=`,
///                  value in TOML's syntax, or a word without quotation marks
/// @throws SceneError when the setting has another form, or its path does not fit the document
Node with_override(Node document, std::string_view setting);

/// Returns the path of an entry of a table, "time.dt"; the path of the whole document is empty.
std::string child_path(const std::string& path, std::string_view key);

}  // namespace stokesbook::scene_text
