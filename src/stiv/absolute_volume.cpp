// Computes the interference volume and forces from absolute velocities (10.11), an earlier form of
// the method that chapter 10 compares with.
#include "stiv/absolute_volume.hpp"

#include <cmath>

namespace stokesbook {

namespace {

// Holds the contribution of a component to the volume, and the force on the component.
struct Part {
  double volume = 0.0;
  Wrench force{};
};

// Sums (10.11) over the vertices of a component that end too deep.
Part part_of(const std::vector<VertexEvent>& events, const ContactShape& shape,
             const RigidPath& path, double tolerance) {
  Part part;
  for (const VertexEvent& event : events) {
    if (event.gap >= -tolerance) continue;
    const Complex turn = std::polar(1.0, path.at(event.time).orientation);
    const Complex x = shape.polygon.vertex(event.vertex), arm = turn * x;
    const Complex normal = turn * shape.polygon.closest(x, shape.radius).normal;
    // u_s . n_s and w_s (1 - tau_I) of (10.11)
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
