// Draws the common parts of the pictures of a run: title, time and colour bar.
#include "record/picture_parts.hpp"

#include <algorithm>
#include <cmath>

#include "text/number_text.hpp"

namespace stokesbook::picture_parts {

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

}  // namespace stokesbook::picture_parts
