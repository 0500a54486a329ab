// Draws a configuration as SVG: walls, bodies coloured by speed, velocities and contact forces.
#include "record/picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "record/picture_parts.hpp"

namespace stokesbook {

namespace {

using namespace picture_parts;

/// Bodies and colour bar are slightly transparent, so that arrows are visible on dark colours.
const std::string veil = "fill-opacity=\"0.85\"";

/// The bounding box of points.
struct Box {
  Complex low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Complex high = -low;

  void include(const auto& points) {
    for (const Complex point : points) {
      low = {std::min(low.real(), point.real()), std::min(low.imag(), point.imag())};
      high = {std::max(high.real(), point.real()), std::max(high.imag(), point.imag())};
    }
  }
};

/// The layout of a configuration: its curves and arrows, and the map from the plane to pixels.
struct Layout {
  std::vector<ComplexVector> bodies;
  std::vector<ComplexVector> walls;
  std::vector<Complex> arrow_tips;
  double top_speed = 0.0;
  Box box;
  double scale = 1.0;  ///< pixels per length
  Complex drawn;       ///< width and height of the drawing, pixels

  Complex pixel(Complex point) const {
    const Complex top_left{box.low.real(), box.high.imag()};
    const double lowered = std::max(0.0, 0.5 * (bar_height - drawn.imag()));
    return Complex(margin, header_height + lowered) + scale * std::conj(point - top_left);
  }
  /// Returns the speed as a fraction of the top speed.
  double brightness(const BodyState& body) const {
    return top_speed > 0.0 ? std::abs(body.velocity) / top_speed : 0.0;
  }
};

/// Returns the length of the longest arrow: twice the mean radius of the bodies, and at least 3 %
/// of the picture's diagonal. The arrow is thus visible beside its body and in the whole picture.
double longest_arrow(const std::vector<Outline>& bodies, const Box& box) {
  double radii = 0.0;
  for (const Outline& body : bodies) radii += body.points.cwiseAbs().maxCoeff();
  return std::max(2.0 * radii / static_cast<double>(bodies.size()),
                  0.03 * std::abs(box.high - box.low));
}

Layout lay_out(const Frame& frame, const Outlines& outlines) {
  Layout layout;
  const auto place = [&](const Outline& outline, const auto& state) {
    const ComplexVector curve = placed(outline, state);
    layout.box.include(curve);
    return curve;
  };
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    layout.bodies.push_back(place(outlines.bodies[k], frame.bodies[k]));
    layout.top_speed = std::max(layout.top_speed, std::abs(frame.bodies[k].velocity));
  }
  for (std::size_t k = 0; k < frame.walls.size(); ++k) {
    layout.walls.push_back(place(outlines.walls[k], frame.walls[k]));
  }
  if (layout.top_speed > 0.0) {
    const double longest = longest_arrow(outlines.bodies, layout.box);
    for (const BodyState& body : frame.bodies) {
      layout.arrow_tips.push_back(body.position + longest * body.velocity / layout.top_speed);
    }
    layout.box.include(layout.arrow_tips);
  }
  const Complex size = layout.box.high - layout.box.low;
  layout.scale = scale_of_drawing(size);
  layout.drawn = layout.scale * size;
  return layout;
}

/// Draws a curve of the plane as a closed polygon.
std::string draw_polygon(const Layout& layout, const ComplexVector& curve,
                         const std::string& style) {
  const auto pixel = [&](Complex point) { return layout.pixel(point); };
  return svg::path(svg::polygon(curve.unaryExpr(pixel)), style);
}

std::string draw_walls(const Layout& layout, const std::vector<Outline>& walls) {
  std::string text = "<g stroke=\"currentColor\" stroke-width=\"1.5\" fill=\"currentColor\">\n";
  for (std::size_t k = 0; k < walls.size(); ++k) {
    text += draw_polygon(layout, layout.walls[k],
                         walls[k].encloses ? "fill=\"none\"" : "fill-opacity=\"0.08\"");
  }
  return text + "</g>\n";
}

std::string draw_bodies(const Layout& layout, const Frame& frame) {
  std::string text = "<g stroke=\"currentColor\" stroke-width=\"0.5\" " + veil + ">\n";
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    text += draw_polygon(layout, layout.bodies[k],
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
  std::string data;
  for (std::size_t k = 0; k < layout.arrow_tips.size(); ++k) {
    const Complex tail = layout.pixel(frame.bodies[k].position);
    const Complex tip = layout.pixel(layout.arrow_tips[k]);
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
  return open_picture(layout.drawn, frame.t, title) + draw_walls(layout, outlines.walls) +
         draw_bodies(layout, frame) + draw_ticks(layout, frame, outlines.bodies) +
         draw_contacts(layout, frame) + draw_arrows(layout, frame) + bar + "</svg>\n";
}

}  // namespace stokesbook
