// Writes pieces of SVG text: numbers, paths, labels, the head of a picture, and colours.
#include "record/svg.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace svg {

namespace {

std::string pair(Complex point) {
  return number(point.real()) + ' ' + number(point.imag());
}

/// The style sets the colour of a class, so that a page with the picture inline can override it.
constexpr const char* page_style =
    "<style>.stokesbook-picture{color:#1f2328;font:13px system-ui,sans-serif}"
    "@media(prefers-color-scheme:dark){.stokesbook-picture{color:#d5dbe1}}</style>\n";

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&'                              ? "&amp;"
              : c == '<'                            ? "&lt;"
              : c == '"'                            ? "&quot;"
              : static_cast<unsigned char>(c) < ' ' ? " "
                                                    : std::string(1, c);
  }
  return result;
}

std::string number(double x) {
  // The shortest text of a multiple of 0.01 has at most two decimals; + 0 turns -0 into 0.
  return number_text(std::round(100.0 * x) / 100.0 + 0.0);
}

std::string attribute(const std::string& name, double x) {
  return ' ' + name + "=\"" + number(x) + '"';
}

std::string line(Complex from, Complex to) {
  return 'M' + pair(from) + 'L' + pair(to);
}

std::string polyline(const ComplexVector& points) {
  return 'M' + joined(points, " ", pair);
}

std::string polygon(const ComplexVector& corners) {
  return polyline(corners) + 'Z';
}

std::string path(const std::string& data, const std::string& style) {
  return data.empty() ? "" : "<path " + style + " d=\"" + data + "\"/>\n";
}

std::string group(const std::string& elements, const std::string& style) {
  return "<g " + style + ">\n" + elements + "</g>\n";
}

std::string label(Complex start, const std::string& text, const std::string& style) {
  return "<text" + attribute("x", start.real()) + attribute("y", start.imag()) +
         " fill=\"currentColor\" " + style + '>' + escaped(text) + "</text>\n";
}

std::string open(Complex size, const std::string& title) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"stokesbook-picture\" role=\"img\"" +
         attribute("width", size.real()) + attribute("height", size.imag()) + " viewBox=\"0 0 " +
         pair(size) + "\">\n<title>" + escaped(title) + "</title>\n" + page_style;
}

std::string colour_bar(const ColourMap& map, Complex corner, Complex size,
                       const std::string& style) {
  // All pictures of a page share their names, so each name is that of one colour map.
  const std::string name = "stokesbook-" + std::string(map.name);
  std::string text = "<linearGradient id=\"" + name + "\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">\n";
  for (std::size_t k = 0; k < map.samples.size(); ++k) {
    const double fraction = static_cast<double>(k) / static_cast<double>(map.samples.size() - 1);
    text += "<stop offset=\"" + number(100.0 * fraction) + "%\" stop-color=\"" +
            colour(map, fraction) + "\"/>\n";
  }
  return text + "</linearGradient>\n<rect" + attribute("x", corner.real()) +
         attribute("y", corner.imag()) + attribute("width", size.real()) +
         attribute("height", size.imag()) + " rx=\"2\" fill=\"url(#" + name + ")\" " + style +
         "/>\n";
}

}  // namespace svg

std::string colour(const ColourMap& map, double fraction) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto& samples = map.samples;
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
  const std::size_t left = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  std::string colour = "#";
  for (const int shift : {16, 8, 0}) {
    const auto channel = [&](int sample) { return sample >> shift & 0xff; };
    const double value = std::lerp(channel(samples[left]), channel(samples[left + 1]),
                                   place - static_cast<double>(left));
    const auto byte = static_cast<std::size_t>(std::lround(value));
    colour += {digits[byte / 16], digits[byte % 16]};
  }
  return colour;
}

}  // namespace stokesbook
