// Places outlines in the laboratory frame, and checks that outlines and frames match.
#include "record/outline.hpp"

#include <stdexcept>
#include <string>

namespace stokesbook {

namespace {

void require_party(const ContactParty& party, const Frame& frame) {
  if (party.number < (party.is_wall ? frame.walls.size() : frame.bodies.size())) return;
  throw std::invalid_argument("contact of " + std::string(party.is_wall ? "wall " : "body ") +
                              std::to_string(party.number) + ", which is not in the frame");
}

}  // namespace

ComplexVector placed(const Outline& outline, Complex position, double orientation) {
  return (outline.points.array() * std::polar(1.0, orientation) + position).matrix();
}

void require_outlines(const Frame& frame, const std::vector<Outline>& bodies,
                      const std::vector<Outline>& walls) {
  if (frame.bodies.size() != bodies.size() || frame.walls.size() != walls.size()) {
    throw std::invalid_argument("frame of " + std::to_string(frame.bodies.size()) + " bodies and " +
                                std::to_string(frame.walls.size()) + " walls, but outlines of " +
                                std::to_string(bodies.size()) + " and " +
                                std::to_string(walls.size()));
  }
  for (const ContactForce& contact : frame.contacts) {
    require_party(contact.a, frame);
    require_party(contact.b, frame);
  }
}

}  // namespace stokesbook
