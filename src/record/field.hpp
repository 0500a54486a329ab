#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// A grid of points in rows and columns, with square cells.
struct FieldGrid {
  Complex corner;            ///< the lower left point, length
  double spacing = 1.0;      ///< distance of neighbours in both directions, > 0, length
  Eigen::Index columns = 0,  ///< points along x
      rows = 0;              ///< points along y

  /// Returns the points of the grid, columns x rows, x running fastest, length.
  ComplexVector points() const {
    return ComplexVector::NullaryExpr(columns * rows, [this](Eigen::Index i) {
      const auto column = static_cast<double>(i % columns), row = static_cast<double>(i / columns);
      return corner + spacing * Complex{column, row};
    });
  }

  /// Returns the index in points() of the point in a column (from 0, left to right) and a row (from
  /// 0, upwards).
  Eigen::Index index(Eigen::Index column, Eigen::Index row) const { return row * columns + column; }
};

/// Quantities of the flow at the points of a grid. Quantities that were not requested are empty.
///
/// At points outside the fluid (inside bodies, outside an enclosing wall) values are not a number.
struct Field {
  FieldGrid grid;                      ///< the points
  std::vector<std::uint8_t> in_fluid;  ///< for each point: 1 in the fluid, else 0
  ComplexVector velocity;              ///< length / time
  Eigen::VectorXd pressure;            ///< force / length^2
  Eigen::VectorXd vorticity;           ///< d_1 u_2 - d_2 u_1, 1 / time
  Eigen::VectorXd shear_stress;        ///< sigma_12, force / length^2
  Eigen::VectorXd dissipation;         ///< 2 mu e : e, force / (length time)
};

/// A scalar quantity of a field, with its name in files.
struct FieldScalar {
  std::string_view name;           ///< one word
  Eigen::VectorXd Field::*values;  ///< member of Field with the values
  bool has_sign;                   ///< whether values may be negative
};

/// All scalar quantities that a field may have.
inline constexpr std::array<FieldScalar, 4> field_scalars{
    {{"pressure", &Field::pressure, true},
     {"vorticity", &Field::vorticity, true},
     {"shear_stress", &Field::shear_stress, true},
     {"dissipation", &Field::dissipation, false}}};

}  // namespace stokesbook
