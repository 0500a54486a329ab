// Covers a field with evenly spaced streamlines (Jobard and Lefer 1997). Each line follows the
// direction of the flow by the explicit midpoint rule. Lengths are in cells until the end.
#include "record/streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

/// Returns the unit vector along the velocity, which is interpolated between the points of the
/// grid; none where the velocity is zero, outside the grid, and in cells with a corner outside the
/// fluid.
std::optional<Complex> direction(const Field& field, Complex x) {
  const double column = std::floor(x.real()), row = std::floor(x.imag());
  const Index columns = field.grid.columns, rows = field.grid.rows;
  if (!(column >= 0.0 && row >= 0.0 && column < static_cast<double>(columns - 1) &&
        row < static_cast<double>(rows - 1))) {
    return {};
  }
  const double right = x.real() - column, up = x.imag() - row;
  const Index i = field.grid.index(static_cast<Index>(column), static_cast<Index>(row));
  const ComplexVector& u = field.velocity;
  // Bilinear interpolation between the corners of the cell.
  const Complex below = (1.0 - right) * u[i] + right * u[i + 1];
  const Complex above = (1.0 - right) * u[i + columns] + right * u[i + columns + 1];
  const Complex velocity = (1.0 - up) * below + up * above;
  const double speed = std::abs(velocity);
  if (!(speed > 0.0)) return {};
  return velocity / speed;
}

/// The points of all lines.
class Neighbourhood {
 public:
  void add(const std::vector<Complex>& line) {
    for (const Complex point : line) index_.insert({point, point});
    points_.insert(points_.end(), line.begin(), line.end());
  }

  /// Returns whether a point is at least a distance away from all lines.
  bool is_free(Complex point, double distance) const {
    return std::ranges::none_of(index_.meeting(square_about(point, distance)), [&](std::size_t k) {
      return std::abs(points_[k] - point) < distance;
    });
  }

 private:
  RectangleIndex index_;
  std::vector<Complex> points_;
};

/// Follows the flow from a point, downstream (sign +1) or upstream (-1), and keeps a distance from
/// the lines of a neighbourhood.
Streamline follow(const Field& field, const Neighbourhood& neighbours, double nearest,
                  Complex start, double sign) {
  constexpr double step = 0.5;
  const auto most_points = static_cast<std::size_t>(20 * (field.grid.columns + field.grid.rows));
  Streamline line{{start}, false};
  double turned = 0.0, distance = 0.0;
  Complex last_direction{};
  while (line.points.size() < most_points) {
    // Midpoint rule for the direction d, step h and sign s: x <- x + s h d(x + s h/2 d(x)).
    const Complex x = line.points.back();
    const std::optional<Complex> half = direction(field, x);
    if (!half) break;
    const std::optional<Complex> whole = direction(field, x + 0.5 * sign * step * *half);
    if (!whole) break;
    const Complex next = x + sign * step * *whole;
    // A line that reverses its direction within one step has reached a stagnation point.
    if (dot(*whole, last_direction) < 0.0) break;
    if (line.points.size() > 1) turned += std::arg(*whole * std::conj(last_direction));
    last_direction = *whole;
    // A line closes when it has turned once around and passes its start: it was near, and the
    // distance grows again.
    const double next_distance = std::abs(next - start);
    line.closed =
        std::abs(turned) > 1.9 * std::numbers::pi && distance < nearest && next_distance > distance;
    if (line.closed || !neighbours.is_free(next, nearest)) break;
    line.points.push_back(next);
    distance = next_distance;
  }
  return line;
}

/// Follows the flow from a point in both directions, and joins the two parts.
Streamline through(const Field& field, const Neighbourhood& neighbours, double nearest,
                   Complex start) {
  Streamline line = follow(field, neighbours, nearest, start, 1.0);
  if (line.closed) return line;
  const Streamline upstream = follow(field, neighbours, nearest, start, -1.0);
  std::vector<Complex> points(upstream.points.rbegin(), upstream.points.rend() - 1);
  points.insert(points.end(), line.points.begin(), line.points.end());
  return {points, false};
}

}  // namespace

std::vector<Streamline> streamlines(const Field& field, double separation) {
  const FieldGrid& grid = field.grid;
  if (field.velocity.size() != grid.columns * grid.rows) {
    throw std::invalid_argument("streamlines: the field has no velocity");
  }
  const double cells = separation / grid.spacing;
  const FieldGrid in_cells{{0.0, 0.0}, 1.0, grid.columns, grid.rows};
  Neighbourhood neighbours;
  std::vector<Streamline> lines;
  for (const Complex start : in_cells.points()) {
    if (!neighbours.is_free(start, cells)) continue;
    Streamline line = through(field, neighbours, 0.5 * cells, start);
    if (static_cast<double>(line.points.size()) < 2.0 * cells) continue;
    neighbours.add(line.points);
    lines.push_back(std::move(line));
  }
  for (Streamline& line : lines) {
    for (Complex& point : line.points) point = grid.corner + grid.spacing * point;
  }
  return lines;
}

}  // namespace stokesbook
