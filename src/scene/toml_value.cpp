// Writes values in TOML's syntax; numbers are written so that reading restores them exactly.
#include "scene/toml_value.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <functional>
#include <variant>

#include "scene/words.hpp"

namespace stokesbook::scene_text {

namespace {

std::string list(const auto& values, const auto& name) {
  std::string text;
  for (const auto& value : values) {
    if (!text.empty()) text += ", ";
    text += toml_value(name(value));
  }
  return "[" + text + "]";
}

std::string list(const auto& values) {
  return list(values, std::identity{});
}

std::string value_of(const Circle& circle) {
  return inline_table({{"kind", "circle"}, {"radius", circle.radius}});
}

std::string value_of(const Ellipse& ellipse) {
  return inline_table({{"kind", "ellipse"}, {"semi_axes", Complex{ellipse.a, ellipse.b}}});
}

std::string value_of(const Star& star) {
  return inline_table({{"kind", "star"},
                       {"radius", star.radius},
                       {"amplitude", star.amplitude},
                       {"arms", star.arms}});
}

std::string value_of(const Superellipse& curve) {
  return inline_table(
      {{"kind", "superellipse"}, {"semi_axes", Complex{curve.a, curve.b}}, {"power", curve.power}});
}

std::string value_of(const NodalCurve& curve) {
  return inline_table({{"kind", "nodes"}, {"points", curve.points}});
}

std::string value_of(const FixedWall&) {
  return inline_table({{"kind", "fixed"}});
}

std::string value_of(const RotatingWall& wall) {
  return inline_table({{"kind", "rotating"}, {"omega", wall.omega}});
}

std::string value_of(const TranslatingWall& wall) {
  return inline_table({{"kind", "translating"}, {"velocity", wall.velocity}});
}

std::string value_of(const LinearWall& wall) {
  return inline_table({{"kind", "linear"}, {"gradient", wall.gradient}});
}

std::string value_of(const RadialWall& wall) {
  return inline_table({{"kind", "radial"}, {"speed", wall.speed}});
}

}  // namespace

std::string toml_value(double number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  const std::string text(digits.data(), end);
  // Digits alone would be an integer in TOML, with 64 bits only. A point, an exponent, inf and nan
  // make the text a float.
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string toml_value(Complex vector) {
  return list(std::array{vector.real(), vector.imag()});
}

std::string toml_value(const Eigen::Matrix2d& matrix) {
  return list(std::array{Complex{matrix(0, 0), matrix(0, 1)}, Complex{matrix(1, 0), matrix(1, 1)}});
}

std::string toml_value(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      quoted += {'\\', letter};
    } else if (code < 0x20 || code == 0x7f) {  // TOML requires control characters to be escaped
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(code));
      quoted += escape.data();
    } else {
      quoted += letter;
    }
  }
  return quoted + '"';
}

std::string toml_value(std::span<const double> numbers) {
  return list(numbers);
}

std::string toml_value(const ComplexVector& points) {
  return list(points);
}

std::string toml_value(const std::vector<OutputFormat>& formats) {
  return list(formats, [](OutputFormat format) { return name_of(format, output_formats); });
}

std::string toml_value(const std::vector<FieldQuantity>& quantities) {
  return list(quantities, [](FieldQuantity q) { return name_of(q, field_quantities); });
}

std::string toml_value(const Shape& shape) {
  return std::visit([](const auto& curve) { return value_of(curve); }, shape);
}

std::string toml_value(const WallMotion& motion) {
  return std::visit([](const auto& wall) { return value_of(wall); }, motion);
}

std::string lines(std::initializer_list<Entry> entries) {
  std::string text;
  for (const Entry& entry : entries) text += entry.text + "\n";
  return text;
}

std::string inline_table(std::initializer_list<Entry> entries) {
  std::string text;
  for (const Entry& entry : entries) text += (text.empty() ? "" : ", ") + entry.text;
  return "{ " + text + " }";
}

}  // namespace stokesbook::scene_text
