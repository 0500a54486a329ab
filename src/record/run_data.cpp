// Checks that outlines and frames match, and replaces bodies by their images in a periodic cell.
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

Frame in_cell(Frame frame) {
  const auto& [lattice, centre, bodies] = frame.cell.value();
  frame.bodies = bodies;
  for (Complex& tracer : frame.tracers) tracer = lattice.wrap(tracer, centre);
  for (ContactForce& contact : frame.contacts) {
    contact.point = lattice.wrap(contact.point, bodies[contact.a.number].position);
  }
  return frame;
}

Complex place_in_contact(const Frame& frame, const ContactParty& body, Complex contact) {
  const Complex position = frame.bodies[body.number].position;
  return frame.cell ? frame.cell->lattice.wrap(position, contact) : position;
}

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
