// Places the bodies of [[fill]] by random sequential addition: draws poses at random, and takes a
// pose if the body keeps its clearance from all components placed before, and in a periodic cell
// from their images (chapter 12). If there is no room for all bodies, inserts them at half their
// size, and lets them grow.
#include "suspension/nodes/random_fill.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>

#include "near_singular/near_field.hpp"
#include "suspension/bodies/cell.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/nodes/fill_growth.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

namespace {

// A placed component, the radius of its bounding circle about its position, and the largest
// distance between neighbouring nodes.
struct Obstacle {
  SmoothCurve curve;
  double radius, spacing;

  Obstacle image(Complex vector) const { return {translated(curve, vector), radius, spacing}; }
};

Obstacle make_obstacle(const DiscretisedShape& discretised, const Pose& pose) {
  return {smooth_curve(discretised, pose), outer_radius(discretised.curve, 0.0),
          weights(discretised.curve).maxCoeff()};
}

// Returns whether one of eight nodes of a component lies beyond the curve of another, farther than
// the distance between nodes. Then the tangent at the nearest node separates fluid and body. Most
// poses in a dense fill fail this test, which is much cheaper than a measurement of the gap.
bool is_beyond(const Obstacle& obstacle, const Obstacle& other) {
  const Curve &a = obstacle.curve.nodes, &b = other.curve.nodes;
  for (Eigen::Index i = 0; i < a.size(); i += a.size() / 8) {
    const Eigen::Index nearest = nearest_node(b, a.x[i]);
    const Complex across = a.x[i] - b.x[nearest];
    if (b.sign() * cross(b.dx[nearest], across) < 0.0 && std::abs(across) > other.spacing) {
      return true;
    }
  }
  return false;
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

// The periodic cell in which bodies are placed.
struct FilledCell {
  Lattice lattice;
  Complex centre;
  double reach;  // of bodies beyond the cell: the largest radius and clearance of a fill
};

// The components that have been placed so far; in a periodic cell, also their images that bodies
// with positions in the cell may meet.
class Obstacles {
 public:
  Obstacles(const std::vector<Obstacle>& given, const std::optional<FilledCell>& cell)
      : cell_(cell) {
    for (const Obstacle& obstacle : given) add(obstacle);
  }

  void add(const Obstacle& obstacle) {
    if (obstacle.curve.nodes.side == Side::fluid_inside) {
      enclosing_.push_back(obstacle);
      return;
    }
    std::vector<Complex> shifts{0.0};
    if (cell_) {
      const double farthest = cell_->lattice.circumradius();
      shifts = cell_->lattice.vectors_into_disk(obstacle.curve.position, cell_->centre,
                                                farthest + cell_->reach + obstacle.radius);
    }
    for (const Complex w : shifts) {
      others_.push_back(obstacle.image(w));
      circles_.insert(square_about(others_.back().curve.position, obstacle.radius));
    }
  }

  // Returns a point, or in a cell the image in the cell of the point that has its coordinates in
  // the basis of the lattice.
  Complex point_at(Complex coordinates) const {
    if (!cell_) return coordinates;
    const auto& [lattice, centre, reach] = *cell_;
    return lattice.wrap(
        coordinates.real() * lattice.vector({1, 0}) + coordinates.imag() * lattice.vector({0, 1}),
        centre);
  }

  // Returns whether a body keeps its clearance from all obstacles, and from its own images.
  bool leave_room_for(const Obstacle& body, double clearance) const {
    std::vector<Obstacle> own_images;
    if (cell_) {
      for (const Complex w : cell_->lattice.half_disk(2.0 * body.radius + clearance)) {
        own_images.push_back(body.image(w));
      }
    }
    // The bounding circle of an enclosing wall gives no bound of its gap to a body inside, so that
    // all of these walls are tested.
    std::vector<const Obstacle*> near;
    for (const Obstacle& wall : enclosing_) near.push_back(&wall);
    for (const Obstacle& image : own_images) near.push_back(&image);
    for (const std::size_t k :
         circles_.meeting(square_about(body.curve.position, body.radius + clearance))) {
      const double distance = std::abs(body.curve.position - others_[k].curve.position);
      if (distance <= body.radius + others_[k].radius + clearance) near.push_back(&others_[k]);
    }
    const auto may_be_clear = [&](const Obstacle* other) {
      return !is_beyond(body, *other) && !is_beyond(*other, body);
    };
    const auto is_clear = [&](const Obstacle* other) {
      return node_distance(body.curve.nodes, other->curve.nodes) >= clearance &&
             closest_points(body.curve, other->curve).gap >= std::max(clearance, 1e-300);
    };
    return std::ranges::all_of(near, may_be_clear) && std::ranges::all_of(near, is_clear);
  }

 private:
  std::optional<FilledCell> cell_;
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

// A part of the plane in which bodies are placed; the box of a periodic cell is that of coordinates
// in the basis of the lattice.
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

// Returns `count` bodies of a fill, and adds them to the obstacles. Returns fewer bodies if no room
// was found for the next one.
std::vector<Body> insert_bodies(const Fill& fill, std::ptrdiff_t count,
                                const DiscretisedShape& discretised, const Rectangle& box,
                                std::mt19937_64& random, Obstacles& obstacles) {
  constexpr int most_attempts = 20000;  // for each body
  const auto& [lower, upper] = box;
  std::vector<Body> bodies;
  int attempts = 0;
  while (std::ssize(bodies) < count && ++attempts <= most_attempts) {
    const Complex position = obstacles.point_at(
        {uniform(random, lower.real(), upper.real()), uniform(random, lower.imag(), upper.imag())});
    const double orientation = uniform(random, 0.0, 2.0 * std::numbers::pi);
    const Obstacle body = make_obstacle(discretised, {position, orientation});
    if (fill.box && !contains(box, body.curve.nodes)) continue;
    if (!obstacles.leave_room_for(body, fill.clearance)) continue;
    obstacles.add(body);
    Body& placed = bodies.emplace_back(fill.body);
    placed.position = position;
    placed.orientation = orientation;
    attempts = 0;
  }
  return bodies;
}

}  // namespace

FilledScene fill_scene(const SceneFile& file) {
  FilledScene filled{file.scene, {}};
  if (file.fills.empty()) return filled;
  DiscretisationCache cache({}, 16);
  const auto discretise = [&](const Shape& shape, int n_nodes, ComponentKind kind,
                              const std::string& name) {
    const int nodes = own_nodes(shape, n_nodes, side_of(kind), file.scene.solver.tolerance, name);
    return cache.get(shape, {nodes}, kind);
  };
  std::vector<Obstacle> given;
  Region fluid;  // inside the enclosing wall, without the areas of inner walls; or the whole cell
  for (std::size_t k = 0; k < count_components(file.scene).all(); ++k) {
    const ComponentView component = component_of(file.scene, k);
    const auto discretised =
        discretise(component.shape, component.n_nodes, component.kind, component.name());
    given.push_back(make_obstacle(*discretised, component.start));
    if (component.wall == nullptr) continue;
    const Curve& wall = given.back().curve.nodes;
    fluid.area += wall.sign() * area(wall);
    if (wall.side == Side::fluid_inside) fluid.box = bounding_rectangle(wall.x);
  }
  std::optional<FilledCell> cell;
  if (const auto start = cell_at(file.scene, 0.0)) {
    cell = FilledCell{lattice_of(*start), cell_centre(file.scene), 0.0};
    fluid = {{0.0, {1.0, 1.0}}, cell->lattice.area()};
  }
  std::vector<const Fill*> fill_of;  // the fill of each body
  std::vector<double> fractions;     // the area fraction of each fill
  for (const Fill& fill : file.fills) {
    const auto discretised =
        discretise(fill.body.shape, fill.body.n_nodes, ComponentKind::free_body, "[[fill]]");
    if (cell) {
      cell->reach = std::max(cell->reach, outer_radius(discretised->curve, 0.0) + fill.clearance);
    }
    const double region_area = region_of(fill, fluid).area, body_area = area(discretised->curve);
    const long count = count_of(fill, region_area, body_area);
    fill_of.insert(fill_of.end(), static_cast<std::size_t>(count), &fill);
    fractions.push_back(static_cast<double>(count) * body_area / region_area);
  }
  // Inserts bodies at a part of their size, up to the first body for which no room is found.
  const auto insert = [&](double size) {
    Obstacles obstacles(given, cell);
    std::mt19937_64 random(file.scene.seed);
    std::vector<Body> bodies;
    for (const Fill& fill : file.fills) {
      const auto count = std::ranges::count(fill_of, &fill);
      Fill part = fill;
      part.body.shape = scaled(fill.body.shape, size);
      part.clearance = size * fill.clearance;
      const auto discretised =
          discretise(part.body.shape, fill.body.n_nodes, ComponentKind::free_body, "[[fill]]");
      const std::vector<Body> inserted =
          insert_bodies(part, count, *discretised, region_of(fill, fluid).box, random, obstacles);
      bodies.insert(bodies.end(), inserted.begin(), inserted.end());
      if (std::ssize(inserted) < count) break;
    }
    return bodies;
  };
  std::vector<Body> placed = insert(1.0);
  if (placed.size() < fill_of.size()) {
    filled.plan = {"fill             " + std::to_string(fill_of.size()) +
                   " bodies grew from half their size and were moved apart, since random "
                   "insertion found room for " +
                   std::to_string(placed.size())};
    GrowingBodies growing{0.5, insert(0.5)};
    const double part =
        static_cast<double>(growing.bodies.size()) / static_cast<double>(fill_of.size());
    if (part == 1.0) growing = grow_bodies(file.scene, fill_of, std::move(growing));
    if (growing.size < 1.0) {
      const auto reached = [&](double fraction) {
        return short_number(part * growing.size * growing.size * fraction) + " of " +
               short_number(fraction);
      };
      throw std::invalid_argument("[[fill]]: found room for an area fraction of " +
                                  joined(fractions, " and ", reached) +
                                  "; lower area_fraction, count or clearance");
    }
    placed = std::move(growing.bodies);
  }
  filled.scene.bodies.insert(filled.scene.bodies.end(), placed.begin(), placed.end());
  return filled;
}

Scene place_fills(const SceneFile& file) {
  return fill_scene(file).scene;
}

}  // namespace stokesbook
