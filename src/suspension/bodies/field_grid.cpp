// Places the grid on which a run writes fields: square cells, centred in the box of the scene
// (chapter 12).
#include "suspension/bodies/field_grid.hpp"

#include <algorithm>
#include <cmath>

namespace stokesbook {

using Eigen::Index;

FieldGrid field_grid(const FieldSettings& settings) {
  const auto [left, bottom, right, top] = settings.box;
  const double width = right - left, height = top - bottom;
  const double spacing = std::max(width, height) / (settings.resolution - 1);
  const auto cells = [&](double side) { return std::max(1.0, std::round(side / spacing)); };
  const Complex size(cells(width), cells(height));
  const Complex centre(0.5 * (left + right), 0.5 * (bottom + top));
  return {centre - 0.5 * spacing * size, spacing, static_cast<Index>(size.real()) + 1,
          static_cast<Index>(size.imag()) + 1};
}

}  // namespace stokesbook
