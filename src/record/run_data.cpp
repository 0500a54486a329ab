// Checks that outlines and frames match.
#include "record/run_data.hpp"

#include <stdexcept>
#include <string>

namespace stokesbook {

namespace {

std::string numbers_of(const auto& components) {
  return std::to_string(components.bodies.size()) + " bodies and " +
         std::to_string(components.walls.size()) + " walls";
}

}  // namespace

void require_outlines(const Frame& frame, const Outlines& outlines) {
  if (frame.bodies.size() != outlines.bodies.size() ||
      frame.walls.size() != outlines.walls.size()) {
    throw std::invalid_argument("frame of " + numbers_of(frame) + ", but outlines of " +
                                numbers_of(outlines));
  }
  for (const ContactForce& contact : frame.contacts) {
    for (const ContactParty& party : {contact.a, contact.b}) {
      if (party.number < (party.is_wall ? frame.walls.size() : frame.bodies.size())) continue;
      throw std::invalid_argument("contact of " + std::string(party.is_wall ? "wall " : "body ") +
                                  std::to_string(party.number) + ", which is not in the frame");
    }
  }
}

}  // namespace stokesbook
