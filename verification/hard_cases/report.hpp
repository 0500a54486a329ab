#pragma once

#include <iosfwd>
#include <vector>

#include "hard_case.hpp"

namespace stokesbook::verification::hard_cases {

/// A hard case, its result, and the seconds that it took.
struct Row {
  HardCase hard;
  Finding finding;
  double seconds;
};

/// Prints one row.
void print(std::ostream& out, const Row& row);

/// Writes all rows as a table for a page of the book, as HTML.
void write_table(std::ostream& out, const std::vector<Row>& rows);

}  // namespace stokesbook::verification::hard_cases
