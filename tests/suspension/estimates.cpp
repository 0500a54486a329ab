// Tests the error estimate on random scenes with as few nodes as the solver accepts: the estimate
// is at least three tenths and at most ten times the true error. Tests the cost of estimates, and
// of solves that they cause.

#include "scenes.hpp"
#include "support/recorded_run.hpp"
#include "support/touching.hpp"
#include "support/vectors.hpp"
#include "suspension/nodes/node_choice.hpp"

namespace stokesbook::test {
namespace {

// Moves the last body of a scene along a direction until its gap to the nearest other body has the
// given value.
void move_to_gap(Scene& scene, Complex direction, double gap) {
  Scene probe = scene;
  probe.solver.near_singular = NearSingular::off;
  probe.solver.preconditioner = PreconditionerKind::none;
  const SuspensionSolver solver(probe);
  Configuration places = solver.start().configuration;
  const auto is_too_close = [&](double distance) {
    places.back().position = distance * direction;
    return find_gaps(places, solver.discretisation(), 1e-3).front().points.gap < gap;
  };
  double low = 0.0, high = 8.0;
  for (int bisection = 0; bisection < 45; ++bisection) {
    const double middle = 0.5 * (low + high);
    (is_too_close(middle) ? low : high) = middle;
  }
  scene.bodies.back().position = high * direction;
}

// Returns two or three bodies at gaps from 1 down to 1e-2, in shear, or loaded within a gauge
// length.
Scene random_neighbours(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto random_shape = [&]() -> Shape {
    const std::vector<Shape> shapes{
        Circle{0.5 + 0.5 * uniform(random)}, Ellipse{1, 1 / (1 + 3 * uniform(random))},
        Star{0.8, 0.1 + 0.1 * uniform(random), 3}, Superellipse{1, 0.7, 4}, lopsided_curve()};
    return shapes[random() % shapes.size()];
  };
  const bool loaded = random() % 2 == 0;
  Scene result = loaded ? with_gauge(scene({}), 20.0) : scene({}, ShearFlow{1});
  const std::size_t count = 2 + random() % 2;
  for (std::size_t k = 0; k < count; ++k) {
    const Load load = loaded ? random_load(random) : Load{};
    result.bodies.push_back(body(random_shape(), 96, 0.0, 6 * uniform(random), load));
    const double angle = 2.0 * static_cast<double>(k) + uniform(random);
    if (k > 0) move_to_gap(result, std::polar(1.0, angle), std::pow(10, -2 * uniform(random)));
  }
  return result;
}

// Returns the solution with the fewest nodes, the same number >= at_least for all bodies, for which
// the solver accepts a scene.
Solved accepted(const Scene& scene, int at_least) {
  for (int n = at_least;; n += n < 64 ? 8 : 16) {
    try {
      return Solved(with_nodes(scene, n));
    } catch (const SolverError&) {
      BOOST_REQUIRE(n < 1000);
    }
  }
}

// Returns the error of the motions of a solution, relative to its velocity scale.
double error_of(const Solved& answer, const Solved& truth) {
  const Solution& solution = answer.solution;
  double error = 0.0;
  for (std::size_t k = 0; k < answer.solver.scene().bodies.size(); ++k) {
    const double a = solution.discretisation[k]->gyration_radius;
    error = std::max(error, distance(answer.motion(k), truth.motion(k), a));
  }
  return error / solution.velocity_scale;
}

// Compares the estimate of a solution with its error.
void check_estimate(const Solved& answer) {
  Scene accurate = answer.solver.scene();
  accurate.solver.tolerance *= 1e-3;
  const double error = error_of(answer, Solved(accurate)),
               estimate = answer.solution.error_estimate;
  BOOST_TEST(estimate >= error);
  BOOST_TEST(estimate <= 10.0 * error);
}

void check_estimates(int trials) {
  std::mt19937_64 random(61);
  for (int trial = 0; trial < trials; ++trial) {
    Scene coarse = random_neighbours(random);
    coarse.solver.tolerance = std::pow(10, -3 - 2 * (trial % 3));
    const Solved answer = accepted(coarse, 16);
    Scene fine = coarse;
    fine.solver.tolerance = std::max(1e-12, 1e-4 * coarse.solver.tolerance);
    const int nodes = answer.solver.scene().bodies[0].n_nodes;
    const double error = error_of(answer, accepted(fine, 3 * nodes));
    const double estimate = answer.solution.error_estimate;
    BOOST_TEST_CONTEXT("trial " << trial << ", " << nodes << " nodes, error " << error
                                << ", estimate " << estimate) {
      BOOST_TEST(estimate >= 0.3 * error);
      BOOST_TEST(estimate <= 10.0 * error);
      BOOST_TEST(error <= coarse.solver.tolerance);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(estimates)

BOOST_AUTO_TEST_CASE(what_a_gap_asks_for_does_not_depend_on_the_order_of_its_curves) {
  const SuspensionSolver solver(
      scene({body(Ellipse{1, 0.4}, 64, {}, 0.3), body(Circle{0.5}, 64, {0.2, 1.1})}, ShearFlow{1}));
  const Configuration places = solver.start().configuration;
  const Gap gap = find_gaps(places, solver.discretisation(), 1e-3).front();
  const ClosestPoints& p = gap.points;
  const Gap turned{gap.b, gap.a, {p.gap, p.parameter_b, p.parameter_a, p.point_b, p.point_a}};
  const GapResolution one = gap_resolution(gap, places, solver.discretisation()),
                      other = gap_resolution(turned, places, solver.discretisation());
  BOOST_TEST(one.decay.a == other.decay.b, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(one.decay.b == other.decay.a, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(one.error == other.error, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(std::abs(one.decay.a - one.decay.b) > 0.01);
}

BOOST_AUTO_TEST_CASE(are_honest) {
  check_estimates(6);
}

BOOST_AUTO_TEST_CASE(are_honest_in_many_scenes, *boost::unit_test::label("full")) {
  check_estimates(48);
}

// The products of an estimate are fewer than those of the solve, and the estimate is still right.
BOOST_AUTO_TEST_CASE(cost_little_with_a_tree) {
  const Scene scene =
      with_preconditioner(loaded_packing(40, 0.5), PreconditionerKind::hierarchical);
  const Solved answer(scene);
  const Solution& solution = answer.solution;
  BOOST_TEST(solution.cost.matvecs <= 2 * solution.gmres.applications);
  check_estimate(answer);
}

// A direct solution leaves far less residual than its tolerance allows. For the estimate, what the
// tolerance allows is small enough.
BOOST_AUTO_TEST_CASE(cost_little_with_a_direct_solution) {
  for (const double gap : {0.02, 0.002}) {
    const Solved answer(
        with_preconditioner(settling_in_container(1.3, 6, 0.3, gap), PreconditionerKind::direct));
    BOOST_TEST(answer.solution.cost.matvecs <= 20);
    check_estimate(answer);
  }
}

// The error of the first solve is that of GMRES: the next solve begins with the corrected density.
BOOST_AUTO_TEST_CASE(give_the_next_solve_its_guess) {
  const Scene scene = with_preconditioner(settling_in_container(4.0, 40, 0.3, 0.02),
                                          PreconditionerKind::block_diagonal);
  const Solution solution = Solved(scene).solution;
  const int before = solution.cost.gmres_iterations - solution.gmres.iterations;
  BOOST_TEST(before > 0);
  BOOST_TEST(5 * solution.gmres.iterations < before);
}

// Without bodies there are no motions to compare: the estimate compares the densities.
BOOST_AUTO_TEST_CASE(a_container_without_bodies_has_one) {
  const LinearWall strained{Eigen::Matrix2d{{0.0, 1.0}, {1.0, 0.0}}};
  Scene empty = scene({}, {}, {outer_wall(Ellipse{4.0, 1.0}, 48, strained)});
  empty.solver.tolerance = 1e-2;
  const double coarse = Solved(empty).solution.error_estimate;
  empty.walls[0].n_nodes = 96;
  const double fine = Solved(empty).solution.error_estimate;
  BOOST_TEST(coarse > 1e-14);
  BOOST_TEST(fine < 0.01 * coarse);
}

// A component whose density is zero up to rounding errors has no tail.
BOOST_AUTO_TEST_CASE(rounding_errors_have_no_tail) {
  std::mt19937_64 random(62);
  std::normal_distribution<double> normal(0, 1e-15);
  const ComplexVector noise = ComplexVector::NullaryExpr(96, [&] {
    return Complex{normal(random), normal(random)};
  });
  BOOST_TEST(tail_estimate(noise, 1.0).error < 1e-12);
}

// The fewest nodes of a scene resolve almost nothing, and the estimate must show this.
BOOST_AUTO_TEST_CASE(few_nodes_have_a_tail) {
  for (const Eigen::Index n : {8, 10, 12}) {
    BOOST_TEST(tail_estimate(random_vector(n, 63), 1.0).error > 1.0);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
