// Builds scenes of bodies that nearly touch, and discretises them at the solver's first resolution.
#include "support/touching.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "support/boxed_packing.hpp"
#include "suspension/nodes/random_fill.hpp"

namespace stokesbook::test {

namespace {

Scene disks(const std::vector<Complex>& positions, double tolerance) {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.solver.tolerance = tolerance;
  for (const Complex position : positions) {
    scene.bodies.push_back({.shape = Circle{1.0}, .position = position});
  }
  return scene;
}

/// Returns the points of a hexagonal lattice whose hexagonal distance from the origin is at most
/// `rings`.
std::vector<Complex> lattice(int rings, double pitch) {
  std::vector<Complex> points;
  for (int i = -rings; i <= rings; ++i) {
    for (int j = -rings; j <= rings; ++j) {
      if (std::abs(i + j) > rings) continue;
      points.push_back(pitch * Complex(i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j));
    }
  }
  return points;
}

// Sets normally distributed forces, whose sum is zero, and torques. The fluid is at rest far away.
Scene under_loads(Scene scene) {
  scene.flow = QuiescentFlow{};
  std::mt19937_64 random(11);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random()) + 0.5, -64); };
  // A complex number whose parts are independent and normally distributed (Box and Muller).
  const auto normal = [&] {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return std::polar(radius, 2.0 * std::numbers::pi * uniform());
  };
  Complex sum;
  for (Body& body : scene.bodies) {
    body.force = normal();
    body.torque = normal().real();
    sum += body.force;
  }
  for (Body& body : scene.bodies) body.force -= sum / static_cast<double>(scene.bodies.size());
  return scene;
}

// Returns a request for ellipses with the semi-axes `aspect` and 1, or for disks.
Fill fill_of(double aspect, int count, double gap) {
  Fill fill{.count = count, .clearance = gap};
  if (aspect == 1.0) {
    fill.body.shape = Circle{1.0};
  } else {
    fill.body.shape = Ellipse{aspect, 1.0};
  }
  return fill;
}

Scene filled(const Fill& fill, std::vector<Wall> walls = {}) {
  SceneFile file;
  file.scene.seed = 3;
  file.scene.solver.tolerance = 1e-5;
  file.scene.walls = std::move(walls);
  file.fills = {fill};
  return place_fills(file);
}

}  // namespace

Scene disk_chain(double gap) {
  std::vector<Complex> positions;
  for (int k = -2; k <= 2; ++k) positions.push_back(k * (2.0 + gap) * std::polar(1.0, 0.3));
  return disks(positions, 1e-6);
}

Scene disk_hexagon(int rings, double gap, double tolerance) {
  std::vector<Complex> positions = lattice(rings, 2.0 + gap);
  for (Complex& position : positions) position *= std::polar(1.0, 0.2);
  return disks(positions, tolerance);
}

Scene disk_packing(int count) {
  constexpr double fraction = 0.6, least_distance = 2.001, longest_move = 0.4;
  constexpr int moves_each = 500;
  const double pitch = std::sqrt(2.0 * std::numbers::pi / (std::numbers::sqrt3 * fraction));
  const Complex centre(0.31, 0.17);
  std::vector<Complex> positions =
      lattice(2 + static_cast<int>(std::ceil(std::sqrt(count / 2.0))), pitch);
  const auto from_centre = [&](Complex z) { return std::abs(z - centre); };
  std::ranges::sort(positions, {}, from_centre);
  positions.resize(static_cast<std::size_t>(count));
  const double radius = from_centre(positions.back());
  std::mt19937_64 random(7);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random()), -64); };
  for (int move = 0; move < moves_each * count; ++move) {
    Complex& position = positions[random() % positions.size()];
    const double up = longest_move * (2.0 * uniform() - 1.0);
    const double right = longest_move * (2.0 * uniform() - 1.0);
    const Complex moved = position + Complex(right, up);
    const bool meets = std::ranges::any_of(positions, [&](const Complex& other) {
      return &other != &position && std::norm(other - moved) < least_distance * least_distance;
    });
    if (!meets && from_centre(moved) <= radius) position = moved;
  }
  return disks(positions, 1e-5);
}

Scene loaded_packing(int count, double fraction, unsigned seed) {
  return under_loads(disks(boxed_packing(count, fraction, 1e-3, seed), 1e-5));
}

Scene loaded_ellipses(int count, double fraction) {
  const double side = std::sqrt(count * 3.0 * std::numbers::pi / fraction);
  Fill fill = fill_of(3.0, count, 1e-3);
  fill.box = {0.0, 0.0, side, side};
  return under_loads(filled(fill));
}

Scene loaded_line(int count, double gap) {
  std::vector<Complex> positions;
  for (int k = 0; k < count; ++k) positions.emplace_back(k * (2.0 + gap), 0.0);
  Scene scene = disks(positions, 1e-5);
  scene.flow = QuiescentFlow{};
  double sign = 1.0;
  for (Body& body : scene.bodies) {
    body.force = sign * Complex(1.0, 0.5);
    body.torque = sign;
    sign = -sign;
  }
  return scene;
}

Scene settling_in_container(double aspect, int count, double fraction, double gap) {
  Fill fill = fill_of(aspect, count, gap);
  fill.body.force = -imaginary;
  return filled(fill,
                {{.role = WallRole::outer, .shape = Circle{std::sqrt(count * aspect / fraction)}}});
}

Scene ellipses_in_vortices(double tolerance) {
  Scene scene;
  scene.flow = TaylorGreenFlow{1.0};
  scene.solver.tolerance = tolerance;
  for (const double x : {-1.492, -0.4973, 0.4973, 1.492}) {
    for (int k = 0; k < 12; ++k) {
      scene.bodies.push_back(
          {.shape = Ellipse{0.475, 0.1}, .position = {x, 0.13567 * (2 * k - 11)}});
    }
  }
  return scene;
}

Scene sheared(Scene scene) {
  for (Body& body : scene.bodies) {
    body.force = 0.0;
    body.torque = 0.0;
  }
  scene.flow = ShearFlow{1.0};
  return scene;
}

Scene with_contact(Scene scene, double separation) {
  scene.contact = ContactSettings{separation};
  return scene;
}

Scene with_preconditioner(Scene scene, PreconditionerKind preconditioner) {
  scene.solver.preconditioner = preconditioner;
  return scene;
}

Discretised::Discretised(const Scene& scene)
    : solver(scene),
      configuration(solver.start().configuration),
      discretisation(
          solver.discretise(solver.first_resolutions(configuration, solver.gaps(configuration)))),
      discrete(solver.linear_system(solver.instant(configuration), discretisation)) {}

Discretised::Discretised(const Scene& scene, ClusterForm form)
    : Discretised(with_preconditioner(scene, PreconditionerKind::none)) {
  discrete.precondition =
      cluster_preconditioner(discrete.problem(), configuration, discretisation,
                             placed_cauchy_schemes(configuration, discretisation), form);
}

}  // namespace stokesbook::test
