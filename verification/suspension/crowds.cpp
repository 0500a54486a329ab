// Generates random dense scenes: places bodies at random in a container, then shrinks the container
// while the bodies move at random (hard particles, by the formulas of the shapes).
#include "crowds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "scenes.hpp"
#include "support/exact_gaps.hpp"

namespace stokesbook::verification::suspension {

using namespace test;

namespace {

constexpr double pi = std::numbers::pi;

Shape random_shape(Crowd crowd, std::mt19937_64& random) {
  const double size = uniform(random, 0.4, 0.6);
  switch (crowd) {
    case Crowd::circles:
      return Circle{size};
    case Crowd::ellipses: {
      const double aspect = std::sqrt(log_uniform(random, 1.2, 10.0));
      return Ellipse{size * aspect, size / aspect};
    }
    default:
      return Star{size, uniform(random, 0.05, 0.2), 3 + static_cast<int>(random() % 3)};
  }
}

/// Bodies that a shrinking container pushes together.
class Press {
 public:
  Press(std::vector<PlacedShape> bodies, double stretch, double clearance)
      : bodies_(std::move(bodies)), stretch_(stretch), clearance_(clearance) {
    for (const PlacedShape& body : bodies_)
      filled_ += area(sample(body.shape, samples, Side::fluid_outside));
    radius_ = 3.0 * std::sqrt(filled_ / pi);
  }

  double fraction() const { return filled_ / (pi * radius_ * radius_); }
  Ellipse container() const { return {stretch_ * radius_, radius_ / stretch_}; }
  const std::vector<PlacedShape>& bodies() const { return bodies_; }

  /// Places all bodies at random, one after another.
  void fill(std::mt19937_64& random) {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      do {
        const double angle = uniform(random, 0.0, 2.0 * pi);
        bodies_[k].position = std::polar(radius_ * uniform(random, 0.0, 1.0), angle);
        bodies_[k].orientation = uniform(random, 0.0, 2.0 * pi);
      } while (!has_room(bodies_[k], k, k));
    }
  }

  /// Moves each body at random if there is room. Then shrinks the container, and moves all bodies
  /// inwards with it.
  void shake(std::mt19937_64& random) {
    std::size_t moved_on = 0;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      PlacedShape moved = bodies_[k];
      const double angle = uniform(random, 0.0, 2.0 * pi);
      moved.position += std::polar(stride_ * uniform(random, 0.0, 1.0), angle);
      moved.orientation += 1.5 * stride_ * uniform(random, -1.0, 1.0);
      if (!has_room(moved, k, bodies_.size())) continue;
      bodies_[k] = moved;
      ++moved_on;
    }
    stride_ = std::clamp(2 * moved_on > bodies_.size() ? 1.2 * stride_ : 0.8 * stride_, 0.003, 0.3);
    shrink(0.1 * stride_);
  }

 private:
  static constexpr int samples = 64;

  /// Shrinks the container by a part of its radius, if there is room.
  void shrink(double part) {
    const Press wide = *this;
    radius_ *= 1.0 - part;
    for (PlacedShape& body : bodies_) body.position *= 1.0 - part;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (has_room(bodies_[k], k, k)) continue;
      *this = wide;
      return;
    }
  }

  bool is_within(const PlacedShape& body) const {
    return exact_gap(body, {container(), {}, 0.0, true}, samples) >= clearance_;
  }

  bool has_room(const PlacedShape& body, std::size_t own, std::size_t placed) const {
    if (!is_within(body)) return false;
    for (std::size_t k = 0; k < placed; ++k) {
      if (k == own) continue;
      if (least_exact_gap({body, bodies_[k]}, 2.0 * clearance_, samples) < clearance_) return false;
    }
    return true;
  }

  std::vector<PlacedShape> bodies_;
  double stretch_, clearance_, radius_ = 0.0, filled_ = 0.0;
  double stride_ = 0.3;  // length of a random move, adapted so that half of the moves find room
};

Press pressed(Crowd crowd, std::size_t count, double stretch, double clearance,
              std::mt19937_64& random) {
  std::vector<PlacedShape> bodies;
  for (std::size_t k = 0; k < count; ++k) bodies.push_back({random_shape(crowd, random)});
  Press press(std::move(bodies), stretch, clearance);
  press.fill(random);
  const double fraction = uniform(random, 0.2, 0.6);
  for (int k = 0; k < 2000 && press.fraction() < fraction; ++k) press.shake(random);
  return press;
}

void add_drive(Scene& scene, Drive drive) {
  switch (drive) {
    case Drive::rotating_container:
      scene.walls[0].motion = RotatingWall{1.0};
      return;
    case Drive::shear:
      scene.flow = ShearFlow{1.0};
      break;
    case Drive::extension:
      scene.flow = ExtensionalFlow{1.0};
      break;
    case Drive::vortices:
      scene.flow = TaylorGreenFlow{1.0};
      return;
    case Drive::settling:
      for (Body& body : scene.bodies) body.force = {0.0, -30.0};
      return;
  }
  for (double t = 2.0; t < scene.time->t_final; t += 2.0) scene.reverse_at.push_back(t);
}

}  // namespace

Scene crowded_scene(const Family& family, unsigned seed, int steps) {
  std::mt19937_64 random(seed);
  Scene scene;
  scene.solver.tolerance = 1e-3;
  scene.solver.gmres_max_iterations = 2000;
  const double separation = log_uniform(random, 0.03, 0.06);
  scene.contact = ContactSettings{separation};
  const bool settles = family.drive == Drive::settling;
  const bool enclosed = settles || family.drive == Drive::rotating_container;
  const std::size_t count = 5 + random() % (enclosed ? 4 : 11);
  const double stretch = settles ? uniform(random, 1.0, 1.15) : 1.0;
  const Press press = pressed(family.crowd, count, stretch, 1.05 * separation, random);
  for (const PlacedShape& body : press.bodies()) {
    scene.bodies.push_back(
        {.shape = body.shape, .position = body.position, .orientation = body.orientation});
  }
  if (enclosed) scene.walls.push_back({.role = WallRole::outer, .shape = press.container()});
  const double dt = 0.02 * log_uniform(random, 1.0, 20.0);
  const auto method = random() % 2 == 0 ? SteppingMethod::euler : SteppingMethod::heun;
  scene.time = TimeSettings{steps * dt, dt, method};
  add_drive(scene, family.drive);
  return scene;
}

}  // namespace stokesbook::verification::suspension
