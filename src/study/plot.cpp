// Draws a plot as SVG: axes, lines with markers, slope triangles, floors, a legend; or a heat map.
#include "study/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "record/svg.hpp"
#include "text/number_text.hpp"

namespace stokesbook::study {

namespace {

// The layout, in pixels.
constexpr double width = 520.0;
constexpr double left = 62.0, right = 504.0, top = 34.0, bottom = 314.0;  ///< edges of the frame
constexpr double legend_row = 19.0;
constexpr double label_height = 16.0;
constexpr double marker = 3.6;         ///< half the size of a point
constexpr double bar = 10.0;           ///< width of a colour bar, left of the frame
constexpr std::size_t label_row = 60;  ///< letters that fit into one row above the plot

/// Colours of the lines, which colour-blind readers can distinguish (Okabe and Ito 2008, darkened
/// for the light page). The markers of the lines differ too.
constexpr std::array light{"#0072b2", "#c2410c", "#00805f", "#a03c78", "#7a6200", "#3f5d75"};
constexpr std::array dark{"#56b4e9", "#f59e4b", "#2fc796", "#e08fc0", "#e3cf4a", "#a9bfd0"};

std::string style_element() {
  std::string rules, dark_rules;
  for (std::size_t k = 0; k < light.size(); ++k) {
    const std::string start = ".stokesbook-picture .line-" + std::to_string(k) + "{color:";
    rules += start + light[k] + '}';
    dark_rules += start + dark[k] + '}';
  }
  return "<style>" + rules + "@media(prefers-color-scheme:dark){" + dark_rules + "}</style>\n";
}

std::string class_of(std::size_t line) {
  return "class=\"line-" + std::to_string(line % light.size()) + '"';
}

/// An axis, which maps numbers to fractions of its length.
struct Axis {
  bool logarithmic;
  double low = 0.0, high = 0.0;  ///< ends; logarithms to base 10 on a logarithmic axis

  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  double fraction(double value) const { return (scaled(value) - low) / (high - low); }
  bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0.0); }

  void span(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    low = scaled(least);
    high = scaled(most);
  }
};

/// A number that is written along an axis.
struct Tick {
  double value;
  std::string text;
};

/// Returns a power of ten as text, 10⁻⁴.
std::string power_of_ten(int exponent) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += digits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

/// Chooses the numbers along an axis: at most about seven, unless a logarithmic axis is short.
std::vector<Tick> ticks(const Axis& axis) {
  constexpr double most = 7.0;
  std::vector<Tick> values;
  const double range = axis.high - axis.low;
  if (axis.logarithmic && range < 2.2) {
    // A short axis shows 1, 2, 5, 10, ...; if it starts above 1, powers of two, like node counts.
    const bool is_decimal = axis.low < 0.0;
    const double base = is_decimal ? 10.0 : 2.0, decades = std::log10(base);
    for (double e = std::floor(axis.low / decades); e <= axis.high / decades + 1e-9; ++e) {
      for (const double leading : {1.0, 2.0, 5.0}) {
        const double value = leading * std::pow(base, e), at = axis.fraction(value);
        const bool is_tick = (is_decimal || leading == 1.0) && at > -1e-9 && at < 1.0 + 1e-9;
        if (is_tick) values.push_back({value, short_number(value, 7)});
      }
    }
    if (values.size() > 1) return values;
    // From 40 to 100 there is only one power of two: the axis shows 40, 60, 80 and 100.
    return ticks(
        {.logarithmic = false, .low = std::pow(10.0, axis.low), .high = std::pow(10.0, axis.high)});
  }
  double step = std::ceil(range / most);
  if (!axis.logarithmic) {
    step = std::pow(10.0, std::floor(std::log10(range / most)));
    for (const double factor : {2.0, 2.5, 2.0}) {
      if (range / step > most) step *= factor;
    }
  }
  for (double k = std::ceil(axis.low / step - 1e-9); step * k <= axis.high + 1e-9 * range; ++k) {
    const double v = step * k + 0.0;  // -0 becomes 0
    values.push_back(axis.logarithmic
                         ? Tick{std::pow(10.0, v), power_of_ten(static_cast<int>(std::lround(v)))}
                         : Tick{v, short_number(v, 6)});
  }
  return values;
}

/// The layout of a plot: its axes, and the map from numbers to pixels.
struct Layout {
  Axis x, y;

  double across(double px) const { return left + (right - left) * x.fraction(px); }
  double up(double py) const { return y.shows(py) ? std::clamp(y.fraction(py), 0.0, 1.0) : 0.0; }
  double down(double py) const { return top + (bottom - top) * (1.0 - up(py)); }
  Complex pixel(const PlotPoint& point) const { return {across(point.x), down(point.y)}; }
};

/// Returns axes that contain all points and floors; no value if no point can be shown.
std::optional<Layout> lay_out(const Plot& plot) {
  Layout layout{{.logarithmic = plot.log_x}, {.logarithmic = plot.log_y}};
  std::vector<double> xs, ys(plot.floors);
  for (const PlotLine& line : plot.lines) {
    for (const PlotPoint& point : line.points) {
      if (layout.x.shows(point.x)) xs.push_back(point.x);
      for (const double y : {point.y - point.error, point.y + point.error}) {
        if (layout.y.shows(y)) ys.push_back(y);
      }
    }
  }
  if (xs.empty() || ys.empty()) return std::nullopt;
  layout.x.span(xs);
  layout.y.span(ys);
  const double range = layout.x.high - layout.x.low;
  const double margin = plot.cells ? 0.5 : 0.03 * range + (plot.log_x ? 0.02 : 1e-9);
  layout.x.low -= margin;
  layout.x.high += margin;
  if (plot.log_y) {
    layout.y.low = std::floor(layout.y.low - 0.2);
    layout.y.high = std::ceil(layout.y.high + 0.1);
  } else {
    const double most = std::max(std::abs(layout.y.low), std::abs(layout.y.high));
    const double around = std::max(0.05 * (layout.y.high - layout.y.low), 1e-4 * most + 1e-99);
    layout.y.low -= around;
    layout.y.high += around;
  }
  return layout;
}

/// Writes the label of the y axis above the axis, in two rows if one row is too short.
std::string y_label(const std::string& text) {
  const std::string bold = "font-weight=\"600\"";
  const std::size_t space = text.size() > label_row ? text.rfind(' ', label_row) : text.npos;
  if (space == text.npos) return svg::label({left, 20.0}, text, bold);
  return svg::label({left, 11.0}, text.substr(0, space), bold) +
         svg::label({left, 26.0}, text.substr(space + 1), bold);
}

/// Lists the whole numbers along the axis of a heat map.
std::vector<Tick> cases(const Axis& axis) {
  std::vector<Tick> values;
  for (double x = std::ceil(axis.low); x < axis.high; ++x) values.push_back({x, short_number(x)});
  return values;
}

/// Writes the axes with their numbers and labels, and a grid unless cells would cover it.
std::string frame(const Plot& plot, const Layout& layout) {
  std::string svg, grid;
  for (const Tick& tick : plot.cells ? cases(layout.x) : ticks(layout.x)) {
    const double x = layout.across(tick.value);
    grid += svg::line({x, top}, {x, bottom});
    svg += svg::label({x, bottom + 17.0}, tick.text, "text-anchor=\"middle\"");
  }
  for (const Tick& tick : ticks(layout.y)) {
    const double y = layout.down(tick.value);
    grid += svg::line({left, y}, {right, y});
    svg += svg::label({left - (plot.cells ? bar : 0.0) - 6.0, y + 4.0}, tick.text,
                      "text-anchor=\"end\"");
  }
  svg += y_label(plot.y_label);
  svg += svg::label({0.5 * (left + right), bottom + 37.0}, plot.x_label,
                    "text-anchor=\"middle\" font-weight=\"600\"");
  const std::string axes =
      svg::line({left, top}, {left, bottom}) + svg::line({left, bottom}, {right, bottom});
  const std::string thin = "fill=\"none\" stroke=\"currentColor\" ";
  return svg::path(plot.cells ? "" : grid, thin + "stroke-opacity=\"0.13\"") +
         svg::path(axes, thin + "stroke-opacity=\"0.6\"") + svg;
}

/// Returns the path data of a marker around a point: circle, square, triangle or diamond.
std::string marker_path(std::size_t line, Complex at) {
  if (line % 4 == 0) {
    const std::string radius = svg::number(marker);
    const std::string arc = 'a' + radius + ' ' + radius + " 0 1 0 ";
    const std::string step = svg::number(2.0 * marker);
    return 'M' + svg::number(at.real() - marker) + ' ' + svg::number(at.imag()) + arc + step +
           " 0" + arc + '-' + step + " 0Z";
  }
  const int corners = line % 4 == 2 ? 3 : 4;
  const double turn = line % 4 == 1 ? 0.5 : 0.0;  // a square is a rotated diamond
  ComplexVector points(corners);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + turn) / corners - 0.5 * std::numbers::pi;
    points[k] = at + std::polar(1.35 * marker, angle);
  }
  return svg::polygon(points);
}

std::string draw_line(const PlotLine& line, std::size_t index, const Layout& layout) {
  std::string joined, bars, filled, hollow;
  const std::size_t points_per_marker = (line.points.size() + 39) / 40;
  for (std::size_t k = 0; k < line.points.size(); ++k) {
    const PlotPoint& point = line.points[k];
    if (!layout.x.shows(point.x) || !std::isfinite(point.y)) continue;
    const Complex at = layout.pixel(point);
    joined += (joined.empty() ? 'M' : 'L') + svg::number(at.real()) + ' ' + svg::number(at.imag());
    if (k % points_per_marker == 0) (point.hollow ? hollow : filled) += marker_path(index, at);
    if (point.error == 0.0) continue;
    bars += svg::line(layout.pixel({point.x, point.y - point.error}),
                      layout.pixel({point.x, point.y + point.error}));
  }
  return svg::group(svg::path(joined, "fill=\"none\" stroke-opacity=\"0.55\"") +
                        svg::path(bars, "fill=\"none\"") +
                        svg::path(filled, "fill=\"currentColor\"") +
                        svg::path(hollow, "fill=\"none\""),
                    class_of(index) + " stroke=\"currentColor\" stroke-width=\"1.4\"");
}

std::string draw_guide(const Guide& guide, const Layout& layout) {
  const Complex from = layout.pixel(guide.from), to = layout.pixel(guide.to);
  const std::string style = class_of(guide.line) + " stroke=\"currentColor\" fill=\"none\"";
  if (guide.slope.empty()) {
    return svg::group(
        svg::path(svg::line(from, to), "stroke-width=\"1.2\" stroke-dasharray=\"6 4\""), style);
  }
  const Complex below{0.0, 16.0}, corner{from.real(), to.imag()};
  const ComplexVector points{{from + below, to + below, corner + below}};
  return svg::group(svg::path(svg::polygon(points), "stroke-width=\"1\""), style) +
         svg::label(0.5 * (from + corner) + below + Complex{-5.0, 4.0}, guide.slope,
                    "text-anchor=\"end\"");
}

/// Draws the guides; of triangles with the same slope that would cover each other, only the first.
std::string draw_guides(const std::vector<Guide>& guides, const Layout& layout) {
  std::string svg;
  std::vector<std::pair<std::string, Complex>> triangles;  // slope and place
  for (const Guide& guide : guides) {
    const Complex place = layout.pixel(guide.from);
    const bool is_covered = std::ranges::any_of(triangles, [&](const auto& triangle) {
      return triangle.first == guide.slope && std::abs(triangle.second - place) < label_height;
    });
    if (is_covered) continue;
    if (!guide.slope.empty()) triangles.emplace_back(guide.slope, place);
    svg += draw_guide(guide, layout);
  }
  return svg;
}

/// Draws a colour bar, and each line as a row of cells below its label.
std::string draw_cells(const Plot& plot, const Layout& layout) {
  std::string svg = svg::colour_bar(viridis, {left - bar, top}, {bar - 2.0, bottom - top});
  const double row = (bottom - top) / static_cast<double>(plot.lines.size());
  for (double y = top; const PlotLine& line : plot.lines) {
    svg += svg::label({left + 2.0, y + 12.0}, line.label, "font-size=\"12\"");
    for (const PlotPoint& point : line.points) {
      if (!std::isfinite(point.y)) continue;
      const Complex from(layout.across(point.x - 0.46), y + 15.0);
      const Complex to(layout.across(point.x + 0.46), y + row - 2.0);
      const ComplexVector corners{{from, {to.real(), from.imag()}, to, {from.real(), to.imag()}}};
      svg +=
          svg::path(svg::polygon(corners), "fill=\"" + colour(viridis, layout.up(point.y)) + '"');
    }
    y += row;
  }
  return svg;
}

std::string legend(const Plot& plot) {
  std::string svg;
  double y = bottom + 56.0;  // below the label of the x axis
  for (std::size_t k = 0; k < plot.lines.size(); ++k, y += legend_row) {
    svg += "<g " + class_of(k) + " stroke=\"currentColor\">" +
           svg::path(marker_path(k, {left + 6.0, y - 4.0}), "fill=\"currentColor\"") + "</g>\n" +
           svg::label({left + 20.0, y}, plot.lines[k].label);
  }
  return svg;
}

}  // namespace

std::string draw_plot(const Plot& plot) {
  const std::optional<Layout> layout = lay_out(plot);
  if (!layout) return "<p>Nothing to plot: all errors are zero.</p>\n";
  const double rows = plot.cells ? 0.0 : static_cast<double>(plot.lines.size());
  const double height = bottom + 48.0 + legend_row * rows;
  std::string svg = svg::open({width, height}, plot.title) + style_element() + frame(plot, *layout);
  if (plot.cells) return svg + draw_cells(plot, *layout) + "</svg>\n";
  std::string floors;
  for (const double level : plot.floors) {
    const double y = layout->down(level);
    floors += svg::line({left, y}, {right, y});
  }
  svg += svg::path(floors, "fill=\"none\" stroke=\"currentColor\" stroke-dasharray=\"1.5 4\"");
  svg += draw_guides(plot.guides, *layout);
  for (std::size_t k = 0; k < plot.lines.size(); ++k) svg += draw_line(plot.lines[k], k, *layout);
  return svg + legend(plot) + "</svg>\n";
}

}  // namespace stokesbook::study
