// Tests that the fast sum (chapter 08) equals the direct sum to its tolerance: in the operator and
// its right-hand side for every kind of problem and in units of any size, in flows away from the
// nodes, and in the motions and loads of every shipped scene.

#include <filesystem>

#include "scene/parse.hpp"
#include "suspension/nodes/random_fill.hpp"
#include "suspension/random_scenes.hpp"
#include "suspension/solver/fields.hpp"
#include "suspension/system/error_estimate.hpp"

namespace stokesbook::test {
namespace {

SuspensionOperator operator_by(Summation summation, const SuspensionSolver& solver,
                               double tolerance) {
  Plan plan = solver.plan();
  plan.summation = summation;
  plan.sum_tolerance = tolerance;
  return {solver.problem(solver.start(), solver.discretisation()), {}, plan};
}

double relative_difference(const ComplexVector& a, const ComplexVector& b) {
  return (a - b).norm() / b.norm();
}

void check_operators(const Scene& scene) {
  const SuspensionSolver solver(scene);
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    const SuspensionOperator direct = operator_by(Summation::direct, solver, tolerance);
    const SuspensionOperator fast = operator_by(Summation::fmm, solver, tolerance);
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const ComplexVector density =
        ComplexVector::NullaryExpr(direct.offsets().back(), [&](Eigen::Index) {
          return Complex{normal(random), normal(random)};
        });
    BOOST_TEST_CONTEXT("tolerance " << tolerance) {
      BOOST_TEST(relative_difference(fast(density), direct(density)) < tolerance);
      BOOST_TEST(relative_difference(fast.right_hand_side(), direct.right_hand_side()) < tolerance);
    }
  }
}

void check_shipped_scene(const std::filesystem::path& path) {
  BOOST_TEST_CONTEXT(path.filename()) {
    const auto solved_by = [&](Summation summation) {
      Scene scene = place_fills(read_scene(path));
      scene.solver.summation = summation;
      return Solved(scene);
    };
    const Solved direct = solved_by(Summation::direct), fast = solved_by(Summation::fmm);
    const StokesProblem problem =
        direct.solver.problem(direct.solution.instant, direct.solution.discretisation);
    const auto completion = [](const Solution& solution) {
      return Completion{solution.motions, solution.loads, solution.uniform_velocity};
    };
    const std::optional<double> change =
        relative_change(problem, completion(fast.solution), completion(direct.solution),
                        direct.solution.velocity_scale);
    BOOST_REQUIRE(change.has_value());
    BOOST_TEST(*change < direct.solver.scene().solver.tolerance);
    // Few nodes fit into a single box, where both sums are the same.
    if (direct.solution.density.size() > 1000) BOOST_TEST(*change > 0.0);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fast_sums)

BOOST_AUTO_TEST_CASE(operators) {
  Eigen::Matrix2d shear;
  shear << 0, 1, 0, 0;
  for (const double length : {1e-6, 1.0, 1e6}) {
    BOOST_TEST_CONTEXT("length " << length) {
      const Scene loaded = mixed_bodies(3, length, LinearFlow{shear});
      check_operators(loaded);
      check_operators(with_gauge(loaded, 30.0 * length));
      Scene held = loaded;  // a free uniform velocity makes the forces balance
      for (const std::size_t k : {0U, 2U}) {
        held.bodies[k] = held_body(held.bodies[k].shape, held.bodies[k].n_nodes,
                                   held.bodies[k].position, 0.0, {{0.3 * length, length}, 0.7});
      }
      held.viscosity = 1.7;
      check_operators(held);
      check_operators(contained_bodies(4, length));
    }
  }
}

// Compares velocities and their derivatives in the fluid, next to bodies and at a distance.
BOOST_AUTO_TEST_CASE(flows) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-4.5, 4.5);
  for (Scene scene : {with_gauge(mixed_bodies(3), 30.0), contained_bodies(4)}) {
    scene.viscosity = 1.7;
    scene.solver.tolerance = 1e-8;
    const auto solver_by = [&](Summation summation) {
      scene.solver.summation = summation;
      return SuspensionSolver(scene);
    };
    const SuspensionSolver direct = solver_by(Summation::direct), fast = solver_by(Summation::fmm);
    const Instant start = direct.start();
    const Solution solution = direct.solve(start);
    const ComplexVector any = ComplexVector::NullaryExpr(600, [&](Eigen::Index) {
      return Complex{uniform(random), uniform(random)};
    });
    const std::vector<std::uint8_t> outside =
        in_fluid(start.configuration, direct.discretisation(), any);
    std::vector<Eigen::Index> fluid;
    for (Eigen::Index i = 0; i < any.size(); ++i) {
      if (outside[static_cast<std::size_t>(i)] == 1) fluid.push_back(i);
    }
    const ComplexVector points = any(fluid);
    const double tolerance = direct.plan().sum_tolerance;
    BOOST_TEST(relative_difference(fast.velocity(solution, points),
                                   direct.velocity(solution, points)) < tolerance);
    const auto as_vector = [](const std::vector<FlowDerivatives>& flow) {
      ComplexVector all(2 * static_cast<Eigen::Index>(flow.size()));
      for (std::size_t i = 0; i < flow.size(); ++i) {
        const auto k = 2 * static_cast<Eigen::Index>(i);
        all.segment(k, 2) << Complex{flow[i].pressure, flow[i].vorticity}, flow[i].strain;
      }
      return all;
    };
    const ComplexVector by_pairs = as_vector(direct.derivatives(solution, points));
    const ComplexVector by_expansions = as_vector(fast.derivatives(solution, points));
    BOOST_TEST(relative_difference(by_expansions, by_pairs) < 100.0 * tolerance);
    BOOST_TEST(relative_difference(by_expansions, by_pairs) > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(some_scenes_that_ship) {
  for (const char* name : {"couette.toml", "settling.toml", "rotors.toml", "lobed_row.toml"}) {
    check_shipped_scene(std::filesystem::path(STOKESBOOK_SCENES) / name);
  }
}

BOOST_AUTO_TEST_CASE(all_scenes_that_ship, *boost::unit_test::label("full")) {
  for (const auto& entry : std::filesystem::directory_iterator(STOKESBOOK_SCENES)) {
    if (entry.path().extension() == ".toml") check_shipped_scene(entry.path());
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
