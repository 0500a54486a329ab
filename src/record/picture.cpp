// Draws the configuration and the fields of a frame as SVG. The picture of a configuration shows
// walls, bodies coloured by speed, velocities and contact forces; the picture of a field shows a
// colour map, streamlines, and walls and bodies on top.
#include "record/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "record/streamlines.hpp"
#include "record/svg.hpp"
#include "text/fingerprint.hpp"
#include "text/number_text.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

namespace {

using Eigen::Index;

// Common parts of all pictures

constexpr double margin = 14.0;         // around the picture
constexpr double header_height = 54.0;  // title and time, above the drawing
constexpr double bar_column = 84.0;     // colour bar and its numbers, right of the drawing
constexpr double bar_height = 150.0;    // also the least height of a drawing
constexpr double full_width = 648.0;    // width of a drawing, unless its height is limited
constexpr double tracer_size = 4.0;     // diameter of a dot

/// Returns the scale, in pixels per length, at which a drawing of a region with a width and height
/// has its full width and is at most 1.4 times as high as this width.
double scale_of_drawing(Complex size) {
  constexpr double longest_aspect = 1.4;
  return std::min(full_width / size.real(), longest_aspect * full_width / size.imag());
}

/// Opens a picture with title and time above a drawing with a width and height; `</svg>` closes it.
std::string open_picture(Complex drawn, double t, const std::string& title) {
  // A long title widens the picture up to the width of a drawing that fills its column.
  const double title_width =
      std::min(9.0 * static_cast<double>(title.size()), full_width + bar_column);
  const Complex size(std::max(drawn.real() + bar_column, title_width) + 2.0 * margin,
                     header_height + std::max(drawn.imag(), bar_height) + margin);
  return svg::open(size, title) +
         svg::label({margin, 20.0}, title, "font-weight=\"600\" font-size=\"15\"") +
         svg::label({margin, 38.0}, "t = " + short_number(t, 6), "fill-opacity=\"0.75\"");
}

/// Values at the ends of a colour bar.
struct ValueRange {
  double low, high;
};

/// Draws a colour bar with a label and numbers, right of a drawing with a width.
std::string draw_bar(double drawn_width, const ColourMap& map, const ValueRange& range,
                     const std::string& label, const std::string& style = {}) {
  constexpr double bar_width = 12.0;
  const double left = margin + drawn_width + 26.0;
  std::string text = svg::colour_bar(map, {left, header_height}, {bar_width, bar_height}, style);
  for (const double fraction : {0.0, 0.5, 1.0}) {
    const Complex place(left + bar_width + 6.0, header_height + (1.0 - fraction) * bar_height);
    text += svg::label(place, short_number(std::lerp(range.low, range.high, fraction)),
                       "dy=\"0.35em\"");
  }
  return text + svg::label({left, header_height - 14.0}, label);
}

/// Returns the path data of an outline in its place.
std::string path_data(const auto& layout, const Outline& outline, const auto& state) {
  const auto to_drawing = [&](Complex point) { return layout.to_drawing(point); };
  return svg::polygon(placed(outline, state).unaryExpr(to_drawing));
}

/// Draws tracers as dots: lines without length that have round ends.
std::string draw_tracers(const auto& layout, const std::vector<Complex>& tracers, double size) {
  std::string dots;
  for (const Complex tracer : tracers) {
    const Complex at = layout.to_drawing(tracer);
    dots += svg::line(at, at);
  }
  return svg::path(
      dots, R"(stroke="#e0218a" stroke-linecap="round")" + svg::attribute("stroke-width", size));
}

/// Bodies and walls with their outlines.
struct Drawing {
  Frame frame;
  Outlines outlines;
};

/// Adds the images of bodies that meet a rectangle in the plane, if there is a periodic cell. They
/// are drawn like inner walls, which do not exist there.
Drawing with_images(Drawing drawing, const Rectangle& rectangle) {
  auto& [frame, outlines] = drawing;
  const Complex half = 0.5 * (rectangle.upper - rectangle.lower), centre = rectangle.lower + half;
  for (std::size_t k = 0; frame.cell && k < frame.bodies.size(); ++k) {
    const auto& [lattice, cell_centre, in_cell] = *frame.cell;
    const double radius = outlines.bodies[k].points.cwiseAbs().maxCoeff();
    const Complex position = frame.bodies[k].position;
    for (const Complex w : lattice.vectors_into_disk(position, centre, std::abs(half) + radius)) {
      const Complex beyond = position + w - centre;
      if (std::abs(w) < 0.5 * std::abs(lattice.shortest()) ||  // the body itself
          std::abs(beyond.real()) > half.real() + radius ||
          std::abs(beyond.imag()) > half.imag() + radius) {
        continue;
      }
      frame.walls.push_back({position + w, frame.bodies[k].orientation, {}});
      outlines.walls.push_back(outlines.bodies[k]);
    }
  }
  return drawing;
}

/// Adds the edge of the periodic cell, drawn like an outer wall, and the images of bodies there.
Drawing with_cell(Drawing drawing) {
  const auto corners = drawing.frame.cell->lattice.voronoi_corners();
  const Complex centre = drawing.frame.cell->centre;
  const ComplexVector edge = Eigen::Map<const ComplexVector>(corners.data(), corners.size());
  const auto [lower, upper] = bounding_rectangle(edge);
  drawing = with_images(std::move(drawing), {centre + lower, centre + upper});
  drawing.frame.walls.push_back({centre, 0.0, {}});
  drawing.outlines.walls.push_back({edge, true});
  return drawing;
}

// The picture of a configuration

/// Bodies and colour bar are slightly transparent, so that arrows are visible on dark colours.
const std::string veil = "fill-opacity=\"0.85\"";

/// The layout of a configuration: the map from the plane to pixels, colours and arrows.
struct Layout {
  /// Corners of the bounding box of curves and arrows.
  Complex low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Complex high = -low;
  double top_speed = 0.0;
  double longest_arrow = 0.0;  ///< length of the arrow of the top speed
  double scale = 1.0;          ///< pixels per length
  Complex drawn;               ///< width and height of the drawing, pixels

  void include(Complex point) {
    low = {std::min(low.real(), point.real()), std::min(low.imag(), point.imag())};
    high = {std::max(high.real(), point.real()), std::max(high.imag(), point.imag())};
  }
  /// Maps a point of the plane to pixels.
  Complex to_drawing(Complex point) const {
    const Complex top_left{low.real(), high.imag()};
    const double lowered = std::max(0.0, 0.5 * (bar_height - drawn.imag()));
    return Complex(margin, header_height + lowered) + scale * std::conj(point - top_left);
  }
  /// Returns the speed as a fraction of the top speed.
  double brightness(const BodyState& body) const {
    return top_speed > 0.0 ? std::abs(body.velocity) / top_speed : 0.0;
  }
  /// Returns the tip of the velocity arrow; the top speed must not be zero.
  Complex arrow_tip(const BodyState& body) const {
    return body.position + longest_arrow * body.velocity / top_speed;
  }
};

Layout lay_out(const Frame& frame, const Outlines& outlines, const std::vector<BodyPath>& paths) {
  const auto& [bodies, walls] = outlines;
  Layout layout;
  double radii = 0.0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    for (const Complex point : placed(bodies[k], frame.bodies[k])) layout.include(point);
    layout.top_speed = std::max(layout.top_speed, std::abs(frame.bodies[k].velocity));
    radii += bodies[k].points.cwiseAbs().maxCoeff();
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    for (const Complex point : placed(walls[k], frame.walls[k])) layout.include(point);
  }
  for (const Complex tracer : frame.tracers) layout.include(tracer);
  for (const BodyPath& path : paths) {
    for (const Complex point : path.points) layout.include(point);
  }
  if (layout.top_speed > 0.0) {
    // Twice the mean radius of the bodies, and at least 3 % of the diagonal: the longest arrow is
    // visible beside its body and in the whole picture.
    layout.longest_arrow = std::max(2.0 * radii / static_cast<double>(bodies.size()),
                                    0.03 * std::abs(layout.high - layout.low));
    for (const BodyState& body : frame.bodies) layout.include(layout.arrow_tip(body));
  }
  const Complex size = layout.high - layout.low;
  layout.scale = scale_of_drawing(size);
  layout.drawn = layout.scale * size;
  return layout;
}

std::string draw_walls(const Layout& layout, const Frame& frame,
                       const std::vector<Outline>& walls) {
  std::string curves;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    curves += svg::path(path_data(layout, walls[k], frame.walls[k]),
                        walls[k].encloses ? "fill=\"none\"" : "fill-opacity=\"0.08\"");
  }
  return svg::group(curves, R"(stroke="currentColor" stroke-width="1.5" fill="currentColor")");
}

std::string draw_bodies(const Layout& layout, const Frame& frame,
                        const std::vector<Outline>& bodies) {
  std::string curves;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    curves += svg::path(path_data(layout, bodies[k], frame.bodies[k]),
                        "fill=\"" + colour(viridis, layout.brightness(frame.bodies[k])) + '"');
  }
  return svg::group(curves, R"(stroke="currentColor" stroke-width="0.5" )" + veil);
}

/// Returns the distance from the centre to the curve along the first axis, taken at the point that
/// is nearest in direction.
double reach(const Outline& outline) {
  return std::abs(*std::ranges::min_element(
      outline.points, {}, [](Complex point) { return std::abs(std::arg(point)); }));
}

/// Marks the first axis inside each body, dark on light colours and light on dark colours.
std::string draw_ticks(const Layout& layout, const Frame& frame,
                       const std::vector<Outline>& bodies) {
  std::string on_light;
  std::string on_dark;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const BodyState& body = frame.bodies[k];
    const Complex arm = std::polar(reach(bodies[k]), body.orientation);
    (layout.brightness(body) > 0.6 ? on_light : on_dark) += svg::line(
        layout.to_drawing(body.position + 0.5 * arm), layout.to_drawing(body.position + 0.9 * arm));
  }
  const std::string round = "stroke-linecap=\"round\" stroke=";
  return svg::path(on_light, round + "\"#000\"") + svg::path(on_dark, round + "\"#fff\"");
}

std::string draw_arrows(const Layout& layout, const Frame& frame) {
  if (layout.top_speed == 0.0) return "";
  std::string data;
  for (const BodyState& body : frame.bodies) {
    const Complex tail = layout.to_drawing(body.position);
    const Complex tip = layout.to_drawing(layout.arrow_tip(body));
    const double length = std::abs(tip - tail);
    if (length < 1.0) continue;
    const Complex barb = (tail - tip) * std::min(0.35, 6.0 / length);
    const Complex turn = std::polar(1.0, 0.45);
    data += svg::line(tail, tip) + svg::line(tip + barb * turn, tip) +
            svg::line(tip, tip + barb * std::conj(turn));
  }
  return svg::path(data, "fill=\"none\" stroke=\"currentColor\" stroke-linecap=\"round\"");
}

/// Draws contact forces as lines from the bodies to the points where the forces act. The width is
/// proportional to the force, but at least half a pixel.
std::string draw_contacts(const Layout& layout, const Frame& frame) {
  if (frame.contacts.empty()) return "";
  constexpr double widest = 5.0;
  const double largest = std::ranges::max(frame.contacts, {}, &ContactForce::force).force;
  std::string lines;
  for (const ContactForce& contact : frame.contacts) {
    const Complex point = layout.to_drawing(contact.point);
    std::string data;
    for (const Complex end : contact_ends(frame, contact)) {
      if (end != contact.point) data += svg::line(layout.to_drawing(end), point);
    }
    const double width = std::max(0.5, widest * contact.force / largest);
    lines += svg::path(data, svg::attribute("stroke-width", width));
  }
  return svg::group(
      lines, R"(fill="none" stroke="#e8710a" stroke-linecap="round" stroke-linejoin="round")");
}

std::string draw_paths(const Layout& layout, const std::vector<BodyPath>& paths) {
  if (paths.empty()) return "";
  const auto to_drawing = [&](Complex point) { return layout.to_drawing(point); };
  std::string curves, numbers;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const double fraction = 0.9 * static_cast<double>(k) / static_cast<double>(paths.size());
    curves += svg::path(svg::polyline(paths[k].points.unaryExpr(to_drawing)),
                        "stroke=\"" + colour(viridis, fraction) + '"');
    numbers += svg::label(to_drawing(paths[k].points[0]), std::to_string(paths[k].body));
  }
  return svg::group(curves, R"(fill="none" stroke-width="1.5" stroke-linejoin="round")") + numbers;
}

// Pictures of fields

constexpr std::string_view velocity_name = "velocity";

std::string file_name(std::string_view quantity) {
  return "fields_" + std::string(quantity) + ".svg";
}

/// The layout of a grid: a square of the grid is one unit wide, and a unit is `scale` pixels.
struct GridLayout {
  const FieldGrid& grid;
  Complex size{static_cast<double>(grid.columns), static_cast<double>(grid.rows)};  ///< units
  double scale = scale_of_drawing(size);  ///< pixels per unit
  Complex drawn = scale * size;           ///< width and height of the drawing, pixels

  /// Maps a point of the plane to units from the top left corner, y downwards.
  Complex to_drawing(Complex point) const {
    const Complex cells = (point - grid.corner) / grid.spacing;
    return {cells.real() + 0.5, size.imag() - 0.5 - cells.imag()};
  }
};

/// Returns the values of the first and the last colour: the range of the values without the
/// smallest and the largest hundredth, made symmetric for values with a sign.
ValueRange shown_range(const Eigen::VectorXd& values, bool has_sign) {
  std::vector<double> sorted(values.begin(), values.end());
  std::erase_if(sorted, [](double x) { return std::isnan(x); });
  if (sorted.empty()) return {0.0, 0.0};
  std::ranges::sort(sorted);
  const std::size_t hundredth = sorted.size() / 100;
  const ValueRange range{sorted[hundredth], sorted[sorted.size() - 1 - hundredth]};
  if (!has_sign) return range;
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  return {-largest, largest};
}

/// Gives values to the points outside the fluid that are next to it, so that colours reach curves:
/// the mean of the neighbours that have a value.
Eigen::VectorXd with_seam(const FieldGrid& grid, const Eigen::VectorXd& values) {
  const auto map = values.reshaped(grid.columns, grid.rows).array();
  Eigen::VectorXd result = values;
  for (Index row = 0; row < grid.rows; ++row) {
    for (Index column = 0; column < grid.columns; ++column) {
      if (!std::isnan(map(column, row))) continue;
      const Index left = std::max<Index>(column - 1, 0), below = std::max<Index>(row - 1, 0);
      const auto around = map.block(left, below, std::min(column + 2, grid.columns) - left,
                                    std::min(row + 2, grid.rows) - below);
      const auto known = (!around.isNaN()).count();
      // The mean is not a number if no neighbour has a value.
      result[grid.index(column, row)] =
          around.isNaN().select(0.0, around).sum() / static_cast<double>(known);
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
  std::string lines;
  for (std::size_t level = 0; level < levels; ++level) {
    const double fraction = static_cast<double>(level) / (levels - 1);
    lines += svg::path(dashes[level], "stroke=\"" + colour(map, fraction) + '"');
  }
  return svg::group(lines,
                    "fill=\"none\" transform=\"translate(0 0.5)\" shape-rendering=\"crispEdges\"");
}

/// Draws streamlines with an arrowhead in the middle of each.
std::string draw_streamlines(const GridLayout& layout, const std::vector<Streamline>& lines,
                             const std::string& colour) {
  const auto to_drawing = [&](Complex point) { return layout.to_drawing(point); };
  std::string curves;
  std::string heads;
  for (const Streamline& line : lines) {
    const auto all = ComplexVector::Map(line.points.data(), std::ssize(line.points));
    // Every second point of a line, about one for each square, gives a smooth curve.
    const ComplexVector points = all(Eigen::seq(0, Eigen::last, 2)).unaryExpr(to_drawing);
    curves += line.closed ? svg::polygon(points) : svg::polyline(points);
    const Index middle = points.size() / 2;
    if (middle == 0) continue;
    const Complex tip = points[middle], back = points[middle - 1] - tip;
    const Complex barb = 5.0 / layout.scale * back / std::abs(back);
    heads += svg::polyline(ComplexVector{
        {tip + barb * std::polar(1.0, 0.5), tip, tip + barb * std::polar(1.0, -0.5)}});
  }
  if (lines.empty()) return {};
  return svg::group(svg::path(curves, "stroke-width=\"" + svg::number(0.8 / layout.scale) + '"') +
                        svg::path(heads, "stroke-width=\"" + svg::number(1.2 / layout.scale) + '"'),
                    "fill=\"none\" stroke=\"" + colour + "\" stroke-opacity=\"0.7\"");
}

/// Draws enclosing walls as lines, and bodies and inner walls opaque, since colours extend below
/// their curves.
std::string draw_curves(const GridLayout& layout, const Frame& frame, const Outlines& outlines) {
  const auto draw = [&](const Outline& outline, const auto& state) {
    return svg::path(path_data(layout, outline, state),
                     outline.encloses ? "fill=\"none\"" : "fill=\"#aab0b6\"");
  };
  const auto& [bodies, walls] = outlines;
  std::string curves;
  for (std::size_t k = 0; k < walls.size(); ++k) curves += draw(walls[k], frame.walls[k]);
  for (std::size_t k = 0; k < bodies.size(); ++k) curves += draw(bodies[k], frame.bodies[k]);
  return svg::group(
      curves, R"(stroke="currentColor")" + svg::attribute("stroke-width", 1.2 / layout.scale));
}

/// Clips a drawing at the enclosing walls.
std::string clip(std::string drawing, const GridLayout& layout, const Frame& frame,
                 const std::vector<Outline>& walls) {
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (!walls[k].encloses) continue;
    const std::string data = path_data(layout, walls[k], frame.walls[k]);
    // All pictures of a page share their names, so each name is made from the curve itself.
    const std::string name = "stokesbook-" + fingerprint(data);
    drawing = "<clipPath id=\"" + name + "\"><path d=\"" + data + "\"/></clipPath>\n" +
              svg::group(drawing, "clip-path=\"url(#" + name + ")\"");
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

std::string draw_configuration(const Frame& given, const Outlines& shapes, const std::string& title,
                               const std::vector<BodyPath>& paths) {
  require_outlines(given, shapes);
  if (given.bodies.empty() && given.walls.empty()) {
    throw std::invalid_argument("draw_configuration: neither bodies nor walls to draw");
  }
  const Drawing drawing = given.cell ? with_cell({given, shapes}) : Drawing{given, shapes};
  const auto& [frame, outlines] = drawing;
  const Layout layout = lay_out(frame, outlines, paths);
  std::string bar;
  if (layout.top_speed > 0.0) {
    bar = draw_bar(layout.drawn.real(), viridis, {0.0, layout.top_speed}, "speed |U|", veil);
  }
  return open_picture(layout.drawn, frame.t, title) + draw_walls(layout, frame, outlines.walls) +
         draw_bodies(layout, frame, outlines.bodies) + draw_ticks(layout, frame, outlines.bodies) +
         draw_contacts(layout, frame) + draw_tracers(layout, frame.tracers, tracer_size) +
         draw_arrows(layout, frame) + draw_paths(layout, paths) + bar + "</svg>\n";
}

std::map<std::string, std::string> draw_fields(const Frame& given, const Outlines& shapes,
                                               const std::string& title) {
  require_outlines(given, shapes);
  if (!given.field) throw std::invalid_argument("draw_fields: the frame has no field");
  const Field& field = *given.field;
  const GridLayout layout{field.grid};
  const Complex corner = field.grid.corner;
  const Drawing drawing =
      with_images({given, shapes}, {corner, corner + field.grid.spacing * layout.size});
  const Frame& frame = drawing.frame;
  const Outlines& outlines = drawing.outlines;
  std::vector<Streamline> lines;
  if (field.velocity.size() > 0) {
    constexpr double pixels_apart = 16.0;
    lines = streamlines(field, pixels_apart / layout.scale * field.grid.spacing);
  }
  const std::string curves = draw_curves(layout, frame, outlines) +
                             draw_tracers(layout, frame.tracers, tracer_size / layout.scale);
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
