#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "double_layer/double_layer.hpp"
#include "record/run_data.hpp"
#include "scene/scene.hpp"

namespace stokesbook::test {

/// Net force and torque of what contact adds to the loads of free bodies, and of the reactions that
/// the list of contacts gives walls and held bodies, over the largest force of contact and the
/// largest distance; 0 without contact.
///
/// @param  left_out  a body that is not counted, a planted defect
inline double contact_imbalance(const Scene& scene, const Frame& frame,
                                std::optional<std::size_t> left_out = {}) {
  if (frame.contacts.empty()) return 0.0;
  Complex net{};
  double torque = 0.0, largest = 0.0, farthest = 0.0;
  const auto count = [&](Complex point, Complex force) {
    net += force;
    torque += cross(point, force);
  };
  const auto is_support = [&](const ContactParty& party) {
    return party.is_wall || scene.bodies[party.number].held;
  };
  for (const ContactForce& contact : frame.contacts) {
    largest = std::max(largest, contact.force);
    farthest = std::max(farthest, std::abs(contact.point));
    const Complex force = contact.force * contact.normal;
    if (is_support(contact.a)) count(contact.point, force);
    if (is_support(contact.b)) count(contact.point, -force);
  }
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (k == left_out || scene.bodies[k].held) continue;
    const BodyState& body = frame.bodies[k];
    farthest = std::max(farthest, std::abs(body.position));
    count(body.position, body.force - scene.bodies[k].force);
    torque += body.torque - scene.bodies[k].torque;
  }
  return std::max(std::abs(net) / largest, std::abs(torque) / (largest * farthest));
}

}  // namespace stokesbook::test
