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
  const FrameCell& cell = frame.cell.value();
  for (Complex& tracer : frame.tracers) tracer = cell.lattice.wrap(tracer, cell.centre);
  // A contact moves with a, and the image of b keeps its place beside a.
  for (ContactForce& contact : frame.contacts) {
    const std::size_t a = contact.a.number, b = contact.b.number;
    const Complex moved = cell.bodies[a].position - frame.bodies[a].position;
    contact.point += moved;
    contact.shift += moved - (cell.bodies[b].position - frame.bodies[b].position);
  }
  frame.bodies = cell.bodies;
  return frame;
}

std::array<Complex, 2> contact_ends(const Frame& frame, const ContactForce& contact) {
  const auto end = [&](const ContactParty& party, Complex shift) {
    return party.is_wall ? contact.point : frame.bodies[party.number].position + shift;
  };
  return {end(contact.a, 0.0), end(contact.b, contact.shift)};
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
