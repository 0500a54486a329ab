// Recognises Couette cells, in which the torque on the inner wall measures an effective viscosity
// (chapter 12).
#include "scene/couette_cell.hpp"

#include <algorithm>
#include <optional>

namespace stokesbook {

namespace {

// Returns the angular velocity of a fixed or rotating wall, and no value for other walls.
std::optional<double> rotation(const Wall& wall) {
  if (std::holds_alternative<FixedWall>(wall.motion)) return 0.0;
  const auto* rotating = std::get_if<RotatingWall>(&wall.motion);
  return rotating ? std::optional(rotating->omega) : std::nullopt;
}

}  // namespace

const Wall* only_wall(const Scene& scene, WallRole role) {
  const auto is_one = [&](const Wall& wall) { return wall.role == role; };
  if (std::ranges::count_if(scene.walls, is_one) != 1) return nullptr;
  return &*std::ranges::find_if(scene.walls, is_one);
}

bool is_couette_cell(const Scene& scene) {
  const Wall* outer = only_wall(scene, WallRole::outer);
  const Wall* inner = only_wall(scene, WallRole::inner);
  if (outer == nullptr || inner == nullptr) return false;
  const std::optional<double> outer_rate = rotation(*outer), inner_rate = rotation(*inner);
  return outer_rate && inner_rate && *outer_rate != *inner_rate;
}

}  // namespace stokesbook
