// Compares error estimates with errors, on random scenes with random nodes, and tests that the
// solver accepts no solution whose error exceeds the tolerance.
#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments.hpp"
#include "scenes.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/nodes/node_choice.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

// Error and estimates of one solution.
struct JudgedSolution {
  double error;      // difference from a solution for a tolerance of 1e-12 on graded nodes
  double estimate;   // by a correction on finer nodes
  double tail;       // by the tails of its densities
  double iteration;  // ten times the residual of GMRES
};

double largest_tail(const Solved& solved) {
  const ComplexVector rest = solved.discrete.system.closure().without_rigid_part(solved.density);
  const std::vector<Eigen::Index>& offsets = solved.discrete.system.offsets();
  double largest = 0.0;
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
    const auto own = rest.segment(offsets[k], offsets[k + 1] - offsets[k]);
    largest = std::max(largest, tail_estimate(own, solved.scale).error);
  }
  return largest;
}

// Computes the reference solution. It starts from the nodes with which the solver would begin at
// the tolerance 1e-12 (graded at narrow gaps), and refines these nodes twice, which
// makes them about 1.5 times as many.
Completion reference_of(Scene scene) {
  scene = with_nodes(std::move(scene), automatic_nodes, automatic_nodes);
  scene.solver.tolerance = 1e-12;
  const SuspensionSolver solver(scene);
  const Configuration start = solver.start().configuration;
  const Resolutions first = solver.first_resolutions(start, solver.gaps(start));
  return solved_at(solver, refine(refine(first)), 1e-14).completion;
}

// Moves half of the unbounded scenes up to a thousand lengths away from the centre of their flow.
void move_away(Scene& scene, std::mt19937_64& random) {
  const Complex way = std::polar(log_uniform(random, 1.0, 1e3), uniform(random, 0.0, 6.28));
  if (!scene.walls.empty() || random() % 2 == 0) return;
  for (Body& body : scene.bodies) body.position += way;
}

JudgedSolution judge(std::mt19937_64& random, int most_nodes) {
  Scene scene = random_scene(random);
  move_away(scene, random);
  scene.solver.preconditioner = PreconditionerKind::none;
  const SuspensionSolver solver(scene);
  Resolutions resolutions = resolutions_of(solver.discretisation());
  const double most = static_cast<double>(most_nodes) / static_cast<double>(resolutions.size());
  const double share = uniform(random, 0.3, 1.0);
  for (Resolution& resolution : resolutions) {
    const double nodes = std::max(16.0, share * most * uniform(random, 0.8, 1.0));
    resolution.n_nodes = 2 * static_cast<int>(0.5 * nodes);
  }
  // For half of the solutions, GMRES leaves nearly no error.
  const double loose = std::pow(10.0, -uniform(random, 4.0, 12.0));
  const Solved answer = solved_at(solver, resolutions, random() % 2 == 0 ? 1e-14 : loose);
  const Solved fine = solved_at(solver, refine(resolutions), 0.5);
  const Completion reference = reference_of(scene);
  return {error(answer, reference),
          estimate_error(answer.discrete, answer.density, answer.gmres.residual, fine.discrete,
                         answer.scale)
              .error,
          largest_tail(answer), 10.0 * answer.gmres.residual};
}

// Returns whether rounding errors do not dominate, and the nodes resolve the densities at least
// roughly.
bool is_in_range(const JudgedSolution& judged) {
  return judged.error >= 1e-11 && judged.error <= 1e-2;
}

const std::vector<JudgedSolution>& judged(Size size) {
  const auto judge_all = [](int count, int most_nodes) {
    std::mt19937_64 random(12);
    std::vector<JudgedSolution> found;
    while (static_cast<int>(found.size()) < count) {
      try {
        const JudgedSolution one = judge(random, most_nodes);
        if (is_in_range(one)) found.push_back(one);
      } catch (const SolverError&) {
        // GMRES breaks down because rounding errors dominate. The solver rejects such a scene.
      }
    }
    return found;
  };
  static const std::vector<JudgedSolution> quick = judge_all(40, 160);
  if (size == Size::quick) return quick;
  static const std::vector<JudgedSolution> full = judge_all(200, 600);
  return full;
}

using EstimateKind = double JudgedSolution::*;

Measure spread(EstimateKind estimate) {
  return [=](Size size) {
    std::vector<double> orders;
    for (const JudgedSolution& one : judged(size)) {
      orders.push_back(std::abs(std::log10(one.error / one.*estimate)));
    }
    std::ranges::sort(orders);
    std::vector<Measurement> quantiles;
    for (const int percent : {25, 50, 75, 90, 95}) {
      const std::size_t rank = (orders.size() * static_cast<std::size_t>(percent) + 99) / 100;
      quantiles.push_back({.x = static_cast<double>(percent), .error = orders[rank - 1]});
    }
    return quantiles;
  };
}

Measure errors_over(EstimateKind estimate) {
  return [=](Size size) {
    std::vector<Measurement> points;
    for (const JudgedSolution& one : judged(size)) {
      points.push_back({.x = one.*estimate, .error = one.error});
    }
    std::ranges::sort(points, {}, &Measurement::x);
    return points;
  };
}

// Results for a scene of hard shapes. The reference solution has automatic nodes for a hundredth of
// the scene's tolerance.
struct JudgedScene {
  double tolerance;
  std::optional<double> accepted;  // error of the accepted solution, if the solver accepts one
  double unestimated;              // error on the nodes with which the solver begins
};

JudgedScene judge_hard_scene(const Scene& scene) {
  Scene closer = with_nodes(scene, automatic_nodes, automatic_nodes);
  closer.solver.tolerance = std::max(1e-9, 1e-2 * scene.solver.tolerance);
  const SuspensionSolver solver(scene), reference(closer);
  const Instant start = reference.start();
  const Solution right = reference.solve(start);
  const auto error_of = [&](const Solution& found) {
    const StokesProblem problem = solver.problem(start, found.discretisation);
    return *relative_change(problem, {found.motions, found.loads, found.uniform_velocity},
                            {right.motions, right.loads, right.uniform_velocity},
                            found.velocity_scale);
  };
  JudgedScene judged{scene.solver.tolerance, {}, error_of(solver.solve_nearby(start, {}))};
  try {
    judged.accepted = error_of(solver.solve(start));
  } catch (const SolverError&) {
    // The given nodes do not suffice.
  }
  return judged;
}

const std::vector<JudgedScene>& judged_hard_scenes(Size size) {
  const auto judge_all = [](int count, double slenderest, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<JudgedScene> found;
    for (int k = 0; k < count; ++k) {
      const Scene scene = hard_scene(random, slenderest);
      try {
        found.push_back(judge_hard_scene(scene));
      } catch (const SolverError&) {
        // The nodes are far too few, or bodies overlap, or rounding errors dominate.
      }
    }
    return found;
  };
  static const std::vector<JudgedScene> quick = judge_all(6, 0.05, 3);
  if (size == Size::quick) return quick;
  static const std::vector<JudgedScene> full = judge_all(4000, 0.01, 125);
  return full;
}

Measure errors_of_hard_scenes(bool estimated) {
  return [=](Size size) {
    std::vector<Measurement> points;
    for (const JudgedScene& one : judged_hard_scenes(size)) {
      if (estimated && !one.accepted) continue;
      points.push_back({.x = one.tolerance, .error = estimated ? *one.accepted : one.unestimated});
    }
    std::ranges::sort(points, {}, &Measurement::x);
    return points;
  };
}

}  // namespace

Experiment hard_shapes() {
  return left_to_full(
      {.key = "hard_shapes",
       .title = "Slender, lobed and angular bodies: errors of accepted solutions",
       .x = "tolerance ε",
       .error = "error of motions and loads, relative to the largest",
       .lines = {
           {.key = "accepted",
            .label = "accepted by the solver",
            .measure = errors_of_hard_scenes(true),
            .claim = Claim{.id = "12_59",
                           .statement = "No solution is accepted whose error is more than "
                                        "twice the tolerance.",
                           .law = ErrorBelowTolerance{2.0, 0.0},
                           .reason = "estimates are made on nodes that resolve the "
                                     "softest mode of each body; twice, because they are "
                                     "estimates",
                           .api = {"stokesbook::estimate_error", "stokesbook::softest_mode_error"}},
            .control = Control{"no estimates", errors_of_hard_scenes(false)}}}});
}

Experiment spread_of_estimates() {
  return {
      .key = "spread",
      .title = "How far estimates are from errors",
      .x = "percent of the scenes p",
      .error = "orders of magnitude between error and estimate, at most",
      .lines = {
          {.key = "correction",
           .label = "by a correction on finer nodes",
           .measure = spread(&JudgedSolution::estimate),
           .claim = Claim{.id = "12_1",
                          .statement = "Error and estimate are within a factor 10 of each "
                                       "other in 95 of 100 random scenes.",
                          .law = AtMost{1.0},
                          .reason = "the requirement on the estimate",
                          .api = {"stokesbook::estimate_error"}},
           .control = Control{"estimates by the densities' tails", spread(&JudgedSolution::tail)}},
          {.key = "tail",
           .label = "by the densities' tails",
           .measure = spread(&JudgedSolution::tail)}}};
}

Experiment estimates() {
  return {
      .key = "estimates",
      .title = "Errors and their estimates",
      .x = "estimate e",
      .error = "error of motions and loads, relative to the largest",
      .lines = {
          {.key = "correction",
           .label = "by a correction on finer nodes",
           .measure = errors_over(&JudgedSolution::estimate),
           .claim =
               Claim{.id = "12_2",
                     .statement = "No error is more than 30 times as large as its estimate.",
                     .law = ErrorBelowTolerance{30.0, 1e-2},
                     .reason = "the requirement on the estimate; an error is at least a hundredth "
                               "of its estimate, so that estimates raise no false alarms",
                     .api = {"stokesbook::estimate_error"}},
           .control = Control{"estimates by the residual of the iteration alone",
                              errors_over(&JudgedSolution::iteration)}}}};
}

}  // namespace stokesbook::verification::suspension
