#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stokesbook {

/// A table of numbers that a run has written: columns with names.
struct NumberTable {
  std::filesystem::path path;                ///< file, for messages
  std::vector<std::string> names;            ///< header
  std::vector<std::vector<double>> columns;  ///< one for each name, all of one length

  /// Returns the column with a name.
  /// @throws RecordError when the table has no such column
  const std::vector<double>& operator[](std::string_view name) const;
};

/// Reads a table of numbers as csv.hpp writes it.
/// @throws RecordError when the file cannot be read, a row is not whole, or a cell is no number
NumberTable read_table(const std::filesystem::path& path);

}  // namespace stokesbook
