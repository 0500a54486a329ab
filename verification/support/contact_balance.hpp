#pragma once

#include <algorithm>
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "record/run_data.hpp"
#include "scene/scene.hpp"

namespace stokesbook::test {

/// Returns the relative size of the net contact force and torque in a frame; 0 if there is no
/// contact. The function adds the loads of contact on free bodies and the reactions of walls and
/// held bodies in the list of contacts. The net force is divided by the largest contact force. The
/// net torque is divided by this force times the largest distance from the origin. The larger
/// quotient is returned.
inline double contact_imbalance(const Scene& scene, const Frame& frame) {
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
    if (scene.bodies[k].held) continue;
    const BodyState& body = frame.bodies[k];
    farthest = std::max(farthest, std::abs(body.position));
    count(body.position, body.force - scene.bodies[k].force);
    torque += body.torque - scene.bodies[k].torque;
  }
  return std::max(std::abs(net) / largest, std::abs(torque) / (largest * farthest));
}

}  // namespace stokesbook::test
