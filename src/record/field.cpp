// Lists the points of a grid row by row.
#include "record/field.hpp"

namespace stokesbook {

using Eigen::Index;

ComplexVector FieldGrid::points() const {
  ComplexVector points(columns * rows);
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column < columns; ++column) {
      points[index(column, row)] =
          corner + spacing * Complex{static_cast<double>(column), static_cast<double>(row)};
    }
  }
  return points;
}

}  // namespace stokesbook
