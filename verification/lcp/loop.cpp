// Tests the nonlinear contact loop (11.9): a point and a disk, points in a row, a rod on a floor.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "support/dense.hpp"
#include "variants.hpp"

namespace stokesbook::verification::lcp {

using namespace study;
using namespace test;

namespace {

const VectorXd start = vector2(1.2, -0.5);
constexpr double closed =
    1e-11;  // largest accepted gap across which a force acts, relative to the separation 0.01

MatrixXd slanted_mobility() {
  return matrix2(1.0, 0.6, 0.6, 1.0);
}

VectorXd on_the_disk(double angle) {
  return vector2(std::cos(angle), std::sin(angle));
}

VectorXd free_end(double p) {
  return (1.0 - p) * on_the_disk(0.6);
}

// Returns a step in which the free motion of the point ends at the depth p in the disk. A contact
// force also moves the point sideways.
ContactStep into_the_disk(double p) {
  ContactStep step = point_and_disk(start, free_end(p) - start, 1.0);
  step.tolerance = 1e-15;
  step.respond = [](const Eigen::SparseMatrix<double>& forces) -> MatrixXd {
    return slanted_mobility() * forces;
  };
  return step;
}

// Returns the exact solution by bisection. The path from the free end to the exact end has the
// direction of B n, and n is the normal at the exact end.
VectorXd resting(double p) {
  const auto turn = [&](double angle) {
    const VectorXd way = on_the_disk(angle) - free_end(p),
                   response = slanted_mobility() * on_the_disk(angle);
    return way[0] * response[1] - way[1] * response[0];
  };
  double low = 0.6, high = 1.6;
  for (int bisection = 0; bisection < 60; ++bisection) {
    const double middle = 0.5 * (low + high);
    (turn(middle) > 0.0 ? low : high) = middle;
  }
  return on_the_disk(low) - start;
}

// Returns the exact solution if the force keeps its direction of the start.
VectorXd resting_directed(double p) {
  const VectorXd way = slanted_mobility() * start.normalized();
  const double half = free_end(p).dot(way), depth = 1.0 - free_end(p).squaredNorm();
  const double force = depth / (half + std::sqrt(half * half + way.squaredNorm() * depth));
  return free_end(p) + force * way - start;
}

// Returns the result after the given number of linear problems. Open gaps are accepted only at the
// end.
ContactResult after(int iterations, const ContactStep& step) {
  return resolve_contact(
      step, {.max_iterations = iterations, .open_gap_after = iterations, .open_gap = closed});
}

using Change = void (*)(ContactRows& rows);

// Returns the step with its rows changed by a function.
ContactStep changed(ContactStep step, Change change) {
  step.rows = [rows = step.rows, change](const VectorXd& velocity) {
    ContactRows result = rows(velocity);
    change(result);
    return result;
  };
  return step;
}

GapGradient normal_at_start() {
  return MatrixXd(start.normalized().transpose()).sparseView();
}

// Returns the step with the gap's gradient at the start instead of the gap's gradient at the end.
ContactStep frozen(const ContactStep& step) {
  return changed(step, [](ContactRows& rows) { rows.gradient = normal_at_start(); });
}

// Returns the step with forces that keep their direction of the start. The gap's gradient is taken
// at the end.
ContactStep directed(const ContactStep& step) {
  return changed(step, [](ContactRows& rows) { rows.force_gradient = normal_at_start(); });
}

// Returns the step with both the direction of the forces and the gap's gradient at the start.
ContactStep directed_and_frozen(const ContactStep& step) {
  return changed(step, [](ContactRows& rows) {
    rows.force_gradient = normal_at_start();
    rows.gradient = normal_at_start();
  });
}

// Returns the error of the velocity after k linear problems.
double error(int k, double p) {
  return largest(after(k, into_the_disk(p)).velocity - resting(p));
}

double error_frozen(int k, double p) {
  return largest(after(k, frozen(into_the_disk(p))).velocity - resting(p));
}

double error_directed(int k, double p) {
  return largest(after(k, directed(into_the_disk(p))).velocity - resting_directed(p));
}

double error_directed_and_frozen(int k, double p) {
  return largest(after(k, directed_and_frozen(into_the_disk(p))).velocity - resting_directed(p));
}

double error_of_increments(int k, double p) {
  return largest(increments(into_the_disk(p), k).velocity - resting(p));
}

Measure over_depths(double (*residual)(double p)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double ratio = size == Size::full ? std::sqrt(2.0) : 2.0;
    for (double p = 0.4 / 64.0; p < 0.5; p *= ratio) {
      measurements.push_back({.x = p, .error = residual(p)});
    }
    return measurements;
  };
}

Measure over_iterations(double (*residual)(int iterations)) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (int k = 1; k <= 5; ++k) {
      measurements.push_back({.x = static_cast<double>(k), .error = residual(k)});
    }
    return measurements;
  };
}

constexpr double deep = 0.4;

// Measures the largest error in twenty random scenes of n points in a row.
Measure over_rows(double (*error)(Index n, unsigned seed)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index n = 4; n <= (size == Size::full ? 12 : 8); n += 2) {
      double worst = 0.0;
      for (unsigned seed = 1; seed <= 20; ++seed) worst = std::max(worst, error(n, seed));
      measurements.push_back({.x = static_cast<double>(n), .error = worst});
    }
    return measurements;
  };
}

MatrixXd mobility_of(Index n, unsigned seed) {
  return definite_matrix(n, seed) + MatrixXd::Identity(n, n);
}

ContactStep random_row(Index n, unsigned seed) {
  return row_of_points(normal_matrix(n, 1, seed), 1.0, mobility_of(n, seed));
}

double power_given(Index n, unsigned seed) {
  const ContactResult result = resolve_contact(random_row(n, seed));
  return std::max(0.0, result.power) / (1.0 + result.force.norm() * result.velocity.norm());
}

// Returns the power, if it is positive, of forces that keep neighbours at a fixed distance. These
// forces can have either sign. The power is divided by 1 + |force| |velocity|.
double power_of_rods(Index n, unsigned seed) {
  MatrixXd gradient = MatrixXd::Zero(n - 1, n);
  for (Index i = 0; i + 1 < n; ++i) gradient.row(i).segment(i, 2) << -1.0, 1.0;
  const MatrixXd mobility = mobility_of(n, seed);
  const VectorXd free = normal_matrix(n, 1, seed);
  const VectorXd gap = VectorXd::Constant(n - 1, 0.1) + gradient * free;
  const VectorXd force =
      gradient.transpose() * test::solve(gradient * mobility * gradient.transpose(), -gap);
  const VectorXd velocity = free + mobility * force;
  return std::max(0.0, force.dot(velocity)) / (1.0 + force.norm() * velocity.norm());
}

// Returns the largest difference between the velocities of two solvers.
double disagreement(Index n, unsigned seed) {
  const ContactStep step = random_row(n, seed);
  return largest(resolve_contact(step).velocity -
                 resolve_contact(step, {.solver = fischer_newton}).velocity);
}

// Returns the same difference with a planted defect: in the problem of one solver, a force moves
// only its own point.
double disagreement_without_coupling(Index n, unsigned seed) {
  const MatrixXd own = mobility_of(n, seed).diagonal().asDiagonal();
  const ContactStep uncoupled = row_of_points(normal_matrix(n, 1, seed), 1.0, own);
  return largest(resolve_contact(random_row(n, seed)).velocity -
                 resolve_contact(uncoupled, {.solver = fischer_newton}).velocity);
}

double disagreement_of_multipliers(Index n, unsigned seed) {
  const ContactStep step = random_row(n, seed);
  const ContactResult pivoted = resolve_contact(step),
                      newton = resolve_contact(step, {.solver = fischer_newton});
  return pivoted.multipliers.size() == 0 ? 0.0 : largest(pivoted.multipliers - newton.multipliers);
}

Measure over_rotations(int restore_rows_after) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double r = 0.1; r < 0.95; r += size == Size::full ? 0.1 : 0.2) {
      const ContactResult result =
          resolve_contact(rod(vector2(-1.0, r)), {.restore_rows_after = restore_rows_after});
      measurements.push_back({.x = r,
                              .error = largest(result.velocity),
                              .operations = static_cast<double>(result.iterations)});
    }
    return measurements;
  };
}

// Returns a step with two gaps in conflict. The first gap requires U <= 1. The second gap is
// 0.1 - 3 U + 1.2 U^2 and, linearised at U*, requires U > 1. Both gaps are open at U = 0.
ContactStep at_odds(double free) {
  ContactStep step = step_of(
      VectorXd::Constant(1, free), 1.0, MatrixXd::Identity(1, 1), [](const VectorXd& velocity) {
        const double u = velocity[0];
        RowBuilder builder(1);
        builder.add({0, 0}, 1.0 - u, VectorXd::Constant(1, -1.0));
        builder.add({1, 0}, 0.1 - 3.0 * u + 1.2 * u * u, VectorXd::Constant(1, 2.4 * u - 3.0));
        return builder.rows();
      });
  step.tolerance = 1e-12;
  return step;
}

LcpResult without_rays(const LcpProblem& problem, const LcpOptions& options) {
  LcpResult result = lemke(problem, options);
  if (result.status == LcpStatus::ray) result.status = LcpStatus::stalled;
  return result;
}

Measure over_free_velocities(const LcpSolver& solver) {
  return [=](Size size) {
    const double exact = (3.0 - std::sqrt(9.0 - 0.48)) / 2.4;
    std::vector<Measurement> measurements;
    for (double free = 1.6; free < 2.41; free += size == Size::full ? 0.1 : 0.2) {
      const ContactResult result = resolve_contact(
          at_odds(free), {.open_gap_after = 8, .open_gap = closed, .solver = solver});
      measurements.push_back({.x = free, .error = std::abs(result.velocity[0] - exact)});
    }
    return measurements;
  };
}

// Returns a line with a claim about an order in the depth. The control uses a wrong gradient.
Line order_line(const std::string& key, const std::string& label, double (*residual)(double p),
                Claim claim, double (*defective)(double p)) {
  claim.window = {.to = 0.15, .floor = 1e-15};
  claim.api = {"stokesbook::resolve_contact"};
  return {
      .key = key,
      .label = label,
      .measure = over_depths(residual),
      .claim = claim,
      .control = Control{"the gap's gradient at the start of the step", over_depths(defective)}};
}

}  // namespace

Experiment depths() {
  return {
      .key = "depths",
      .title = "A point driven into a disk: errors after one and two linear problems",
      .x = "depth of the free end p",
      .error = "error of the velocity",
      .lines = {order_line(
                    "one", "one problem", [](double p) { return error(1, p); },
                    {.id = "11_13",
                     .statement = "One linear problem leaves an error of order two in the depth.",
                     .law = Algebraic{-2.0, 0.15},
                     .reason = "the normal turns by p while the point moves by p, and the force "
                               "is that of the first normal"},
                    [](double p) { return error_frozen(1, p); }),
                order_line(
                    "two", "two problems", [](double p) { return error(2, p); },
                    {.id = "11_14",
                     .statement = "A second problem gains one order: it multiplies the error by "
                                  "something in proportion to the depth.",
                     .law = Algebraic{-3.0, 0.15},
                     .reason = "the force turns with the normal, by its size times the "
                               "curvature, and the linear problem leaves that out"},
                    [](double p) { return error_frozen(2, p); }),
                order_line(
                    "two_directed", "two problems, the force's direction fixed",
                    [](double p) { return error_directed(2, p); },
                    {.id = "11_15",
                     .statement = "If the force keeps its direction, a second problem squares the "
                                  "error.",
                     .law = Algebraic{-4.0, 0.15},
                     .reason = "nothing is left out: this is Newton's method"},
                    [](double p) { return error_directed_and_frozen(2, p); })}};
}

Experiment totals() {
  return {
      .key = "totals",
      .title = "A point driven into a disk: forces in total and in increments",
      .x = "depth of the free end p",
      .error = "violation, or gap across which a force acts, in radii",
      .lines = {
          {.key = "total",
           .label = "total multipliers",
           .measure = over_depths([](double p) { return after(8, into_the_disk(p)).kkt_residual; }),
           .claim = Claim{.id = "11_16",
                          .statement = "Solved for its total, the force closes the gap to "
                                       "rounding.",
                          .law = Identity{1e-13},
                          .reason = "eight iterations, each of which gains an order; the tolerance "
                                    "of an open gap is 1e-13",
                          .api = {"stokesbook::resolve_contact"}},
           .control = Control{"increments that are not negative", over_depths([](double p) {
                                return increments(into_the_disk(p), 8).residual;
                              })}},
          {.key = "increments",
           .label = "increments",
           .measure =
               over_depths([](double p) { return increments(into_the_disk(p), 8).residual; })}}};
}

Experiment histories() {
  return {.key = "histories",
          .title = "A point driven into a disk: iterations",
          .x = "iteration k",
          .error = "error of the velocity",
          .axes = Axes::semi_log,
          .lines = {
              {.key = "total", .label = "total multipliers", .measure = over_iterations([](int k) {
                                                               return error(k, deep);
                                                             })},
              {.key = "directed",
               .label = "the same, the force's direction fixed",
               .measure = over_iterations([](int k) { return error_directed(k, deep); })},
              {.key = "increments", .label = "increments", .measure = over_iterations([](int k) {
                                                             return error_of_increments(k, deep);
                                                           })}}};
}

Experiment powers() {
  return {.key = "powers",
          .title = "Points in a row: power that contact gives to the flow",
          .x = "points n",
          .error = "power > 0 over 1 + |F| |U|, worst of twenty",
          .lines = {{.key = "contact",
                     .label = "forces that push",
                     .measure = over_rows(power_given),
                     .claim = Claim{.id = "11_17",
                                    .statement = "Contact never gives power to the flow.",
                                    .law = Identity{1e-14},
                                    .reason = "its power is -lambda c/dt, and all clearances c are "
                                              "positive",
                                    .api = {"stokesbook::resolve_contact"}},
                     .control = Control{"forces that may pull", over_rows(power_of_rods)}}}};
}

Experiment crowds() {
  return {.key = "crowds",
          .title = "More contacts than unknowns: two solvers",
          .x = "points n",
          .error = "largest difference between Lemke and Fischer-Newton, worst of twenty",
          .lines = {{.key = "velocity",
                     .label = "velocities",
                     .measure = over_rows(disagreement),
                     .claim = Claim{.id = "11_18",
                                    .statement = "Where the multipliers are not unique, the "
                                                 "velocity is.",
                                    .law = AtMost{1e-5},
                                    .reason = "the square of the difference in energy is bounded "
                                              "by residuals of 1e-10",
                                    .api = {"stokesbook::resolve_contact"}},
                     .control = Control{"forces that move their own points only, for one solver",
                                        over_rows(disagreement_without_coupling)}},
                    {.key = "multipliers",
                     .label = "multipliers",
                     .measure = over_rows(disagreement_of_multipliers)}}};
}

Experiment turns() {
  constexpr int never = 100;
  return {.key = "turns",
          .title = "A rod on a floor, whose ends are the deeper one in turn",
          .x = "rotation of the free motion ω*",
          .error = "largest velocity left",
          .lines =
              {{.key = "kept",
                .label = "earlier rows come back",
                .measure = over_rotations(ContactLoopOptions{}.restore_rows_after),
                .claim = Claim{.id = "11_19",
                               .statement = "With rows that come back the rod is at rest.",
                               .law = Identity{1e-12},
                               .reason =
                                   "both ends together permit only U = 0, and gaps are linear here",
                               .api = {"stokesbook::resolve_contact"}},
                .control = Control{"the deeper end alone, always", over_rotations(never)}},
               {.key = "alone", .label = "the deeper end alone", .measure = over_rotations(never)}},
          .operation = "linear problems"};
}

Experiment clips() {
  return {.key = "clips",
          .title = "Gaps whose linearisations contradict each other",
          .x = "free velocity U*",
          .error = "error of the velocity",
          .axes = Axes::no_law,
          .lines = {
              {.key = "clipped",
               .label = "clipped after a ray",
               .measure = over_free_velocities(lemke),
               .claim = Claim{.id = "11_20",
                              .statement = "Where a linear problem has no solution, the loop "
                                           "goes on with clipped clearances and ends.",
                              .law = Identity{1e-11},
                              .reason = "the clipped problem holds for U = 0, so that it has "
                                        "a solution; the next ones need no clipping",
                              .api = {"stokesbook::resolve_contact"}},
               .control = Control{"rays taken for failures", over_free_velocities(without_rays)}}}};
}

}  // namespace stokesbook::verification::lcp
