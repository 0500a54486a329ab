// Writes an animation: the page with the player first, then one block of JSON for each frame.
#include "record/animation.hpp"

#include <cmath>
#include <concepts>
#include <functional>
#include <map>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

std::string item(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("animation: a number is not finite");
  return short_number(x, 6);
}

std::string item(Complex x) {
  return item(x.real()) + ',' + item(x.imag());
}

std::string item(std::integral auto x) {
  return std::to_string(x);
}

/// Returns a JSON array.
std::string array(const auto&... entries) {
  std::string text = '[' + ((item(entries) + ',') + ...);
  text.back() = ']';
  return text;
}

/// Returns a JSON array of the texts that a function makes of the items.
std::string list(const auto& items, auto to_text) {
  return '[' + joined(items, ",", to_text) + ']';
}

/// Returns a block of data in a page. Each < is replaced by its JSON escape, so that no text can
/// contain the tag that ends the block.
std::string data_block(const std::string& kind, std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) {
    json.replace(at, 1, "\\u003c");
  }
  return "<script type=\"application/json\" class=\"" + kind + "\">" + json + "</script>\n";
}

}  // namespace

std::string animation_head(const std::string& title, const Outlines& outlines) {
  using nlohmann::json;
  std::vector<std::string> shapes;
  std::map<std::string, std::size_t> numbers;  // numbers of the shapes, in order of appearance
  const auto shape_of = [&](const Outline& outline) {
    const std::string shape = list(outline.points, [](Complex point) { return array(point); });
    const auto [entry, is_new] = numbers.try_emplace(shape, shapes.size());
    if (is_new) shapes.push_back(shape);
    return std::to_string(entry->second);
  };
  const auto encloses = [](const Outline& wall) { return wall.encloses ? "true" : "false"; };
  const std::string bodies = list(outlines.bodies, shape_of);
  const std::string walls = list(outlines.walls, shape_of);
  return std::string(player_page) +
         data_block("run", "{\"title\":" +
                               json(title).dump(-1, ' ', true, json::error_handler_t::replace) +
                               ",\"bodies\":" + bodies + ",\"walls\":" + walls +
                               ",\"encloses\":" + list(outlines.walls, encloses) +
                               ",\"shapes\":" + list(shapes, std::identity{}) + '}');
}

std::string animation_frame(const Frame& frame) {
  const auto body_text = [](const BodyState& body) {
    return array(body.position, body.orientation, body.velocity, body.omega, body.force,
                 body.torque);
  };
  const auto wall_text = [](const WallLoad& wall) {
    return array(wall.position, wall.orientation, wall.force, wall.torque);
  };
  const auto contact_text = [&](const ContactForce& contact) {
    const auto& [a, b, point, normal, force, gap, image, shift] = contact;
    if (!frame.cell) return array(a.id(), b.id(), point, force, gap);
    return array(a.id(), b.id(), point, force, gap, image.first, image.second);
  };
  std::vector<BodyState> bodies = frame.bodies;
  std::string cell;
  if (frame.cell) {
    const auto& [lattice, centre, images] = *frame.cell;
    for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k].velocity = images[k].velocity;
    for (const Complex z : {centre, lattice.vector({1, 0}), lattice.vector({0, 1})}) {
      cell += (cell.empty() ? ",[" : ",") + short_number(z.real(), 12) + ',' +
              short_number(z.imag(), 12);
    }
    cell += ']';
  }
  return data_block("frame", '[' + short_number(frame.t, 12) + ',' + list(bodies, body_text) + ',' +
                                 list(frame.walls, wall_text) + ',' +
                                 list(frame.contacts, contact_text) + cell + ']');
}

}  // namespace stokesbook
