// Follows lines of flow on a grid so that they cover it evenly.
#include "record/streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace stokesbook {

using Eigen::Index;

namespace {

/// The direction of the flow between the points of a grid. Lengths are cells.
class Directions {
 public:
  explicit Directions(const Field& field) : field_(field) {}

  /// Returns the unit vector along the velocity; none at rest, outside the grid and beside
  /// boundaries.
  std::optional<Complex> operator()(Complex x) const {
    const double column = std::floor(x.real()), row = std::floor(x.imag());
    const FieldGrid& grid = field_.grid;
    if (!(column >= 0.0 && row >= 0.0 && column < static_cast<double>(grid.columns - 1) &&
          row < static_cast<double>(grid.rows - 1))) {
      return {};
    }
    const double right = x.real() - column, up = x.imag() - row;
    const Index i = grid.index(static_cast<Index>(column), static_cast<Index>(row));
    const ComplexVector& u = field_.velocity;
    const Complex below = (1.0 - right) * u[i] + right * u[i + 1];
    const Complex above = (1.0 - right) * u[i + grid.columns] + right * u[i + grid.columns + 1];
    const Complex velocity = (1.0 - up) * below + up * above;
    const double speed = std::abs(velocity);
    if (!(speed > 0.0)) return {};
    return velocity / speed;
  }

 private:
  const Field& field_;
};

/// Points of lines, found by their place.
class Neighbourhood {
 public:
  Neighbourhood(const FieldGrid& grid, double separation)
      : separation_(separation),
        columns_(buckets(grid.columns)),
        rows_(buckets(grid.rows)),
        points_(static_cast<std::size_t>(columns_ * rows_)) {}

  void add(const std::vector<Complex>& line) {
    for (const Complex point : line) points_[bucket(column(point), row(point))].push_back(point);
  }

  /// Tells whether a point is at least a distance, at most the separation, from all lines.
  bool is_free(Complex point, double distance) const {
    for (Index j = std::max<Index>(0, row(point) - 1); j <= std::min(rows_ - 1, row(point) + 1);
         ++j) {
      for (Index i = std::max<Index>(0, column(point) - 1);
           i <= std::min(columns_ - 1, column(point) + 1); ++i) {
        for (const Complex other : points_[bucket(i, j)]) {
          if (std::abs(other - point) < distance) return false;
        }
      }
    }
    return true;
  }

 private:
  Index buckets(Index points) const {
    return 1 + static_cast<Index>(static_cast<double>(points) / separation_);
  }
  // The last step of a line may leave the grid.
  Index place(double coordinate, Index count) const {
    return std::clamp<Index>(static_cast<Index>(coordinate / separation_), 0, count - 1);
  }
  Index column(Complex point) const { return place(point.real(), columns_); }
  Index row(Complex point) const { return place(point.imag(), rows_); }
  std::size_t bucket(Index i, Index j) const { return static_cast<std::size_t>(j * columns_ + i); }

  double separation_;
  Index columns_, rows_;
  std::vector<std::vector<Complex>> points_;
};

/// Follows the flow one way. Lengths are cells.
class Tracer {
 public:
  Tracer(const Field& field, const Neighbourhood& neighbours, double separation)
      : direction_(field),
        neighbours_(neighbours),
        nearest_(0.5 * separation),
        most_points_(20 * static_cast<std::size_t>(field.grid.columns + field.grid.rows)) {}

  /// Follows the flow from a point, downstream (+1) or upstream (-1).
  Streamline operator()(Complex start, double sign) const {
    Streamline line{{start}, false};
    double turned = 0.0, distance = 0.0;
    Complex last_direction{};
    while (line.points.size() < most_points_) {
      const Complex x = line.points.back();
      const std::optional<Complex> half = direction_(x);
      if (!half) break;
      const std::optional<Complex> whole = direction_(x + 0.5 * sign * step * *half);
      if (!whole) break;
      const Complex next = x + sign * step * *whole;
      // A line that turns back within a step is at a point of rest.
      if (dot(*whole, last_direction) < 0.0) break;
      if (line.points.size() > 1) turned += std::arg(*whole * std::conj(last_direction));
      last_direction = *whole;
      // Round once, a line closes where it passes its start.
      const double next_distance = std::abs(next - start);
      line.closed = std::abs(turned) > 1.9 * std::numbers::pi && distance < nearest_ &&
                    next_distance > distance;
      if (line.closed || !neighbours_.is_free(next, nearest_)) break;
      line.points.push_back(next);
      distance = next_distance;
    }
    return line;
  }

 private:
  static constexpr double step = 0.5;
  Directions direction_;
  const Neighbourhood& neighbours_;
  double nearest_;
  std::size_t most_points_;
};

Streamline through(Complex start, const Tracer& trace) {
  Streamline line = trace(start, 1.0);
  if (line.closed) return line;
  const Streamline upstream = trace(start, -1.0);
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
  Neighbourhood neighbours(grid, cells);
  const Tracer trace(field, neighbours, cells);
  std::vector<Streamline> lines;
  for (Index row = 0; row < grid.rows; ++row) {
    for (Index column = 0; column < grid.columns; ++column) {
      const Complex start(static_cast<double>(column), static_cast<double>(row));
      if (!neighbours.is_free(start, cells)) continue;
      Streamline line = through(start, trace);
      if (static_cast<double>(line.points.size()) < 2.0 * cells) continue;
      neighbours.add(line.points);
      lines.push_back(std::move(line));
    }
  }
  for (Streamline& line : lines) {
    for (Complex& point : line.points) point = grid.corner + grid.spacing * point;
  }
  return lines;
}

}  // namespace stokesbook
