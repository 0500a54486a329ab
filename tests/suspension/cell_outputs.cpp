// Tests in periodic cells what depends on points and pairs anywhere: fields, values at nodes,
// tracers and repulsion, against closed forms and identities.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "scenes.hpp"
#include "support/smooth_curve.hpp"
#include "support/vectors.hpp"
#include "suspension/bodies/cell.hpp"
#include "suspension/solver/fields.hpp"
#include "suspension/solver/tracers.hpp"
#include "trajectories.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

const Complex a1{2.2, 0.1}, a2{1.6, 2.0};

// Returns G w for the linear flow below.
Complex carried(Complex w) {
  return {0.2 * w.real() + w.imag(), -0.3 * w.real() - 0.2 * w.imag()};
}

// Two bodies that lie across edges of a cell in a linear flow; the path of the disk has led it to
// another cell.
Scene two_bodies(const Load& on_disk = {}) {
  Scene made = scene(
      {body(Ellipse{0.7, 0.3}, automatic_nodes, {-0.9, 0.5}, 0.5),
       body(Circle{0.4}, automatic_nodes, Complex{0.2, -0.35} + 3.0 * a1 - 2.0 * a2, 0.0, on_disk)},
      LinearFlow{Eigen::Matrix2d{{0.2, 1.0}, {-0.3, -0.2}}, {0.3, 0.1}});
  made.cell.emplace();
  made.cell->vectors << a1.real(), a1.imag(), a2.real(), a2.imag();
  made.viscosity = 1.3;
  made.solver.tolerance = 1e-9;
  return made;
}

// Returns the body whose image covers a point, and the vector to this image, by tests of all images
// about the cell; a body of -1 if the point is in the fluid.
std::pair<int, Complex> covering_by_all_images(const Scene& scene, Complex point) {
  const Lattice lattice(a1, a2);
  for (int i = -9; i <= 9; ++i) {
    for (int j = -9; j <= 9; ++j) {
      const Complex w = lattice.vector({i, j});
      const Complex own = std::polar(1.0, -0.5) * (point - scene.bodies[0].position - w);
      if (std::hypot(own.real() / 0.7, own.imag() / 0.3) < 1.0) return {0, w};
      if (std::abs(point - scene.bodies[1].position - w) < 0.4) return {1, w};
    }
  }
  return {-1, 0.0};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(cell_outputs)

BOOST_AUTO_TEST_CASE(points_in_bodies_and_their_images) {
  const Scene made = two_bodies();
  const SuspensionSolver solver(made);
  const Instant start = solver.start();
  const ComplexVector points = 5.0 * random_vector(2000, 1);
  // The result does not depend on which images of the bodies are given.
  Configuration on_paths = start.configuration;
  for (std::size_t k = 0; k < 2; ++k) on_paths[k].position = start.path_position(k);
  const auto covering =
      covering_components(on_paths, solver.discretisation(), points, 0.0, start.cell);
  const auto fluid = in_fluid(start.configuration, solver.discretisation(), points, start.cell);
  int covered = 0;
  for (std::size_t i = 0; i < covering.size(); ++i) {
    const auto [k, w] = covering_by_all_images(made, points[static_cast<Eigen::Index>(i)]);
    BOOST_TEST((covering[i] ? static_cast<int>(covering[i]->component) : -1) == k);
    BOOST_TEST(fluid[i] == (k < 0 ? 1 : 0));
    if (covering[i]) BOOST_TEST(std::abs(covering[i]->shift - w) < 1e-13);
    covered += k < 0 ? 0 : 1;
  }
  const double part = std::numbers::pi * (0.21 + 0.16) / std::abs(cross(a1, a2));
  BOOST_TEST(std::abs(covered / 2000.0 - part) < 0.03);
}

// Fields of two boxes that differ by a lattice vector w: velocities differ by G w, and pressures by
// F.w / V with the force F of all bodies.
BOOST_AUTO_TEST_CASE(fields_repeat) {
  Scene made = two_bodies({{0.7, -0.4}, 0.3});
  FieldSettings& fields = made.output.fields.emplace();
  fields.resolution = 12;
  fields.quantities = {FieldQuantity::velocity, FieldQuantity::pressure, FieldQuantity::vorticity,
                       FieldQuantity::shear_stress, FieldQuantity::dissipation};
  const auto field_at = [&](Complex corner) {
    made.output.fields->box = {corner.real(), corner.imag(), corner.real() + 2.3,
                               corner.imag() + 2.2};
    const Solved solved(made);
    return evaluate_field(solved.solver, solved.solution);
  };
  const Complex w = 2.0 * a1 - 3.0 * a2, force{0.7, -0.4};
  const Field here = field_at({-1.1, -1.0}), there = field_at(Complex{-1.1, -1.0} + w);
  BOOST_TEST(std::ranges::count(here.in_fluid, 0) > 20);
  BOOST_TEST((here.in_fluid == there.in_fluid));
  for (Eigen::Index i = 0; i < here.velocity.size(); ++i) {
    if (here.in_fluid[static_cast<std::size_t>(i)] == 0) continue;
    const auto differs = [&](double a, double b, double exact = 0.0) {
      BOOST_TEST(std::abs(b - a - exact) < 1e-8 * (1.0 + std::abs(a)));
    };
    BOOST_TEST(std::abs(there.velocity[i] - here.velocity[i] - carried(w)) < 1e-8);
    differs(here.pressure[i], there.pressure[i], dot(force, w) / std::abs(cross(a1, a2)));
    differs(here.vorticity[i], there.vorticity[i]);
    differs(here.shear_stress[i], there.shear_stress[i]);
    differs(here.dissipation[i], there.dissipation[i]);
  }
}

// The integrals of the tractions at the nodes are the loads of the bodies, wherever their nodes
// lie.
BOOST_AUTO_TEST_CASE(tractions_have_the_loads_as_integrals) {
  Scene made = two_bodies({{0.7, -0.4}, 0.3});
  made.bodies[0].held = true;
  made.bodies[0].velocity = {0.2, 0.1};
  made.bodies[0].n_nodes = 96;
  made.bodies[1].n_nodes = 64;
  const Solved solved(made);
  const std::vector<NodeValues> values = node_values(solved.solver, solved.solution);
  std::vector<Load> sums(2);
  for (const NodeValues& node : values) {
    const std::size_t k = node.component.number;
    const Complex force = node.weight * node.traction;
    sums[k].force += force;
    sums[k].torque +=
        cross(node.position - solved.solution.instant.configuration[k].position, force);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    // The traction includes that of the pressure, whose mean gradient acts on the body's area.
    BOOST_TEST(std::abs(sums[k].force - solved.load(k).force) < 1e-7);
    BOOST_TEST(std::abs(sums[k].torque - solved.load(k).torque) < 1e-7);
  }
}

// Two tracers that differ by a lattice vector do so at all times; tracers in images are left out.
BOOST_AUTO_TEST_CASE(tracers_of_all_cells_move_alike) {
  Scene made = two_bodies();
  const Complex w = a1 - 2.0 * a2, start{-0.3, 1.1};
  made.tracers = {start, Complex{0.2, -0.35} + a2, start + w, Complex{-0.9, 0.5} - 5.0 * a1};
  made.solver.tolerance = 1e-7;
  made.time = TimeSettings{.t_final = 0.3, .dt = {}, .tolerance = 1e-8};
  const std::vector<Frame> frames = frames_of(made);
  BOOST_TEST(frames.front().tracers.size() == 2U);
  const PeriodicCell cell = *cell_at(made, 0.3);
  const std::vector<Complex>& end = frames.back().tracers;
  BOOST_TEST(std::abs(end[0] - start) > 0.1);
  BOOST_TEST(std::abs(end[1] - end[0] - (cell.a1 - 2.0 * cell.a2)) < 1e-6);
}

// A tracer that errors have taken into an image of a body moves with this image.
BOOST_AUTO_TEST_CASE(tracers_in_images_move_with_them) {
  Scene made = two_bodies({{0.7, -0.4}, 0.3});
  made.tracers = {{-0.3, 1.1}};
  const Solved solved(made);
  const Complex w = a1 + 2.0 * a2, arm = std::polar(0.4 * (1.0 - 1e-6), 0.7);
  Eigen::VectorXd state = initial_state(solved.solver);
  const Complex tracer = made.bodies[1].position + w + arm;
  state.tail<2>() << tracer.real(), tracer.imag();
  const Eigen::VectorXd rate = state_rate(solved.solver, solved.solution, state);
  const Complex velocity{rate[6], rate[7]}, of_disk{rate[3], rate[4]};
  BOOST_TEST(std::abs(velocity - (of_disk + carried(w) + imaginary * rate[5] * arm)) < 1e-12);
  const auto tells = [](const ConfigurationError& error) {
    return std::string(error.what()) == "t = 0: tracer 0 enters body 1: take smaller steps";
  };
  const Complex inside = made.bodies[1].position + w + 0.99 * arm;
  state.tail<2>() << inside.real(), inside.imag();
  BOOST_CHECK_EXCEPTION(admitted_configuration(solved.solver, 0.0, state), ConfigurationError,
                        tells);
}

// Frames have paths and the images in the cell, whose velocities differ by G w.
BOOST_AUTO_TEST_CASE(frames_have_paths_and_images) {
  Scene made = two_bodies({{0.7, -0.4}, 0.3});
  made.solver.tolerance = 1e-4;
  made.time = TimeSettings{.t_final = 0.2, .dt = 0.1, .method = SteppingMethod::heun};
  for (const Frame& frame : frames_of(made)) {
    const PeriodicCell cell = *cell_at(made, frame.t);
    const auto& [lattice, centre, images] = frame.cell.value();
    BOOST_TEST((centre == Complex{0.3, 0.1}));
    BOOST_TEST((lattice.vector({1, 0}) == cell.a1 && lattice.vector({0, 1}) == cell.a2));
    for (std::size_t k = 0; k < 2; ++k) {
      const Complex w = frame.bodies[k].position - images[k].position;
      BOOST_TEST(std::abs(lattice.vector(lattice.index(w)) - w) < 1e-13);
      BOOST_TEST(std::abs(lattice.nearest(images[k].position - centre)) < 1e-13);
      BOOST_TEST(std::abs(frame.bodies[k].velocity - images[k].velocity - carried(w)) < 1e-12);
      BOOST_TEST(images[k].orientation == frame.bodies[k].orientation);
    }
  }
}

// A trap pulls a body from its path, although the repulsion acts on its image in the cell.
BOOST_AUTO_TEST_CASE(traps_pull_paths) {
  Scene made = two_bodies();
  const SuspensionSolver free(made);
  const Complex centre{0.1, 0.2};
  made.bodies[0].loads.trap = Trap{2.0, centre};
  const SuspensionSolver trapped(made);
  Configuration paths = free.start().configuration;
  paths[0].position += 3.0 * a1 - a2;
  const auto force = [&](const SuspensionSolver& solver) {
    return solver.instant(paths).forcing.loads[0].force;
  };
  const Complex pull = 2.0 * (centre - paths[0].position);
  BOOST_TEST(std::abs(force(trapped) - force(free) - pull) < 1e-12);
}

// The forces and torques of the repulsion are minus the derivatives of its energy, the sum of
// strength range exp(-gap / range) over all pairs with images.
BOOST_AUTO_TEST_CASE(repulsion_has_an_energy) {
  Scene made = two_bodies();
  made.bodies[0].shape = Ellipse{1.0, 0.2};
  made.repulsion = Repulsion{0.3, 0.15};
  for (Body& each : made.bodies) each.n_nodes = 128;
  const SuspensionSolver solver(made);
  const Lattice lattice(a1, a2);
  const auto energy = [&](const Configuration& places) {
    const auto curve = [&](std::size_t k, Complex w) {
      return smooth_body(made.bodies[k].shape, 128, places[k].position + w, places[k].orientation);
    };
    double sum = 0.0;
    for (int i = -4; i <= 4; ++i) {
      for (int j = -4; j <= 4; ++j) {
        const Complex w = lattice.vector({i, j});
        const auto add = [&](std::size_t k, std::size_t l) {
          sum += 0.3 * 0.15 * std::exp(-closest_points(curve(k, 0.0), curve(l, w)).gap / 0.15);
        };
        add(0, 1);
        if (i > 0 || (i == 0 && j > 0)) {  // one of every pair of own images
          add(0, 0);
          add(1, 1);
        }
      }
    }
    return sum;
  };
  const Instant start = solver.start();
  const Configuration places = start.configuration;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto slope = [&](Complex step, double turn) {
      constexpr double h = 1e-5;
      Configuration ahead = places, behind = places;
      ahead[k].position += h * step;
      ahead[k].orientation += h * turn;
      behind[k].position -= h * step;
      behind[k].orientation -= h * turn;
      return -(energy(ahead) - energy(behind)) / (2.0 * h);
    };
    const Load& load = start.forcing.loads[k];
    BOOST_TEST(std::abs(load.force - Complex(slope(1.0, 0.0), slope(imaginary, 0.0))) < 1e-8);
    BOOST_TEST(std::abs(load.torque - slope(0.0, 1.0)) < 1e-8);
    BOOST_TEST(std::abs(load.force) > 1e-3);
  }
}

BOOST_AUTO_TEST_SUITE_END()
