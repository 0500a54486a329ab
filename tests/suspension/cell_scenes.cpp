// Solves and runs scenes with a periodic cell, with automatic nodes, and compares them with
// published values and with independent solutions.
#include "cell_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "suspension/bodies/cell.hpp"
#include "suspension/motion/describe.hpp"
#include "suspension/motion/free_steps.hpp"
#include "suspension/motion/simulation.hpp"
#include "suspension/solver/matrices.hpp"

using namespace stokesbook;
using namespace stokesbook::test;
using std::numbers::pi;

namespace {

Frame last_frame(const Scene& scene) {
  Frame last;
  const SuspensionSolver solver(scene);
  Simulation simulation(solver, {[&](const Frame& frame) { last = frame; }, {}, {}, {}});
  simulation.run();
  return last;
}

Scene timed(Scene scene, SteppingMethod method, double t_final, double dt) {
  scene.time = TimeSettings{.t_final = t_final, .dt = dt, .method = method};
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(cell_scenes)

// The drag D = F / (mu U) of held disks in a square array, U the mean velocity.
BOOST_AUTO_TEST_CASE(square_array_drag) {
  const std::pair<double, double> rows[] = {{0.05, 15.5578223189023}, {0.6, 1763.5731125198}};
  for (const auto& [area_fraction, drag] : rows) {
    Scene array =
        cell_scene({held_body(Circle{std::sqrt(area_fraction / pi)}, automatic_nodes, {0.3, -0.1})},
                   1.0, imaginary);
    array.cell->mean_velocity = 1.0;
    check(-Solved(array).solution.loads[0].force, drag);
    array.cell->mean_velocity = 0.0;
    array.cell->pressure_gradient = -1.0;
    const Solved driven(array);
    check(driven.solution.loads[0].force, -1.0, 1e-12);
    check(driven.solution.uniform_velocity * drag, 1.0);
    BOOST_TEST(driven.solution.error_estimate <= 1e-10);
  }
}

// The force of a single held body follows from the given gradient, whatever its nodes: the estimate
// is that of the mean velocity.
BOOST_AUTO_TEST_CASE(estimate_of_the_mean_velocity) {
  Scene array =
      cell_scene({held_body(Circle{std::sqrt(0.6 / pi)}, 32, 0.0)}, 1.0, imaginary, {}, 0.1);
  array.cell->pressure_gradient = -1.0;
  const Solution solution = Solved(array).solution;
  const double error =
      std::abs(solution.uniform_velocity - 1.0 / 1763.5731125198) / solution.velocity_scale;
  BOOST_TEST(error > 1e-12);
  BOOST_TEST(solution.error_estimate > 0.03 * error);
}

// One free disk per sheared cell: omega, and the stresslet; the sum of stresslets and the
// dissipation of the load-free disk agree.
BOOST_AUTO_TEST_CASE(sheared_array) {
  const Scene array =
      cell_scene({disk(std::sqrt(0.3 / pi), {0.1, -0.2})}, 1.0, {0.3, 1.0}, ShearFlow{1.0});
  const Solved solved(array);
  check(solved.solution.motions[0].omega, -0.4784535908960);
  check(solved.solution.motions[0].velocity, {-0.2, 0.0});
  const Rheology rheology = Rheometer(solved.solver)(solved.solution);
  check(rheology.stresslet, {-0.1280598791163, 0.7140916371852});
  check(rheology.dissipation, 0.7140916371852);
}

BOOST_AUTO_TEST_CASE(three_loaded_bodies) {
  Scene loaded = three_bodies();
  loaded.solver.tolerance = 1e-12;
  const Solved net(loaded);
  const std::vector<RigidMotion>& motions = net.solution.motions;
  check(motions[0].velocity, {0.38247565798551, -0.07156265243420});
  check(motions[0].omega, -0.42679767388143);
  check(motions[1].velocity, {0.34615696960301, -0.41969417595166});
  check(motions[1].omega, -0.70914623880336);
  check(motions[2].velocity, {-0.39853694849390, -0.17357522244044});
  check(motions[2].omega, -0.45172059205954);
  const ComplexVector point = ComplexVector::Zero(1);
  check(net.solver.velocity(net.solution, point)[0], {0.183373034927, -0.154671973769201});
  // The whole dissipation in the cell, by a quadrature over the area that has eight digits, without
  // that of the undisturbed flow 2 mu V E:E.
  const double undisturbed = 2.0 * 1.3 * 4.13 * 0.325;
  check(Rheometer(net.solver)(net.solution).dissipation, 5.522750567708 - undisturbed, 1e-8);
}

BOOST_AUTO_TEST_CASE(held_and_free_bodies) {
  Scene mixed = three_bodies();
  hold_disk(mixed);
  const Solved stream(mixed);
  check(stream.solution.loads[2].force, {18.6464917809842, 6.5803182049997});
  check(stream.solution.loads[2].torque, 2.3170286884095);
  check(stream.solution.motions[0].velocity, {0.08431332706598, -0.31564055738483});
  const double dissipation = Rheometer(stream.solver)(stream.solution).dissipation;
  const Complex mean = mixed.cell->mean_velocity;
  mixed.cell->mean_velocity = 0.0;
  mixed.cell->pressure_gradient = {0.5, -0.25};
  const Solved driven(mixed);
  check(driven.solution.uniform_velocity, {0.66510429030832, 0.08633742673165});
  check(driven.solution.loads[2].force, {1.365, -1.7325});
  check(driven.solution.motions[1].velocity, {0.85592229623693, -0.09983717110596});
  check(driven.solution.motions[1].omega, -0.71215579344184);
  // The gradient of the first solution brings back its mean velocity.
  const Complex total = stream.solution.loads[0].force + stream.solution.loads[1].force +
                        stream.solution.loads[2].force;
  mixed.cell->pressure_gradient = total / 4.13;
  const Solved back(mixed);
  check(back.solution.uniform_velocity, mean, 1e-8);
  check(Rheometer(back.solver)(back.solution).dissipation, dissipation, 1e-8);
}

// The flow of a solution at points of other cells; pressure rises by F.w / V along w.
BOOST_AUTO_TEST_CASE(flow_in_other_cells) {
  const Solved solved(three_bodies());
  const Complex w = Complex{2.2, 0.1} * 3.0 - Complex{0.5, 1.9} * 2.0;
  const ComplexVector here{{Complex{0.0, 0.0}, Complex{-1.0, -0.4}}}, there = here.array() + w;
  const Complex carried{0.2 * w.real() + w.imag(), -0.3 * w.real() - 0.2 * w.imag()};
  const ComplexVector u = solved.solver.velocity(solved.solution, here);
  const ComplexVector v = solved.solver.velocity(solved.solution, there);
  const auto slopes = solved.solver.derivatives(solved.solution, here);
  const auto slopes_there = solved.solver.derivatives(solved.solution, there);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    check(v[i], u[i] + carried);
    check(slopes_there[k].pressure, slopes[k].pressure + dot(Complex{1.1, -0.3}, w) / (4.13 * 1.3));
    check(slopes_there[k].vorticity, slopes[k].vorticity);
    check(slopes_there[k].strain, slopes[k].strain);
  }
}

BOOST_AUTO_TEST_CASE(a_gap_through_the_edge) {
  const Scene pair = cell_scene(
      {disk(0.2, {-0.29, 0.0}, {{1.0, -0.5}, 0.2}), disk(0.2, {0.29, 0.0}, {{-1.0, 0.5}, 0.0})},
      1.0, {0.3, 1.0}, ShearFlow{1.0});
  const Solved solved(pair);
  BOOST_TEST(solved.solution.gaps.front().points.gap == 0.02, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(solved.solution.gaps.front().shift + 1.0) < 1e-15);
  BOOST_TEST(solved.solution.discretisation[0]->resolution.n_nodes > 32);
  check(solved.solution.motions[0].velocity, {0.0024876214562, -0.0349631349210});
  check(solved.solution.motions[0].omega, -0.0743037501003);
  check(solved.solution.motions[1].omega, -0.2846656412087);
}

// The path of a body may lie in any cell.
BOOST_AUTO_TEST_CASE(bodies_moved_by_lattice_vectors) {
  const Scene given = three_bodies();
  const auto carried = [](Complex w) {
    return Complex{0.2 * w.real() + w.imag(), -0.3 * w.real() - 0.2 * w.imag()};
  };
  const Complex a1{2.2, 0.1}, a2{0.5, 1.9};
  BOOST_TEST_CONTEXT("a free body moved") {
    Scene moved = given;
    const Complex w = a1 - 2.0 * a2;
    moved.bodies[1].position += w;
    const std::vector<RigidMotion> exact = path_motions(Solved(given).solution),
                                   found = path_motions(Solved(moved).solution);
    for (std::size_t k = 0; k < 3; ++k) {
      check(found[k].velocity, exact[k].velocity + (k == 1 ? carried(w) : 0.0), 1e-11);
      check(found[k].omega, exact[k].omega, 1e-11);
    }
  }
  BOOST_TEST_CONTEXT("a held body moved") {
    Scene held = given;
    hold_disk(held);
    Scene moved = held;
    moved.bodies[2].position += a2;
    moved.bodies[2].velocity += carried(a2);
    const Solved first(held), second(moved);
    check(second.solution.loads[2].force, first.solution.loads[2].force, 1e-10);
    check(second.solution.motions[0].velocity, first.solution.motions[0].velocity, 1e-10);
  }
}

// The matrices of a cell are symmetric, and the inverse of each other.
BOOST_AUTO_TEST_CASE(matrices_in_a_cell) {
  Scene pair = two_disks();
  pair.bodies.pop_back();
  pair.solver.tolerance = 1e-9;
  pair.cell->mean_velocity = {0.3, 0.1};
  const MatrixErrors errors = matrix_errors(hydrodynamic_matrices(pair));
  BOOST_TEST(errors.resistance_asymmetry < 1e-8);
  BOOST_TEST(errors.mobility_asymmetry < 1e-8);
  BOOST_TEST(errors.inverse_error < 1e-7);
}

BOOST_AUTO_TEST_CASE(plan_of_a_cell) {
  const std::vector<std::string> lines = describe(SuspensionSolver(two_disks()));
  const auto holds = [&](const std::string& line) {
    return std::ranges::any_of(lines, [&](const std::string& l) { return l.starts_with(line); });
  };
  BOOST_TEST(holds("problem          periodic mobility problem: 2 free bodies"));
  BOOST_TEST(holds("far field        given mean velocity: a periodic cell"));
  BOOST_TEST(holds("near correction  yes: Cauchy scheme"));
  BOOST_TEST(holds("cell             area 4, reduced basis (2, 0), (0, 2); "));
  BOOST_TEST(holds("summation        fast multipole method of order "));
}

BOOST_AUTO_TEST_CASE(bodies_that_meet_images) {
  const auto error_of = [](const Scene& scene) {
    try {
      Solved{scene};
    } catch (const SolverError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  BOOST_TEST(
      error_of(cell_scene({disk(0.51, 0.0)}, 1.0, imaginary))
          .starts_with("body 0 and its own image overlap or touch: the image is moved by the "
                       "lattice vector (0, 1), and the bounding circle of the body has a "
                       "diameter of 1.02: enlarge the cell"));
  BOOST_TEST(error_of(cell_scene({disk(0.3, -0.5), disk(0.3, 0.5)}, 1.5, imaginary))
                 .starts_with("body 0 and an image of body 1 overlap"));
}

// The lattice follows the integral of the flow's factor, and its changes of sign.
BOOST_AUTO_TEST_CASE(lattice_in_time) {
  Scene made = two_disks();
  made.flow = ShearFlow{2.0};
  const auto strain = [&](double t) {
    const PeriodicCell cell = *cell_at(made, t);
    BOOST_TEST(std::abs(cell.a1 - 2.0) < 1e-15);
    BOOST_TEST(std::abs(cell.a2.imag() - 2.0) < 1e-15);
    return cell.a2.real() / 4.0;
  };
  const auto is_near = boost::test_tools::tolerance(1e-14);
  BOOST_TEST(strain(3.0) == 3.0, is_near);
  made.reverse_at = {1.0, 1.5};
  BOOST_TEST(strain(1.25) == 0.75, is_near);
  BOOST_TEST(strain(3.0) == 2.0, is_near);
  made.reverse_at = {};
  made.flow_amplitude = SteppedAmplitude{{0.0, 1.0, 2.0}, {1.0, -2.0, 0.5}};
  BOOST_TEST(strain(0.5) == 0.5, is_near);
  BOOST_TEST(strain(4.0) == 0.0);
  made.flow_amplitude = RampedAmplitude{{1.0, 3.0}, {2.0, 4.0}};
  BOOST_TEST(strain(0.5) == 1.0, is_near);
  BOOST_TEST(strain(2.0) == 2.0 + 2.5, is_near);
  BOOST_TEST(strain(4.0) == 2.0 + 6.0 + 4.0, is_near);
  made.flow_amplitude = OscillatingAmplitude{0.5, 2.0, 3.0, 0.7};
  // Simpson's rule for the integral of the factor.
  double sum = 0.0;
  constexpr int n = 1000;
  for (int k = 0; k <= n; ++k) {
    const double weight = k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    sum += weight * (0.5 + 2.0 * std::cos(2.0 * pi * (2.0 * k / n) / 3.0 + 0.7));
  }
  BOOST_TEST(strain(2.0) == sum * 2.0 / (3.0 * n), boost::test_tools::tolerance(1e-11));
  // A general gradient: a' = G a by small steps of order four.
  made.flow_amplitude = {};
  made.flow = LinearFlow{Eigen::Matrix2d{{0.2, 1.0}, {-0.7, -0.2}}};
  Eigen::Matrix2d step = Eigen::Matrix2d::Identity(), term = step;
  for (int k = 1; k < 5; ++k) {
    term *= std::get<LinearFlow>(made.flow).gradient * (1e-3 / k);
    step += term;
  }
  Eigen::Vector2d a2(0.0, 2.0);
  for (int k = 0; k < 1500; ++k) a2 = step * a2;
  BOOST_TEST(std::abs(cell_at(made, 1.5)->a2 - Complex(a2[0], a2[1])) < 1e-12);
}

// The orders of Heun's method and of the classical Runge-Kutta method do not change where bodies
// leave the cell. Errors are those against a run by a method of order 8.
BOOST_AUTO_TEST_CASE(orders_across_edges, *boost::unit_test::label("full")) {
  Scene start = two_disks();
  start.bodies[0].position += Complex{0.0, 0.6};
  start.bodies[1].position += Complex{0.0, 0.6};
  Scene accurate = start;
  accurate.time =
      TimeSettings{.t_final = 2.0, .method = SteppingMethod::prince_dormand87, .tolerance = 1e-11};
  accurate.solver.tolerance = 1e-11;
  const auto places_in = [&](const Scene& scene) {
    const Frame end = last_frame(scene);
    return ComplexVector{{end.bodies[0].position, end.bodies[1].position}};
  };
  const auto places = [&](SteppingMethod method, int steps) {
    return places_in(timed(start, method, 2.0, 2.0 / steps));
  };
  const ComplexVector exact = places_in(accurate);
  BOOST_TEST(exact[1].real() > 1.5);  // outside of the cell
  const auto order = [&](SteppingMethod method, int steps) {
    const double coarse = (places(method, steps) - exact).norm();
    const double fine = (places(method, 2 * steps) - exact).norm();
    return std::log2(coarse / fine);
  };
  BOOST_TEST(std::abs(order(SteppingMethod::heun, 20) - 2.0) < 0.2);
  BOOST_TEST(std::abs(order(SteppingMethod::rk4, 10) - 4.0) < 0.4);
}

// Two disks at t = 1, by a method of order 8 with a tolerance of 1e-13.
BOOST_AUTO_TEST_CASE(two_disks_in_time, *boost::unit_test::label("full")) {
  Scene run = two_disks();
  run.time =
      TimeSettings{.t_final = 1.0, .method = SteppingMethod::prince_dormand87, .tolerance = 1e-11};
  run.solver.tolerance = 1e-11;
  const Frame end = last_frame(run);
  check(end.bodies[0].position, {-0.52257668231, -0.19013503631});
  check(end.bodies[1].position, {0.51919155905, 0.23100115076});
  check(end.bodies[0].orientation, -0.40531414102);
  check(end.bodies[1].orientation, -0.33557138324);
  // The same disks, one of them described by an image, which moves with its lattice vector.
  run.bodies[1].position += Complex{-4.0, 2.0};
  check(last_frame(run).bodies[1].position, end.bodies[1].position + Complex{-4.0 + 2.0, 2.0});
}

// Bodies return to their start after a reversal, across the edges of the cell.
BOOST_AUTO_TEST_CASE(reversal) {
  Scene run = two_disks();
  run.bodies[1].position += Complex{0.0, 0.7};
  run.reverse_at = {0.6};
  run.time =
      TimeSettings{.t_final = 1.2, .method = SteppingMethod::dormand_prince54, .tolerance = 1e-6};
  run.solver.tolerance = 1e-7;
  const Frame end = last_frame(run);
  for (std::size_t k : {0U, 1U}) check(end.bodies[k].position, run.bodies[k].position, 1e-5);
}

// A resumed run continues bit for bit.
BOOST_AUTO_TEST_CASE(resumed_run) {
  Scene run = timed(two_disks(), SteppingMethod::heun, 1.0, 0.125);
  run.bodies[1].position += Complex{0.0, 0.7};
  run.solver.tolerance = 1e-5;
  const SuspensionSolver solver(run);
  std::vector<Checkpoint> checkpoints;
  Frame whole, resumed;
  Simulation first(solver, {[&](const Frame& frame) { whole = frame; },
                            {},
                            [&](const Checkpoint& at) { checkpoints.push_back(at); },
                            {}});
  first.run();
  Simulation second(solver, {[&](const Frame& frame) { resumed = frame; }, {}, {}, {}});
  second.resume(checkpoints[4]);
  second.run();
  BOOST_TEST(whole.t == resumed.t);
  BOOST_TEST(whole.bodies[1].position.real() > 1.0);  // outside of the cell
  for (std::size_t k : {0U, 1U}) {
    BOOST_TEST(whole.bodies[k].position == resumed.bodies[k].position);
    BOOST_TEST(whole.bodies[k].orientation == resumed.bodies[k].orientation);
    BOOST_TEST(whole.bodies[k].velocity == resumed.bodies[k].velocity);
  }
}

// A step that takes a body through an image of another one is found.
BOOST_AUTO_TEST_CASE(passing_through_an_image) {
  Scene rows = cell_scene({disk(0.3, {0.0, -0.5}), disk(0.3, {1.0, 0.5})}, 4.0, {0.0, 2.0},
                          ShearFlow{1.0}, 1e-6);
  const SuspensionSolver solver(rows);
  const PassingTest test(solver);
  const Configuration start = solver.start().configuration;
  const auto passes = [&](Complex first, double shear) {
    Configuration end = start;
    end[0].position += first;
    const Lattice before(4.0, {0.0, 2.0}), after(4.0, {2.0 * shear, 2.0});
    return test.describe_passing(start, end, 0.1, LatticeStep{before, after});
  };
  BOOST_TEST(passes({0.1, 0.0}, 0.05) == "");
  // Disk 0 moves down through the image of disk 1 at (1, -1.5).
  BOOST_TEST(passes({2.0, -2.0}, 0.0).starts_with("body 0 and an image of body 1 overlap or pass"));
  // The same motion is free if a shear moves the image to (3, -1.5).
  BOOST_TEST(passes({2.0, -2.0}, -1.0) == "");
}

BOOST_AUTO_TEST_SUITE_END()
