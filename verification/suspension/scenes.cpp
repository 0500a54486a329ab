// Builds the scenes of the study: the scenes of chapter 12, and random scenes.
#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "scene/parse.hpp"
#include "support/smooth_curve.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/nodes/random_fill.hpp"

namespace stokesbook::verification::suspension {

namespace {

Complex random_in_square(std::mt19937_64& random) {
  const double x = uniform(random, -1.0, 1.0);
  return {x, uniform(random, -1.0, 1.0)};
}

Shape random_shape(std::mt19937_64& random) {
  switch (random() % 3) {
    case 0:
      return Circle{uniform(random, 0.4, 1.0)};
    case 1:
      return Ellipse{1.0, 1.0 / log_uniform(random, 1.0, 6.0)};
    default: {
      const double radius = uniform(random, 0.5, 0.9), amplitude = uniform(random, 0.05, 0.2);
      return Star{radius, amplitude, 2 + static_cast<int>(random() % 4)};
    }
  }
}

// Returns a random shape that may be more slender or more lobed than any shape of the book's
// scenes.
Shape hard_shape(std::mt19937_64& random, double slenderest) {
  switch (random() % 3) {
    case 0:
      return Ellipse{1.0, log_uniform(random, slenderest, 1.0)};
    case 1: {
      const int arms = 2 + static_cast<int>(random() % 17);
      return Star{1.0, uniform(random, -0.5, 0.5), arms};
    }
    default: {
      const int power = 4 + 2 * static_cast<int>(random() % 5);
      return Superellipse{1.0, log_uniform(random, 0.1, 1.0), power};
    }
  }
}

SmoothCurve curve_of(const Body& body, int nodes) {
  return test::smooth_body(body.shape, nodes, body.position, body.orientation);
}

// Moves a body along a ray from the origin until its distance from the others is the gap.
void move_to_gap(Body& body, const std::vector<Body>& others, double angle, double gap,
                 int nodes = 64) {
  std::vector<SmoothCurve> obstacles;
  for (const Body& other : others) obstacles.push_back(curve_of(other, nodes));
  double low = 0.0, high = 12.0;
  for (int bisection = 0; bisection < 30; ++bisection) {
    const double middle = 0.5 * (low + high);
    body.position = std::polar(middle, angle);
    const SmoothCurve curve = curve_of(body, nodes);
    const bool too_close = std::ranges::any_of(obstacles, [&](const SmoothCurve& obstacle) {
      return closest_points(curve, obstacle).gap < gap;
    });
    (too_close ? low : high) = middle;
  }
  body.position = std::polar(high, angle);
}

// Returns a container of all bodies. The container rotates or translates.
Wall random_container(std::mt19937_64& random, const std::vector<Body>& bodies) {
  double reach = 0.0;
  for (const Body& body : bodies) reach = std::max(reach, std::abs(body.position) + 1.05);
  const double radius = reach * uniform(random, 1.0, 1.3);
  Wall wall{.role = WallRole::outer, .shape = Circle{radius}, .n_nodes = 16};
  if (random() % 2 == 0) wall.shape = Ellipse{1.2 * radius, radius};
  wall.motion = RotatingWall{1.0};
  if (random() % 2 == 0) wall.motion = TranslatingWall{random_in_square(random)};
  return wall;
}

}  // namespace

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

double log_uniform(std::mt19937_64& random, double low, double high) {
  return low * std::pow(high / low, uniform(random, 0.0, 1.0));
}

SceneFile shipped_file(const std::string& name) {
  return read_scene(std::filesystem::path(STOKESBOOK_SCENES) / (name + ".toml"));
}

Scene shipped_scene(const std::string& name) {
  return place_fills(shipped_file(name));
}

const Scene& shipped_crowd() {
  static const Scene crowd = shipped_scene("extension_crowd");
  return crowd;
}

Scene turning_ellipses(study::Size size, double rate) {
  const bool full = size == study::Size::full;
  Scene scene;
  scene.walls.push_back(
      {.role = WallRole::outer, .shape = Circle{full ? 4.0 : 1.2}, .motion = RotatingWall{rate}});
  scene.contact = ContactSettings{0.01};
  scene.solver.tolerance = 1e-3;
  scene.seed = 3;
  const Fill ellipses{
      .body = {.shape = Ellipse{0.3, 0.12}}, .count = full ? 120 : 10, .clearance = 0.02};
  return place_fills({scene, {ellipses}});
}

Scene with_nodes(Scene scene, int a_body, int a_wall) {
  for (Body& body : scene.bodies) body.n_nodes = a_body;
  for (Wall& wall : scene.walls) wall.n_nodes = a_wall;
  return scene;
}

Scene random_scene(std::mt19937_64& random) {
  Scene scene;
  scene.solver.tolerance = 1e-12;
  const std::size_t count = random() % 2 == 0 ? 2 : 2 + random() % 4;
  const bool loaded = random() % 2 == 0, some_held = random() % 3 == 0;
  for (std::size_t k = 0; k < count; ++k) {
    Body body{.shape = random_shape(random), .n_nodes = 16};
    body.orientation = uniform(random, 0.0, 2.0 * std::numbers::pi);
    const double angle = uniform(random, 0.0, 2.0 * std::numbers::pi);
    if (k > 0) move_to_gap(body, scene.bodies, angle, log_uniform(random, 1e-3, 1.0));
    body.held = some_held && random() % 2 == 0;
    if (body.held || loaded) {
      (body.held ? body.velocity : body.force) = random_in_square(random);
      (body.held ? body.omega : body.torque) = uniform(random, -1.0, 1.0);
    }
    scene.bodies.push_back(body);
  }
  if (random() % 3 == 0) {
    scene.walls.push_back(random_container(random, scene.bodies));
    return scene;
  }
  scene.flow = ShearFlow{1.0};
  if (random() % 2 == 0) scene.flow = ExtensionalFlow{1.0};
  if (loaded && std::ranges::none_of(scene.bodies, &Body::held)) scene.gauge_length = 30.0;
  return scene;
}

Scene hard_scene(std::mt19937_64& random, double slenderest) {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  if (random() % 2 == 0) scene.flow = ExtensionalFlow{1.0};
  scene.solver.tolerance = log_uniform(random, 1e-6, 3e-2);
  const bool is_automatic = random() % 2 == 0;
  const std::size_t count = 2 + random() % 2;
  for (std::size_t k = 0; k < count; ++k) {
    Body body{.shape = hard_shape(random, slenderest), .n_nodes = automatic_nodes};
    if (!is_automatic) body.n_nodes = 2 * static_cast<int>(log_uniform(random, 4.0, 100.0));
    body.orientation = uniform(random, 0.0, 2.0 * std::numbers::pi);
    const double angle = uniform(random, 0.0, 2.0 * std::numbers::pi);
    if (k > 0) move_to_gap(body, scene.bodies, angle, log_uniform(random, 1e-2, 3.0), 400);
    scene.bodies.push_back(body);
  }
  if (random() % 4 == 0) {
    scene.bodies[0].force = random_in_square(random);
    scene.bodies[1].force = -scene.bodies[0].force;
  }
  return scene;
}

Solved solved_at(const SuspensionSolver& solver, const Resolutions& resolutions,
                 double gmres_tolerance) {
  LinearSystem discrete = solver.linear_system(solver.start(), solver.discretise(resolutions));
  const ComplexVector rhs = discrete.system.right_hand_side();
  GmresResult gmres = solve(discrete, rhs, {gmres_tolerance, 2000});
  const ComplexVector density = deinterleaved(gmres.solution);
  Completion completion = discrete.system.closure().complete(density);
  return {std::move(discrete), std::move(gmres), density, std::move(completion),
          rhs.cwiseAbs().maxCoeff()};
}

Resolutions times(double factor, Resolutions resolutions) {
  for (Resolution& resolution : resolutions) {
    resolution.n_nodes = 2 * static_cast<int>(std::lround(0.5 * factor * resolution.n_nodes));
  }
  return resolutions;
}

double error(const Solved& solved, const Completion& reference) {
  return *relative_change(solved.discrete.problem(), reference, solved.completion, solved.scale);
}

}  // namespace stokesbook::verification::suspension
