#pragma once

#include <array>
#include <optional>

#include "scene/scene.hpp"

namespace stokesbook {

/// The number of nodes with which statistics sample each wall.
inline constexpr int nodes_of_walls = 512;

/// Returns whether all walls stay in their places. The tables of a run do not contain the places of
/// walls that leave them.
bool walls_stay(const Scene& scene);

/// The part of the plane in which bodies are counted, as points that are spread uniformly over it.
struct Region {
  std::array<double, 4> box;  ///< xmin, ymin, xmax, ymax of a box about the region, length
  ComplexVector points;       ///< length
  double area;                ///< length^2

  /// Returns whether a point lies in the box.
  bool is_in_box(Complex point) const;
};

/// The box in which bodies are counted; none: between the walls.
using RegionBox = std::optional<std::array<double, 4>>;

/// Spreads n points over a box or, without one, over all that lies between the walls of a scene and
/// at least a clearance away from them, bodies included. The points are those of the sequence R2.
///
/// @throws SceneError when there is no box, and no outer wall or a wall that leaves its place
/// @sa source: Roberts, The unreasonable effectiveness of quasirandom sequences (2018)
Region region_of(const Scene& scene, const RegionBox& box, double clearance, Eigen::Index n);

}  // namespace stokesbook
