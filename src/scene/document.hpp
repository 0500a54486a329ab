#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// What stands in a scene file, before anyone asks whether it makes sense.
namespace stokesbook::scene_text {

struct Node;

/// A value of a type that no key has.
struct DateTime {};

/// Values in order.
using Array = std::vector<Node>;

/// Keys and their values.
struct Table {
  std::vector<Node> entries;  ///< in the order of the file
};

/// A value of a TOML document and where it stands.
struct Node {
  std::string key;        ///< name in its table; empty in an array
  std::string path;       ///< from the top, "bodies[0].n_nodes"
  std::string key_where;  ///< where the key stands
  std::string where;      ///< where the value stands, "couette.toml:12:11" or "--set time.dt"
  std::string text;       ///< the value as messages show it; empty for a table
  /// The value itself.
  std::variant<bool, std::int64_t, double, std::string, DateTime, Array, Table> value;
};

/// Parts of a key at most, as in a.b.c: parser and tables use the stack for each part.
inline constexpr int most_key_parts = 1000;

/// Parses a TOML document.
///
/// @param  text       TOML
/// @param  file_name  what messages call it
/// @return            the whole document, a Table
/// @throws SceneError when the text is no TOML
Node parse_document(std::string_view text, std::string_view file_name);

/// Parses one TOML value; whatever is wrong in it is said to stand at `where`.
///
/// @param  text   the value
/// @param  path   of the value in the document it will be part of
/// @param  where  as messages say it
/// @return        the value, without a key
/// @throws SceneError when the text is no single TOML value
Node parse_value(std::string_view text, const std::string& path, const std::string& where);

/// Returns the path of an entry of a table.
///
/// @param  path  of the table; empty: the whole document
/// @param  key   of the entry
/// @return       "time.dt"
std::string child_path(const std::string& path, std::string_view key);

}  // namespace stokesbook::scene_text
