// Answers questions about the walls and bodies of a scene. In Couette cells, the torque on the
// inner wall measures an effective viscosity (chapter 12).
#include "scene/scene.hpp"

#include <algorithm>

namespace stokesbook {

namespace {

// Returns the angular velocity of a fixed or rotating wall, and no value for other walls.
std::optional<double> rotation(const Wall& wall) {
  if (std::holds_alternative<FixedWall>(wall.motion)) return 0.0;
  const auto* rotating = std::get_if<RotatingWall>(&wall.motion);
  return rotating ? std::optional(rotating->omega) : std::nullopt;
}

}  // namespace

bool is_enclosed(const Scene& scene) {
  return std::ranges::count(scene.walls, WallRole::outer, &Wall::role) > 0;
}

const Wall* only_wall(const Scene& scene, WallRole role) {
  if (std::ranges::count(scene.walls, role, &Wall::role) != 1) return nullptr;
  return &*std::ranges::find(scene.walls, role, &Wall::role);
}

bool has_velocity_data(const Scene& scene) {
  const auto is_data = [](const auto& velocity) {
    return std::holds_alternative<VelocityData>(velocity);
  };
  const auto slips_by_data = [&](const Body& body) { return body.slip && is_data(*body.slip); };
  return std::ranges::any_of(scene.walls, is_data, &Wall::motion) ||
         std::ranges::any_of(scene.bodies, slips_by_data);
}

bool is_couette_cell(const Scene& scene) {
  const Wall* outer = only_wall(scene, WallRole::outer);
  const Wall* inner = only_wall(scene, WallRole::inner);
  if (outer == nullptr || inner == nullptr) return false;
  const std::optional<double> outer_rate = rotation(*outer), inner_rate = rotation(*inner);
  const bool keep_ratio =
      outer_rate == 0.0 || inner_rate == 0.0 || outer->amplitude == inner->amplitude;
  return outer_rate && inner_rate && *outer_rate != *inner_rate && keep_ratio;
}

}  // namespace stokesbook
