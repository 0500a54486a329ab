// Draws fields of the flow as SVG: a colour map, streamlines, and walls and bodies on top.
#include "record/field_picture.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "record/picture.hpp"
#include "record/streamlines.hpp"
#include "text/fingerprint.hpp"

namespace stokesbook {

namespace {

using namespace picture_parts;
using Eigen::Index;

constexpr std::string_view velocity_name = "velocity";

std::string file_name(std::string_view quantity) {
  return "fields_" + std::string(quantity) + ".svg";
}

/// The layout of a grid: a square of the grid is one unit wide, and a unit is `scale` pixels.
struct GridLayout {
  const FieldGrid& grid;
  double scale;   ///< pixels per unit
  Complex drawn;  ///< width and height of the drawing, pixels

  explicit GridLayout(const FieldGrid& points) : grid(points) {
    const Complex size(static_cast<double>(grid.columns), static_cast<double>(grid.rows));
    scale = scale_of_drawing(size);
    drawn = scale * size;
  }

  /// Returns the places of points in units from the top left corner, y downwards.
  ComplexVector units(const ComplexVector& points) const {
    return points.unaryExpr([this](Complex point) -> Complex {
      const Complex cells = (point - grid.corner) / grid.spacing;
      return {cells.real() + 0.5, static_cast<double>(grid.rows) - 0.5 - cells.imag()};
    });
  }
};

/// Returns the values of the first and the last colour: the range of the values without the
/// smallest and the largest hundredth, made symmetric for values with a sign.
ValueRange shown_range(const Eigen::VectorXd& values, bool has_sign) {
  std::vector<double> sorted;
  for (const double value : values) {
    if (!std::isnan(value)) sorted.push_back(value);
  }
  if (sorted.empty()) return {0.0, 0.0};
  std::ranges::sort(sorted);
  const std::size_t hundredth = sorted.size() / 100;
  const ValueRange range{sorted[hundredth], sorted[sorted.size() - 1 - hundredth]};
  if (!has_sign) return range;
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  return {-largest, largest};
}

/// Returns the mean of the neighbours that have a value; not a number if no neighbour has a value.
double mean_of_neighbours(const FieldGrid& grid, const Eigen::VectorXd& values, Index column,
                          Index row) {
  double sum = 0.0, count = 0.0;
  for (Index j = std::max<Index>(row - 1, 0); j < std::min(row + 2, grid.rows); ++j) {
    for (Index i = std::max<Index>(column - 1, 0); i < std::min(column + 2, grid.columns); ++i) {
      const double value = values[grid.index(i, j)];
      if (std::isnan(value)) continue;
      sum += value;
      count += 1.0;
    }
  }
  return sum / count;
}

/// Gives values to the points outside the fluid that are next to it, so that colours reach curves.
Eigen::VectorXd with_seam(const FieldGrid& grid, const Eigen::VectorXd& values) {
  Eigen::VectorXd result = values;
  for (Index row = 0; row < grid.rows; ++row) {
    for (Index column = 0; column < grid.columns; ++column) {
      double& value = result[grid.index(column, row)];
      if (std::isnan(value)) value = mean_of_neighbours(grid, values, column, row);
    }
  }
  return result;
}

/// Draws the colours as lines one unit thick, with one dash for all neighbours of equal colour.
std::string draw_map(const FieldGrid& grid, const Eigen::VectorXd& values, const ColourMap& map,
                     const ValueRange& range) {
  constexpr int levels = 65;  // odd, so that zero has the middle colour
  const auto level_of = [&](double value) {
    if (std::isnan(value)) return -1;
    const double spread = range.high - range.low;
    const double fraction = spread > 0.0 ? std::clamp((value - range.low) / spread, 0.0, 1.0) : 0.5;
    return static_cast<int>(std::lround(fraction * (levels - 1)));
  };
  std::vector<std::string> dashes(levels);
  for (Index row = 0; row < grid.rows; ++row) {
    const std::string y = std::to_string(grid.rows - 1 - row);
    for (Index first = 0, last = 0; first < grid.columns; first = last) {
      const int level = level_of(values[grid.index(first, row)]);
      do {
        ++last;
      } while (last < grid.columns && level_of(values[grid.index(last, row)]) == level);
      if (level < 0) continue;
      dashes[static_cast<std::size_t>(level)] +=
          'M' + std::to_string(first) + ' ' + y + 'h' + std::to_string(last - first);
    }
  }
  std::string text =
      "<g fill=\"none\" transform=\"translate(0 0.5)\" shape-rendering=\"crispEdges\">\n";
  for (std::size_t level = 0; level < levels; ++level) {
    const double fraction = static_cast<double>(level) / (levels - 1);
    text += svg::path(dashes[level], "stroke=\"" + colour(map, fraction) + '"');
  }
  return text + "</g>\n";
}

/// Draws streamlines with an arrowhead in the middle of each.
std::string draw_streamlines(const GridLayout& layout, const std::vector<Streamline>& lines,
                             const std::string& colour) {
  std::string curves;
  std::string heads;
  for (const Streamline& line : lines) {
    const auto all = ComplexVector::Map(line.points.data(), std::ssize(line.points));
    // Every second point of a line, about one for each square, gives a smooth curve.
    const ComplexVector points = layout.units(all(Eigen::seq(0, Eigen::last, 2)));
    curves += line.closed ? svg::polygon(points) : svg::polyline(points);
    const Index middle = points.size() / 2;
    if (middle == 0) continue;
    const Complex tip = points[middle], back = points[middle - 1] - tip;
    const Complex barb = 5.0 / layout.scale * back / std::abs(back);
    heads += svg::polyline(ComplexVector{
        {tip + barb * std::polar(1.0, 0.5), tip, tip + barb * std::polar(1.0, -0.5)}});
  }
  if (lines.empty()) return {};
  return "<g fill=\"none\" stroke=\"" + colour + "\" stroke-opacity=\"0.7\">\n" +
         svg::path(curves, "stroke-width=\"" + svg::number(0.8 / layout.scale) + '"') +
         svg::path(heads, "stroke-width=\"" + svg::number(1.2 / layout.scale) + '"') + "</g>\n";
}

/// Returns the path data of an outline in its place.
std::string path_data(const GridLayout& layout, const Outline& outline, const auto& state) {
  return svg::polygon(layout.units(placed(outline, state)));
}

/// Draws enclosing walls as lines, and bodies and inner walls opaque, since colours extend below
/// their curves.
std::string draw_curves(const GridLayout& layout, const Frame& frame, const Outlines& outlines) {
  const auto draw = [&](const Outline& outline, const auto& state) {
    return svg::path(path_data(layout, outline, state),
                     outline.encloses ? "fill=\"none\"" : "fill=\"#aab0b6\"");
  };
  const auto& [bodies, walls] = outlines;
  std::string text =
      "<g stroke=\"currentColor\" stroke-width=\"" + svg::number(1.2 / layout.scale) + "\">\n";
  for (std::size_t k = 0; k < walls.size(); ++k) text += draw(walls[k], frame.walls[k]);
  for (std::size_t k = 0; k < bodies.size(); ++k) text += draw(bodies[k], frame.bodies[k]);
  return text + "</g>\n";
}

/// Clips a drawing at the enclosing walls.
std::string clip(std::string drawing, const GridLayout& layout, const Frame& frame,
                 const std::vector<Outline>& walls) {
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (!walls[k].encloses) continue;
    const std::string data = path_data(layout, walls[k], frame.walls[k]);
    // All pictures of a page share their names, so each name is made from the curve itself.
    const std::string name = "stokesbook-" + fingerprint(data);
    drawing = "<clipPath id=\"" + name + "\"><path d=\"" + data +
              "\"/></clipPath>\n<g clip-path=\"url(#" + name + ")\">\n" + drawing + "</g>\n";
  }
  return drawing;
}

/// Opens an inner picture that shows the squares of the grid and cuts off everything outside.
std::string open_window(const GridLayout& layout) {
  const FieldGrid& grid = layout.grid;
  return "<svg" + svg::attribute("x", margin) + svg::attribute("y", header_height) +
         svg::attribute("width", layout.drawn.real()) +
         svg::attribute("height", layout.drawn.imag()) + " viewBox=\"0 0 " +
         std::to_string(grid.columns) + ' ' + std::to_string(grid.rows) + "\">\n";
}

std::string label_of(std::string_view quantity) {
  std::string label(quantity == velocity_name ? "speed |u|" : quantity);
  std::ranges::replace(label, '_', ' ');
  return label;
}

}  // namespace

std::map<std::string, std::string> draw_fields(const Frame& frame, const Outlines& outlines,
                                               const std::string& title) {
  require_outlines(frame, outlines);
  if (!frame.field) throw std::invalid_argument("draw_fields: the frame has no field");
  const Field& field = *frame.field;
  const GridLayout layout(field.grid);
  std::vector<Streamline> lines;
  if (field.velocity.size() > 0) {
    constexpr double pixels_apart = 16.0;
    lines = streamlines(field, pixels_apart / layout.scale * field.grid.spacing);
  }
  const std::string curves = draw_curves(layout, frame, outlines);
  std::map<std::string, std::string> pictures;
  const auto draw = [&](std::string_view quantity, const Eigen::VectorXd& values, bool has_sign) {
    if (values.size() == 0) return;
    const ColourMap& colours = has_sign ? cool_to_warm : viridis;
    const ValueRange range = shown_range(values, has_sign);
    const std::string map = draw_map(field.grid, with_seam(field.grid, values), colours, range);
    pictures[file_name(quantity)] =
        open_picture(layout.drawn, frame.t, title) + open_window(layout) +
        clip(map, layout, frame, outlines.walls) +
        draw_streamlines(layout, lines, has_sign ? "#000" : "#fff") + curves + "</svg>\n" +
        draw_bar(layout.drawn.real(), colours, range, label_of(quantity)) + "</svg>\n";
  };
  draw(velocity_name, field.velocity.cwiseAbs(), false);
  for (const auto& [name, values, has_sign] : field_scalars) draw(name, field.*values, has_sign);
  return pictures;
}

bool is_field_picture(const std::string& name) {
  return name == file_name(velocity_name) ||
         std::ranges::any_of(field_scalars, [&](const FieldScalar& scalar) {
           return name == file_name(scalar.name);
         });
}

}  // namespace stokesbook
