#include "stiv/absolute_volume.hpp"

#include <cmath>

namespace stokesbook {

namespace {

// A component's part in the volume, and the force on it.
struct Part {
  double volume = 0.0;
  Wrench force{};
};

Part part_of(const std::vector<VertexEvent>& events, const ContactShape& shape,
             const RigidPath& path, double tolerance) {
  Part part;
  for (const VertexEvent& event : events) {
    if (event.gap >= -tolerance) continue;
    const Complex turn = std::polar(1.0, path.at(event.time).orientation);
    const Complex x = shape.polygon.vertex(event.vertex), arm = turn * x;
    const Complex normal = turn * shape.polygon.closest(x, shape.radius).normal;
    const double speed = dot(path.displacement + path.rotation * perp(arm), normal);
    const double area = event.weight * (1.0 - event.time);
    part.volume -= area * std::abs(speed);
    if (speed == 0.0) continue;
    const Complex push = -std::copysign(area, speed) * normal;
    part.force.force += push;
    part.force.torque += cross(arm, push);
  }
  return part;
}

}  // namespace

AbsoluteVolume absolute_volume(const PairEvents& pair, double tolerance) {
  const Part a = part_of(pair.events_a, pair.shape_a, pair.paths.path_a, tolerance),
             b = part_of(pair.events_b, pair.shape_b, pair.paths.path_b, tolerance);
  return {a.volume + b.volume, {a.force, b.force}};
}

}  // namespace stokesbook
