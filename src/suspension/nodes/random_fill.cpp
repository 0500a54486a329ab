// Places the bodies of [[fill]] by random sequential addition: draws poses at random, and takes a
// pose if the body keeps its clearance from all components placed before (chapter 12).
#include "suspension/nodes/random_fill.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "suspension/bodies/components.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "text/number_text.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

namespace {

constexpr int attempts_per_body = 20000;

// A placed component, and the radius of its bounding circle about its position.
struct Obstacle {
  SmoothCurve curve;
  double radius;
};

Obstacle make_obstacle(const Curve& reference, std::shared_ptr<const Parametrisation> shape,
                       const Pose& pose) {
  return {{place(reference, pose.position, pose.orientation), std::move(shape), pose.position,
           pose.orientation},
          outer_radius(reference, 0.0)};
}

Obstacle make_obstacle(const ComponentView& component, double tolerance) {
  const Side side = side_of(component.kind);
  const int nodes = own_nodes(component, side, tolerance, component.name());
  return make_obstacle(sample(component.shape, nodes, side),
                       std::make_shared<const Parametrisation>(parametrisation(component.shape)),
                       component.start);
}

// Returns the distance of the nearest nodes: an upper bound of the gap, which is much cheaper to
// compute than the gap.
double node_distance(const Curve& a, const Curve& b) {
  double least2 = std::numeric_limits<double>::infinity();
  for (const Complex& node : a.x) {
    least2 = std::min(least2, (b.x.array() - node).abs2().minCoeff());
  }
  return std::sqrt(least2);
}

// The components that have been placed so far.
class Obstacles {
 public:
  void add(Obstacle obstacle) {
    if (obstacle.curve.nodes.side == Side::fluid_inside) {
      enclosing_.push_back(std::move(obstacle));
    } else {
      circles_.insert(square_about(obstacle.curve.position, obstacle.radius));
      others_.push_back(std::move(obstacle));
    }
  }

  // Returns whether a body keeps its clearance from all obstacles.
  bool leave_room_for(const Obstacle& body, double clearance) const {
    const auto is_clear_of = [&](const Obstacle& obstacle) {
      return node_distance(body.curve.nodes, obstacle.curve.nodes) >= clearance &&
             closest_points(body.curve, obstacle.curve).gap >= std::max(clearance, 1e-300);
    };
    for (const std::size_t k :
         circles_.meeting(square_about(body.curve.position, body.radius + clearance))) {
      const Obstacle& other = others_[k];
      const double distance = std::abs(body.curve.position - other.curve.position);
      if (distance > body.radius + other.radius + clearance) continue;
      if (!is_clear_of(other)) return false;
    }
    // The bounding circle of an enclosing wall gives no bound of its gap to a body inside, so that
    // all of these walls are tested.
    return std::ranges::all_of(enclosing_, is_clear_of);
  }

 private:
  std::vector<Obstacle> enclosing_, others_;
  RectangleIndex circles_;  // squares about the bounding circles of others_
};

// Returns a random number between two bounds, from 53 random bits. The distributions of the
// standard library would depend on its implementation.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

struct Region {
  std::array<double, 4> box;  // xmin, ymin, xmax, ymax
  double area;
};

// Returns the bounding box of the enclosing wall, and its area without the areas of inner walls.
Region fluid_region(const std::vector<Obstacle>& walls) {
  Region region{{}, 0.0};
  for (const Obstacle& wall : walls) {
    const Curve& curve = wall.curve.nodes;
    region.area += curve.sign() * area(curve);
    if (curve.side != Side::fluid_inside) continue;
    region.box = {curve.x.real().minCoeff(), curve.x.imag().minCoeff(), curve.x.real().maxCoeff(),
                  curve.x.imag().maxCoeff()};
  }
  return region;
}

// Largest number of bodies of a fill: no machine solves for more.
constexpr double most_bodies = 1e7;

// Returns the given number of bodies, or the number whose area is nearest to the given fraction of
// the region's area.
long count_of(const Fill& fill, double region_area, double body_area) {
  if (fill.count) return *fill.count;
  const double bodies = *fill.area_fraction * region_area / body_area;
  if (bodies < 0.5) {
    throw std::invalid_argument("[[fill]]: area_fraction = " + short_number(*fill.area_fraction) +
                                " is less than half a body; one body takes " +
                                short_number(body_area / region_area) +
                                " of the region's area: set area_fraction to at least " +
                                short_number(0.5 * body_area / region_area) + ", or set count");
  }
  if (bodies > most_bodies) {
    throw std::invalid_argument("[[fill]]: area_fraction = " + short_number(*fill.area_fraction) +
                                " requires " + short_number(bodies) +
                                " bodies: reduce the region, or set count to at most " +
                                short_number(most_bodies));
  }
  return std::lround(bodies);
}

bool in_box(const Curve& curve, const std::array<double, 4>& box) {
  return curve.x.real().minCoeff() >= box[0] && curve.x.imag().minCoeff() >= box[1] &&
         curve.x.real().maxCoeff() <= box[2] && curve.x.imag().maxCoeff() <= box[3];
}

}  // namespace

Scene place_fills(const SceneFile& file) {
  const auto& [scene, fills] = file;
  Scene filled = scene;
  if (fills.empty()) return filled;
  const double tolerance = scene.solver.tolerance;
  const auto obstacle = [&scene = scene](std::size_t k) {
    return make_obstacle(component_of(scene, k), scene.solver.tolerance);
  };
  std::vector<Obstacle> walls;
  for (std::size_t k = scene.bodies.size(); k < count_components(scene); ++k) {
    walls.push_back(obstacle(k));
  }
  const Region fluid = fluid_region(walls);
  Obstacles obstacles;
  for (Obstacle& wall : walls) obstacles.add(std::move(wall));
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) obstacles.add(obstacle(k));

  std::mt19937_64 random(scene.seed);
  for (const Fill& fill : fills) {
    const Side side = Side::fluid_outside;
    const Curve reference = sample(fill.shape, own_nodes(fill, side, tolerance, "[[fill]]"), side);
    const auto shape = std::make_shared<const Parametrisation>(parametrisation(fill.shape));
    const std::array<double, 4> box = fill.box.value_or(fluid.box);
    const double region_area = fill.box ? (box[2] - box[0]) * (box[3] - box[1]) : fluid.area;
    const long count = count_of(fill, region_area, area(reference));
    int attempts = 0;
    for (long placed = 0; placed < count;) {
      if (++attempts > attempts_per_body) {
        throw std::invalid_argument(
            "[[fill]]: found room for " + std::to_string(placed) + " of " + std::to_string(count) +
            " bodies; lower area_fraction, count or clearance, or change the seed");
      }
      const Complex position{uniform(random, box[0], box[2]), uniform(random, box[1], box[3])};
      const double orientation = uniform(random, 0.0, 2.0 * std::numbers::pi);
      Obstacle body = make_obstacle(reference, shape, {position, orientation});
      if (fill.box && !in_box(body.curve.nodes, box)) continue;
      if (!obstacles.leave_room_for(body, fill.clearance)) continue;
      obstacles.add(std::move(body));
      filled.bodies.push_back(
          {fill.shape, position, orientation, {}, 0.0, false, {}, 0.0, fill.n_nodes});
      ++placed;
      attempts = 0;
    }
  }
  return filled;
}

}  // namespace stokesbook
