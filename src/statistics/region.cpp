// Spreads points over the part of the plane in which bodies are counted. The divisor of the
// barycentric formula shows on which side of a wall a point lies (06.15).
#include "statistics/region.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "near_singular/barycentric.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

namespace {

bool leaves_its_place(const Wall& wall) {
  const auto* rotating = std::get_if<RotatingWall>(&wall.motion);
  return std::holds_alternative<TranslatingWall>(wall.motion) ||
         (rotating != nullptr && !std::holds_alternative<Circle>(wall.shape));
}

std::vector<Curve> placed_walls(const Scene& scene) {
  if (!is_enclosed(scene) || std::ranges::any_of(scene.walls, leaves_its_place)) {
    throw SceneError(
        "bodies are counted in a region: give --box xmin,ymin,xmax,ymax, since the scene has no "
        "outer wall, or a wall that leaves its place");
  }
  constexpr Eigen::Index nodes = 512;
  std::vector<Curve> walls;
  for (const Wall& wall : scene.walls) {
    const Side side = wall.role == WallRole::outer ? Side::fluid_inside : Side::fluid_outside;
    walls.push_back(place(sample(wall.shape, nodes, side), wall.position, wall.orientation));
  }
  return walls;
}

}  // namespace

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
