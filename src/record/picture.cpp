// Draws the common parts of pictures (title, time and colour bar), and a configuration: walls,
// bodies coloured by speed, velocities and contact forces.
#include "record/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "text/number_text.hpp"

namespace stokesbook {

namespace picture_parts {

double scale_of_drawing(Complex size) {
  constexpr double longest_aspect = 1.4;
  return std::min(full_width / size.real(), longest_aspect * full_width / size.imag());
}

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

std::string draw_bar(double drawn_width, const ColourMap& map, const ValueRange& range,
                     const std::string& label, const std::string& style) {
  constexpr double bar_width = 12.0;
  const double left = margin + drawn_width + 26.0;
  // All pictures of a page share their names, so each name is that of one colour map.
  const std::string name = "stokesbook-" + std::string(map.name);
  std::string text = "<linearGradient id=\"" + name + "\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">\n";
  for (std::size_t k = 0; k < map.samples.size(); ++k) {
    const double fraction = static_cast<double>(k) / static_cast<double>(map.samples.size() - 1);
    text += "<stop offset=\"" + svg::number(100.0 * fraction) + "%\" stop-color=\"" +
            colour(map, fraction) + "\"/>\n";
  }
  text += "</linearGradient>\n<rect" + svg::attribute("x", left) +
          svg::attribute("y", header_height) + svg::attribute("width", bar_width) +
          svg::attribute("height", bar_height) + " rx=\"2\" fill=\"url(#" + name + ")\" " + style +
          "/>\n";
  for (const double fraction : {0.0, 0.5, 1.0}) {
    const Complex place(left + bar_width + 6.0, header_height + (1.0 - fraction) * bar_height);
    text += svg::label(place, short_number(std::lerp(range.low, range.high, fraction)),
                       "dy=\"0.35em\"");
  }
  return text + svg::label({left, header_height - 14.0}, label);
}

}  // namespace picture_parts

namespace {

using namespace picture_parts;

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
  Complex pixel(Complex point) const {
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

Layout lay_out(const Frame& frame, const Outlines& outlines) {
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

/// Draws a body or wall as a closed polygon.
std::string draw_outline(const Layout& layout, const Outline& outline, const auto& state,
                         const std::string& style) {
  const auto pixel = [&](Complex point) { return layout.pixel(point); };
  return svg::path(svg::polygon(placed(outline, state).unaryExpr(pixel)), style);
}

std::string draw_walls(const Layout& layout, const Frame& frame,
                       const std::vector<Outline>& walls) {
  std::string text = "<g stroke=\"currentColor\" stroke-width=\"1.5\" fill=\"currentColor\">\n";
  for (std::size_t k = 0; k < walls.size(); ++k) {
    text += draw_outline(layout, walls[k], frame.walls[k],
                         walls[k].encloses ? "fill=\"none\"" : "fill-opacity=\"0.08\"");
  }
  return text + "</g>\n";
}

std::string draw_bodies(const Layout& layout, const Frame& frame,
                        const std::vector<Outline>& bodies) {
  std::string text = "<g stroke=\"currentColor\" stroke-width=\"0.5\" " + veil + ">\n";
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    text += draw_outline(layout, bodies[k], frame.bodies[k],
                         "fill=\"" + colour(viridis, layout.brightness(frame.bodies[k])) + '"');
  }
  return text + "</g>\n";
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
    (layout.brightness(body) > 0.6 ? on_light : on_dark) +=
        svg::line(layout.pixel(body.position + 0.5 * arm), layout.pixel(body.position + 0.9 * arm));
  }
  const std::string round = "stroke-linecap=\"round\" stroke=";
  return svg::path(on_light, round + "\"#000\"") + svg::path(on_dark, round + "\"#fff\"");
}

std::string draw_arrows(const Layout& layout, const Frame& frame) {
  if (layout.top_speed == 0.0) return "";
  std::string data;
  for (const BodyState& body : frame.bodies) {
    const Complex tail = layout.pixel(body.position);
    const Complex tip = layout.pixel(layout.arrow_tip(body));
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
  std::string text =
      "<g fill=\"none\" stroke=\"#e8710a\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const ContactForce& contact : frame.contacts) {
    const Complex point = layout.pixel(contact.point);
    std::string data;
    for (const ContactParty& party : {contact.a, contact.b}) {
      if (party.is_wall) continue;
      data += svg::line(layout.pixel(frame.bodies[party.number].position), point);
    }
    const double width = std::max(0.5, widest * contact.force / largest);
    text += svg::path(data, svg::attribute("stroke-width", width));
  }
  return text + "</g>\n";
}

}  // namespace

std::string draw_configuration(const Frame& frame, const Outlines& outlines,
                               const std::string& title) {
  require_outlines(frame, outlines);
  if (frame.bodies.empty() && frame.walls.empty()) {
    throw std::invalid_argument("draw_configuration: neither bodies nor walls to draw");
  }
  const Layout layout = lay_out(frame, outlines);
  std::string bar;
  if (layout.top_speed > 0.0) {
    bar = draw_bar(layout.drawn.real(), viridis, {0.0, layout.top_speed}, "speed |U|", veil);
  }
  return open_picture(layout.drawn, frame.t, title) + draw_walls(layout, frame, outlines.walls) +
         draw_bodies(layout, frame, outlines.bodies) + draw_ticks(layout, frame, outlines.bodies) +
         draw_contacts(layout, frame) + draw_arrows(layout, frame) + bar + "</svg>\n";
}

}  // namespace stokesbook
