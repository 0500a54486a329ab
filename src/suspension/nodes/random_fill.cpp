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

// A placed component, and the radius of its bounding circle about its position.
struct Obstacle {
  SmoothCurve curve;
  double radius;
};

Obstacle make_obstacle(const DiscretisedShape& discretised, const Pose& pose) {
  return {smooth_curve(discretised, pose), outer_radius(discretised.curve, 0.0)};
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

bool contains(const Rectangle& box, const Curve& curve) {
  const auto [lower, upper] = bounding_rectangle(curve.x);
  return lower.real() >= box.lower.real() && lower.imag() >= box.lower.imag() &&
         upper.real() <= box.upper.real() && upper.imag() <= box.upper.imag();
}

// A part of the plane in which bodies are placed.
struct Region {
  Rectangle box{};
  double area = 0.0;
};

Region region_of(const Fill& fill, const Region& fluid) {
  if (!fill.box) return fluid;
  const auto [left, bottom, right, top] = *fill.box;
  return {{{left, bottom}, {right, top}}, (right - left) * (top - bottom)};
}

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
  constexpr double most_bodies = 1e7;  // no machine solves for more
  if (bodies > most_bodies) {
    throw std::invalid_argument("[[fill]]: area_fraction = " + short_number(*fill.area_fraction) +
                                " requires " + short_number(bodies) +
                                " bodies: reduce the region, or set count to at most " +
                                short_number(most_bodies));
  }
  return std::lround(bodies);
}

// Returns the bodies of a fill, and adds them to the obstacles.
std::vector<Body> place_bodies(const Fill& fill, const DiscretisedShape& discretised,
                               const Region& region, std::mt19937_64& random,
                               Obstacles& obstacles) {
  constexpr int most_attempts = 20000;  // for each body
  const auto& [lower, upper] = region.box;
  const long count = count_of(fill, region.area, area(discretised.curve));
  std::vector<Body> bodies;
  int attempts = 0;
  while (static_cast<long>(bodies.size()) < count) {
    if (++attempts > most_attempts) {
      throw std::invalid_argument("[[fill]]: found room for " + std::to_string(bodies.size()) +
                                  " of " + std::to_string(count) +
                                  " bodies; lower area_fraction, count or clearance, or change "
                                  "the seed");
    }
    const Complex position{uniform(random, lower.real(), upper.real()),
                           uniform(random, lower.imag(), upper.imag())};
    const double orientation = uniform(random, 0.0, 2.0 * std::numbers::pi);
    const Obstacle body = make_obstacle(discretised, {position, orientation});
    if (fill.box && !contains(region.box, body.curve.nodes)) continue;
    if (!obstacles.leave_room_for(body, fill.clearance)) continue;
    obstacles.add(body);
    bodies.push_back({fill.shape, position, orientation, {}, 0.0, false, {}, 0.0, fill.n_nodes});
    attempts = 0;
  }
  return bodies;
}

}  // namespace

Scene place_fills(const SceneFile& file) {
  Scene filled = file.scene;
  if (file.fills.empty()) return filled;
  DiscretisationCache cache({}, 16);
  const auto discretise = [&](const Shape& shape, int n_nodes, ComponentKind kind,
                              const std::string& name) {
    const int nodes = own_nodes(shape, n_nodes, side_of(kind), filled.solver.tolerance, name);
    return cache.get(shape, {nodes}, kind);
  };
  Obstacles obstacles;
  Region fluid;  // inside the enclosing wall, without the areas of inner walls
  for (std::size_t k = 0; k < count_components(file.scene).all(); ++k) {
    const ComponentView component = component_of(file.scene, k);
    const auto discretised =
        discretise(component.shape, component.n_nodes, component.kind, component.name());
    const Obstacle obstacle = make_obstacle(*discretised, component.start);
    obstacles.add(obstacle);
    if (component.wall == nullptr) continue;
    const Curve& wall = obstacle.curve.nodes;
    fluid.area += wall.sign() * area(wall);
    if (wall.side == Side::fluid_inside) fluid.box = bounding_rectangle(wall.x);
  }
  std::mt19937_64 random(filled.seed);
  for (const Fill& fill : file.fills) {
    const auto discretised =
        discretise(fill.shape, fill.n_nodes, ComponentKind::free_body, "[[fill]]");
    const auto bodies = place_bodies(fill, *discretised, region_of(fill, fluid), random, obstacles);
    filled.bodies.insert(filled.bodies.end(), bodies.begin(), bodies.end());
  }
  return filled;
}

}  // namespace stokesbook
