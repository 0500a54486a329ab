#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "support/distance.hpp"
#include "support/lopsided_curve.hpp"
#include "suspension/bodies/background_flow.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook::test {

inline Body body(const Shape& shape, int n_nodes, Complex position, double orientation = 0.0,
                 const Load& load = {}) {
  return {shape, position, orientation, load.force, load.torque, false, {}, 0.0, n_nodes};
}

inline Body held_body(const Shape& shape, int n_nodes, Complex position, double orientation = 0.0,
                      const RigidMotion& motion = {}) {
  return {shape, position, orientation, {}, 0.0, true, motion.velocity, motion.omega, n_nodes};
}

inline Wall outer_wall(const Shape& shape, int n_nodes, const WallMotion& motion = {},
                       Complex position = {}, double orientation = 0.0) {
  return {WallRole::outer, shape, position, orientation, n_nodes, motion};
}

inline Wall inner_wall(const Shape& shape, int n_nodes, const WallMotion& motion = {},
                       Complex position = {}, double orientation = 0.0) {
  return {WallRole::inner, shape, position, orientation, n_nodes, motion};
}

/// Returns a scene that is solved almost to rounding, or refused.
inline Scene scene(std::vector<Body> bodies, const BackgroundFlow& flow = {},
                   std::vector<Wall> walls = {}) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.walls = std::move(walls);
  scene.flow = flow;
  scene.solver.tolerance = 1e-12;
  return scene;
}

inline Scene with_gauge(Scene scene, double gauge_length) {
  scene.gauge_length = gauge_length;
  return scene;
}

/// A scene, its solver, and its solution at the start.
struct Solved {
  SuspensionSolver solver;
  Solution solution;

  explicit Solved(const Scene& scene) : solver(scene), solution(solver.solve(solver.start())) {}

  const RigidMotion& motion(std::size_t component) const { return solution.motions[component]; }
  const Load& load(std::size_t component) const { return solution.loads[component]; }
  ComplexVector velocity(const ComplexVector& points) const {
    return solver.velocity(solution, points);
  }

  /// Returns the stresslet S_11 + i S_12 of a component, -mu \int n eta ds.
  Complex stresslet(std::size_t component) const {
    const StokesProblem problem = solver.problem(solution.instant, solution.discretisation);
    const Eigen::Index first = node_offsets(problem)[component];
    const Curve& curve = problem.components[component].curve;
    const auto density = solution.density.segment(first, curve.size());
    return -problem.viscosity *
           normals(curve).cwiseProduct(density).cwiseProduct(weights(curve)).sum();
  }
};

/// Returns the largest difference of velocities and angular velocities of components whose size is
/// of the order of 1.
inline double largest_difference(const std::vector<RigidMotion>& a,
                                 const std::vector<RigidMotion>& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(
        {largest, std::abs(a[k].velocity - b[k].velocity), std::abs(a[k].omega - b[k].omega)});
  }
  return largest;
}

/// Converts a residual relative to the whole flow, as in published results, to a residual relative
/// to the part of the flow that strains the bodies, as in this library.
inline double relative_to_whole_flow(const SuspensionSolver& solver, double published) {
  const StokesProblem problem = solver.problem(solver.start(), solver.discretisation());
  const ComplexVector flow =
      background_velocity(solver.scene().flow, all_nodes(curves_of(problem)));
  return published * flow.norm() / problem.background.norm();
}

/// Solves a scene and checks that the solver refuses it with a message that contains all words.
inline void check_refused(const Scene& scene, const std::vector<std::string>& words) {
  const auto mentions_all = [&](const SolverError& error) {
    const std::string message = error.what();
    for (const std::string& word : words) {
      BOOST_TEST(message.find(word) != std::string::npos, "no \"" << word << "\" in: " << message);
    }
    return true;
  };
  BOOST_CHECK_EXCEPTION(Solved{scene}, SolverError, mentions_all);
}

/// Returns the numbers of nodes that shapes and gaps require at the start.
inline std::vector<int> recommended_nodes(const SuspensionSolver& solver) {
  const Configuration start = solver.start().configuration;
  return solver.recommended_nodes(start, solver.gaps(start));
}

/// Returns the resolutions with which a solve at the start begins.
inline Resolutions first_resolutions(const SuspensionSolver& solver) {
  const Configuration start = solver.start().configuration;
  return solver.first_resolutions(start, solver.gaps(start));
}

/// Gives every component as many nodes as its shape and gaps require, and some more for the
/// densities.
inline Scene resolved(Scene scene) {
  const auto set_nodes = [&](auto nodes_of) {
    std::size_t k = 0;
    for (Body& body : scene.bodies) body.n_nodes = nodes_of(k++);
    for (Wall& wall : scene.walls) wall.n_nodes = nodes_of(k++);
  };
  set_nodes([](std::size_t) { return 128; });
  const SuspensionSolver solver(scene);
  const std::vector<int> asked = recommended_nodes(solver);
  set_nodes([&](std::size_t k) { return std::max(96, asked[k] + asked[k] / 3 / 2 * 2); });
  return scene;
}

/// Places bodies at random in a disk about the origin, with their bounding circles at least a gap
/// apart.
inline void place_at_random(Scene& scene, std::mt19937_64& random, double disk, double gap) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto radius = [](const Body& body) {
    return bounding_radius(sample(body.shape, 64, Side::fluid_outside), 0.0);
  };
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    Body& body = scene.bodies[k];
    const auto fits = [&] {
      if (std::abs(body.position) + radius(body) > disk) return false;
      for (std::size_t j = 0; j < k; ++j) {
        const Body& other = scene.bodies[j];
        const double distance = std::abs(body.position - other.position);
        if (distance < radius(body) + radius(other) + gap) return false;
      }
      return true;
    };
    do {
      body.position = disk * Complex{uniform(random), uniform(random)};
    } while (!fits());
    body.orientation = 3.0 * uniform(random);
  }
}

/// Returns three bodies of different shapes, for random places in a disk of radius 3.
inline std::vector<Body> random_bodies(std::mt19937_64& random, double gap = 0.15) {
  std::vector<Shape> shapes{Circle{0.6}, Ellipse{0.9, 0.5}, Star{0.7, 0.15, 5},
                            Superellipse{0.7, 0.5, 4}, lopsided_curve(0.7)};
  std::shuffle(shapes.begin(), shapes.end(), random);
  Scene three = scene({body(shapes[0], 0, {}), body(shapes[1], 0, {}), body(shapes[2], 0, {})});
  place_at_random(three, random, 3.0, gap);
  return three.bodies;
}

/// Returns a random force and torque of size one.
inline Load random_load(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double x = uniform(random), y = uniform(random);
  return {{x, y}, uniform(random)};
}

/// Returns a random velocity and angular velocity of size one.
inline RigidMotion random_motion(std::mt19937_64& random) {
  const Load load = random_load(random);
  return {load.force, load.torque};
}

}  // namespace stokesbook::test
