// Writes an animation: the page with the player first, then one block of JSON for each frame.
#include "record/animation.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "record/player_page.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

void append_item(std::string& text, double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("animation: a number is not finite");
  text += short_number(x, 6);
}

void append_item(std::string& text, Complex x) {
  append_item(text, x.real());
  text += ',';
  append_item(text, x.imag());
}

void append_item(std::string& text, const ContactParty& party) {
  const auto number = static_cast<long>(party.number);
  text += std::to_string(party.is_wall ? -1 - number : number);
}

/// Returns a JSON array.
std::string array(const auto&... entries) {
  std::string text = "[";
  ((append_item(text, entries), text += ','), ...);
  text.back() = ']';
  return text;
}

/// Returns a JSON array of the texts that a function makes of the items.
std::string list(const auto& items, auto to_text) {
  std::string text = "[";
  for (const auto& item : items) {
    if (text.size() > 1) text += ',';
    text += to_text(item);
  }
  return text + ']';
}

/// Returns a block of data in a page. Each < is replaced by its JSON escape, so that no text can
/// contain the tag that ends the block.
std::string data_block(const std::string& kind, std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) {
    json.replace(at, 1, "\\u003c");
  }
  return "<script type=\"application/json\" class=\"" + kind + "\">" + json + "</script>\n";
}

/// Numbers texts in order of appearance; equal texts have the same number.
class Distinct {
 public:
  std::string number_of(const std::string& text) {
    const auto [entry, is_new] = numbers_.try_emplace(text, texts_.size());
    if (is_new) texts_.push_back(text);
    return std::to_string(entry->second);
  }
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> texts_;
};

}  // namespace

std::string animation_head(const std::string& title, const std::vector<Outline>& bodies,
                           const std::vector<Outline>& walls) {
  using nlohmann::json;
  Distinct shapes;
  const auto shape_of = [&](const Outline& outline) {
    return shapes.number_of(list(outline.points, [](Complex point) { return array(point); }));
  };
  const auto encloses = [](const Outline& wall) { return wall.encloses ? "true" : "false"; };
  const std::string shapes_of_bodies = list(bodies, shape_of);
  const std::string shapes_of_walls = list(walls, shape_of);
  return std::string(player_page) +
         data_block("run", "{\"title\":" +
                               json(title).dump(-1, ' ', true, json::error_handler_t::replace) +
                               ",\"bodies\":" + shapes_of_bodies + ",\"walls\":" + shapes_of_walls +
                               ",\"encloses\":" + list(walls, encloses) +
                               ",\"shapes\":" + list(shapes.texts(), std::identity{}) + '}');
}

std::string animation_frame(const Frame& frame) {
  const auto body_text = [](const BodyState& body) {
    return array(body.position, body.orientation, body.velocity, body.omega, body.force,
                 body.torque);
  };
  const auto wall_text = [](const WallLoad& wall) {
    return array(wall.position, wall.orientation, wall.force, wall.torque);
  };
  const auto contact_text = [](const ContactForce& contact) {
    return array(contact.a, contact.b, contact.point, contact.force, contact.gap);
  };
  return data_block("frame", '[' + short_number(frame.t, 12) + ',' + list(frame.bodies, body_text) +
                                 ',' + list(frame.walls, wall_text) + ',' +
                                 list(frame.contacts, contact_text) + ']');
}

}  // namespace stokesbook
