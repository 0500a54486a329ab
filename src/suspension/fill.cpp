#include "suspension/fill.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "suspension/component_data.hpp"
#include "suspension/gaps.hpp"
#include "suspension/node_choice.hpp"

namespace stokesbook {

namespace {

constexpr int attempts_per_body = 20000;

// A component as an obstacle, with its bounding circle.
struct Obstacle {
  SmoothCurve curve;
  double radius;
};

Obstacle make_obstacle(const Curve& reference, std::shared_ptr<const TrigonometricPolynomial> shape,
                       const Placement& placement) {
  return {{place(reference, placement.position, placement.orientation), std::move(shape),
           placement.position, placement.orientation},
          bounding_radius(reference, 0.0)};
}

template <class BodyOrWall>
Obstacle make_obstacle(const BodyOrWall& component, double tolerance, const std::string& name) {
  const Side side = side_of(kind_of(component));
  const Curve reference =
      sample(component.shape, own_nodes(component, side, tolerance, name), side);
  return make_obstacle(reference, std::make_shared<TrigonometricPolynomial>(reference.x),
                       {component.position, component.orientation});
}

bool keeps_clearance(const Obstacle& body, const std::vector<Obstacle>& obstacles,
                     double clearance) {
  for (const Obstacle& obstacle : obstacles) {
    const double distance = std::abs(body.curve.position - obstacle.curve.position);
    const bool encloses = obstacle.curve.nodes.side == Side::fluid_inside;
    if (!encloses && distance > body.radius + obstacle.radius + clearance) continue;
    if (closest_points(body.curve, obstacle.curve).gap < std::max(clearance, 1e-300)) return false;
  }
  return true;
}

// The standard's distributions differ between libraries; this one does not.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

struct Region {
  std::array<double, 4> box;  // xmin, ymin, xmax, ymax
  double area;
};

Region fluid_region(const std::vector<Obstacle>& obstacles) {
  Region region{{}, 0.0};
  for (const Obstacle& obstacle : obstacles) {
    const Curve& curve = obstacle.curve.nodes;
    region.area += curve.sign() * area(curve);
    if (curve.side != Side::fluid_inside) continue;
    region.box = {curve.x.real().minCoeff(), curve.x.imag().minCoeff(), curve.x.real().maxCoeff(),
                  curve.x.imag().maxCoeff()};
  }
  return region;
}

bool in_box(const Curve& curve, const std::array<double, 4>& box) {
  return curve.x.real().minCoeff() >= box[0] && curve.x.imag().minCoeff() >= box[1] &&
         curve.x.real().maxCoeff() <= box[2] && curve.x.imag().maxCoeff() <= box[3];
}

}  // namespace

Scene with_fills_placed(const Scene& scene) {
  Scene filled = scene;
  filled.fills.clear();
  if (scene.fills.empty()) return filled;
  const double tolerance = scene.solver.tolerance;
  std::vector<Obstacle> obstacles;
  const auto add_all = [&](const auto& components, std::size_t first) {
    for (std::size_t k = 0; k < components.size(); ++k) {
      const std::string name = component_name(scene, first + k);
      obstacles.push_back(make_obstacle(components[k], tolerance, name));
    }
  };
  add_all(scene.walls, scene.bodies.size());
  const Region fluid = fluid_region(obstacles);
  add_all(scene.bodies, 0);

  std::mt19937_64 random(scene.seed);
  for (const Fill& fill : scene.fills) {
    const Side side = Side::fluid_outside;
    const Curve reference = sample(fill.shape, own_nodes(fill, side, tolerance, "[[fill]]"), side);
    const auto shape = std::make_shared<TrigonometricPolynomial>(reference.x);
    const std::array<double, 4> box = fill.box.value_or(fluid.box);
    const double region_area = fill.box ? (box[2] - box[0]) * (box[3] - box[1]) : fluid.area;
    const long count =
        fill.count ? *fill.count : std::lround(*fill.area_fraction * region_area / area(reference));
    int attempts = 0;
    for (long placed = 0; placed < count;) {
      if (++attempts > attempts_per_body) {
        throw std::invalid_argument(
            "[[fill]]: found room for " + std::to_string(placed) + " of " + std::to_string(count) +
            " bodies; lower area_fraction, count or clearance, or take another seed");
      }
      const Complex position{uniform(random, box[0], box[2]), uniform(random, box[1], box[3])};
      const double orientation = uniform(random, 0.0, 2.0 * std::numbers::pi);
      Obstacle body = make_obstacle(reference, shape, {position, orientation});
      if (fill.box && !in_box(body.curve.nodes, box)) continue;
      if (!keeps_clearance(body, obstacles, fill.clearance)) continue;
      obstacles.push_back(std::move(body));
      filled.bodies.push_back(
          {fill.shape, position, orientation, {}, 0.0, false, {}, 0.0, fill.n_nodes});
      ++placed;
      attempts = 0;
    }
  }
  return filled;
}

}  // namespace stokesbook
