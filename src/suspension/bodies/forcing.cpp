// Computes what drives the flow at a time: the factors of the background flow and of the prescribed
// motions, and the loads on free bodies (chapter 12).
#include "suspension/bodies/forcing.hpp"

#include <algorithm>
#include <utility>

#include "suspension/bodies/components.hpp"

namespace stokesbook {

namespace {

// Returns 1, or -1 after an odd number of reversals.
double reversal_sign(const Scene& scene, double t) {
  const auto passed = std::ranges::upper_bound(scene.reverse_at, t) - scene.reverse_at.begin();
  return passed % 2 == 0 ? 1.0 : -1.0;
}

}  // namespace

Forcing scaled(double factor, Forcing forcing) {
  forcing.flow *= factor;
  for (double& motion : forcing.motions) motion *= factor;
  for (auto& [force, torque] : forcing.loads) {
    force *= factor;
    torque *= factor;
  }
  return forcing;
}

Forcing forcing_at(const Scene& scene, const StepTime& time) {
  Forcing forcing;
  forcing.motions.assign(count_components(scene).all(), 1.0);
  for (const Body& body : scene.bodies) forcing.loads.push_back({body.force, body.torque});
  return scaled(reversal_sign(scene, time.begin), std::move(forcing));
}

std::vector<double> forcing_events(const Scene& scene) {
  return scene.reverse_at;
}

}  // namespace stokesbook
