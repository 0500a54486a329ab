#include "record/outline.hpp"

#include <stdexcept>
#include <string>

namespace stokesbook {

ComplexVector placed(const Outline& outline, Complex position, double orientation) {
  return (outline.points.array() * std::polar(1.0, orientation) + position).matrix();
}

void require_outlines(const Frame& frame, const std::vector<Outline>& bodies,
                      const std::vector<Outline>& walls) {
  if (frame.bodies.size() == bodies.size() && frame.walls.size() == walls.size()) return;
  throw std::invalid_argument("frame of " + std::to_string(frame.bodies.size()) + " bodies and " +
                              std::to_string(frame.walls.size()) + " walls, but outlines of " +
                              std::to_string(bodies.size()) + " and " +
                              std::to_string(walls.size()));
}

}  // namespace stokesbook
