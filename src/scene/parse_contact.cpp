// Reads the section [contact] of a scene file, and checks that bodies and time steps allow contact.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

const std::string separation = "a number > 0: a length, or node spacings as in \"0.05h\"";

// Returns the number of node spacings in a text such as "0.05h"; not a number for other texts.
double spacings_in(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && std::string_view(rest, end) == "h" ? number : std::nan("");
}

ContactSettings read_separation(const Node& node) {
  ContactSettings contact;
  const auto* text = std::get_if<std::string>(&node.value);
  contact.in_spacings = text != nullptr;
  contact.minimum_separation = text ? spacings_in(*text) : value_as<double>(node, separation);
  if (!std::isfinite(contact.minimum_separation) || contact.minimum_separation <= 0.0) {
    fail(node, "must be " + separation);
  }
  return contact;
}

bool has_automatic_nodes(const auto& bodies) {
  return std::ranges::any_of(bodies,
                             [](const auto& body) { return body.n_nodes == automatic_nodes; });
}

bool resolves_contact(SteppingMethod method) {
  return method == SteppingMethod::euler || method == SteppingMethod::heun;
}

}  // namespace

std::optional<ContactSettings> read_contact(const TableReader& root, const SceneFile& file) {
  const auto& [scene, fills] = file;
  const Node* node = root.find("contact");
  if (node == nullptr) return std::nullopt;
  const TableReader table(*node, {"minimum_separation", "allow_close"});
  const Node& given = table.at("minimum_separation", separation);
  ContactSettings contact = read_separation(given);
  contact.allow_close = table.get("allow_close", any_flag).value_or(contact.allow_close);
  if (scene.bodies.empty() && fills.empty()) {
    fail_at_key(*node, "there are no bodies; add [[bodies]] or remove [contact]");
  }
  if (contact.in_spacings && (has_automatic_nodes(scene.bodies) || has_automatic_nodes(fills))) {
    fail(given,
         "requires numbers for all n_nodes, since h is the node spacing; a body has \"auto\"");
  }
  if (scene.time && !resolves_contact(scene.time->method)) {
    fail(*TableReader(*root.find("time")).find("method"),
         "contact is resolved with \"euler\" and \"heun\"");
  }
  return contact;
}

}  // namespace stokesbook::scene_text
