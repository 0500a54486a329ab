// Spreads points over the part of the plane in which bodies are counted. The divisor of the
// barycentric formula shows on which side of a wall a point lies (06.15).
#include "statistics/region.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "near_singular/barycentric.hpp"
#include "suspension/bodies/components.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

namespace {

std::vector<Curve> placed_walls(const Scene& scene) {
  if (!is_enclosed(scene) || !walls_stay(scene)) {
    throw SceneError(
        "bodies are counted in a region: give --box xmin,ymin,xmax,ymax, since the scene has no "
        "outer wall, or a wall that leaves its place");
  }
  std::vector<Curve> walls;
  for (std::size_t k = scene.bodies.size(); k < count_components(scene).all(); ++k) {
    const ComponentView wall = component_of(scene, k);
    walls.push_back(place(sample(wall.shape, nodes_of_walls, side_of(wall.kind)),
                          wall.start.position, wall.start.orientation));
  }
  return walls;
}

}  // namespace

bool walls_stay(const Scene& scene) {
  return std::ranges::none_of(scene.walls, [](const Wall& wall) {
    const auto* rotating = std::get_if<RotatingWall>(&wall.motion);
    return std::holds_alternative<TranslatingWall>(wall.motion) ||
           (rotating != nullptr && !std::holds_alternative<Circle>(wall.shape));
  });
}

bool Region::is_in_box(Complex point) const {
  const auto [left, bottom, right, top] = box;
  return point.real() >= left && point.real() <= right && point.imag() >= bottom &&
         point.imag() <= top;
}

Region region_of(const Scene& scene, const RegionBox& box, double clearance, Eigen::Index n) {
  const std::vector<Curve> walls = box ? std::vector<Curve>{} : placed_walls(scene);
  const std::vector<Barycentric> sides(walls.begin(), walls.end());
  Region region{box.value_or(std::array<double, 4>{}), ComplexVector(n), 0.0};
  for (const auto& [x, dx, ddx, side] : walls) {
    if (side == Side::fluid_outside) continue;
    region.box = {x.real().minCoeff(), x.imag().minCoeff(), x.real().maxCoeff(),
                  x.imag().maxCoeff()};
  }
  const auto contains = [&](Complex point) {
    for (std::size_t k = 0; k < walls.size(); ++k) {
      if (!(sides[k].side(point) > 0.5)) return false;
      if ((walls[k].x.array() - point).abs().minCoeff() < clearance) return false;
    }
    return true;
  };
  // x_k = k g^{-1} mod 1, y_k = k g^{-2} mod 1 with g^3 = g + 1.
  constexpr double g = 1.3247179572447460;
  const auto [left, bottom, right, top] = region.box;
  const auto part = [](double x) { return x - std::floor(x); };
  double tried = 0.0;
  for (Eigen::Index i = 0; i < n;) {
    ++tried;
    const Complex point{std::lerp(left, right, part(tried / g)),
                        std::lerp(bottom, top, part(tried / (g * g)))};
    if (contains(point)) region.points[i++] = point;
  }
  region.area = (right - left) * (top - bottom) * static_cast<double>(n) / tried;
  return region;
}

}  // namespace stokesbook
