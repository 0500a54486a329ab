// Compares two equal circles, computed by plain trapezoid sums, with their closed form. Measures
// the rates, which are predicted from the gap, the gap at which the sums fail, and the cost of each
// form.
#include <algorithm>
#include <functional>

#include "experiments.hpp"
#include "support/closed_forms.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;

namespace {

/// Describes two circles of radius a, which an extensional flow and forces along their line of
/// centres pull apart. Each circle has a node at its point nearest to the other.
struct Pair {
  double a, gap;  // gap relative to the radius
  Complex along = std::polar(1.0, 0.35);
  double strain = 1.0, viscosity = 1.3;
  double pull = 3.0 * viscosity * strain * a;

  StokesProblem problem(Eigen::Index n, Eigen::Index n_other) const {
    const Complex half = a * (1.0 + 0.5 * gap) * along;
    StokesProblem pair{{free_body(Circle{a}, n, {half, 0.35}, {pull * along}),
                        free_body(Circle{a}, n_other, {-half, 0.35}, {-pull * along})},
                       viscosity,
                       {},
                       {}};
    pair.background = strain * along * along * all_nodes(pair).conjugate();
    return pair;
  }

  /// Returns the relative error of the speed along the line of centres.
  double error(const RigidMotion& motion) const {
    const CirclePair exact{a, gap * a};
    const double speed = exact.speed_in_extension(strain) + exact.speed_of_pull(pull, viscosity);
    return std::abs(dot(motion.velocity, along) / speed - 1.0);
  }

  /// Returns the rate of the error in N (03.17).
  double rate() const { return 2.0 * std::log1p(0.5 * gap); }
};

double error(const Pair& pair, const StokesProblem& problem, const DenseSystem& system,
             ClosureForm form) {
  return pair.error(complete_dense(problem, form, solve(system)).motions[0]);
}

double error_of_form(const Pair& pair, double nodes, ClosureForm form) {
  const StokesProblem problem = pair.problem(count(nodes), count(nodes));
  return error(pair, problem, assemble(problem, form), form);
}

/// A planted defect: the other circle's normals point into the fluid.
double error_with_normals_turned(const Pair& pair, double nodes) {
  StokesProblem problem = pair.problem(count(nodes), count(nodes));
  problem.components[1].curve.side = Side::fluid_inside;
  return error(pair, problem, assemble(problem, ClosureForm::scaled_bordered),
               ClosureForm::scaled_bordered);
}

/// A planted defect, which is also the naive method: the double layer of one circle on the other is
/// omitted.
double error_one_by_one(const Pair& pair, double nodes) {
  const StokesProblem problem = pair.problem(count(nodes), count(nodes));
  DenseSystem system = assemble(problem, ClosureForm::scaled_bordered);
  const Eigen::Index n = 2 * count(nodes);
  system.matrix.block(0, n, n, n).setZero();
  system.matrix.block(n, 0, n, n).setZero();
  return error(pair, problem, system, ClosureForm::scaled_bordered);
}

/// A planted defect: the other circle has half as many nodes.
double error_with_fewer_nodes(const Pair& pair, double nodes) {
  const StokesProblem problem = pair.problem(count(nodes), 2 * count(nodes / 4.0));
  return error(pair, problem, assemble(problem, ClosureForm::scaled_bordered),
               ClosureForm::scaled_bordered);
}

/// Assembles the reduced form with D eta instead of D (I - P) eta.
DenseSystem assemble_with_rigid_part(const StokesProblem& problem) {
  const DenseSystem bordered = assemble(problem, ClosureForm::scaled_bordered);
  const Eigen::Index n = bordered.matrix.rows() - 6;
  DenseSystem system{bordered.matrix.topLeftCorner(n, n), bordered.rhs.head(n)};
  system.matrix += bordered.matrix.topRightCorner(n, 6) * bordered.matrix.bottomLeftCorner(6, n);
  return system;
}

DenseSystem assemble_reduced(const StokesProblem& problem) {
  return assemble(problem, ClosureForm::reduced);
}

/// Returns the change of a circle's velocity by a uniform stream, minus the stream itself, relative
/// to the stream.
double drift(double nodes, DenseSystem (*system)(const StokesProblem&)) {
  const Complex stream{-0.6, 0.8};
  const Pair pair{1.0, 0.5};
  const StokesProblem problem = pair.problem(count(nodes), count(nodes));
  StokesProblem in_stream = problem;
  in_stream.background.array() += stream;
  const auto velocity = [&](const StokesProblem& p) {
    return complete_dense(p, ClosureForm::reduced, solve(system(p))).motions[0].velocity;
  };
  return std::abs(velocity(in_stream) - stream - velocity(problem));
}

/// Returns the error of Power's form with zero on the right-hand side of its border.
double error_of_power_with_zero(double a) {
  const Pair pair{a, 0.5};
  const StokesProblem problem = pair.problem(36, 36);
  DenseSystem system = assemble(problem, ClosureForm::power_bordered);
  system.rhs.tail(6).setZero();
  return error(pair, problem, system, ClosureForm::power_bordered);
}

using PairError = std::function<double(const Pair&, double nodes)>;

PairError of_form(ClosureForm form) {
  return [form](const Pair& pair, double nodes) { return error_of_form(pair, nodes, form); };
}

Claim gap_claim(const std::string& id, const Pair& pair) {
  return {.id = id,
          .statement =
              "Plain sums between two circles converge as N^(1/2) (1 + g / 2)^(-2 N), g "
              "the gap in radii.",
          .law = Geometric{pair.rate(), 0.02, 0.5},
          .window = {.from = 10.0 / pair.rate(), .floor = 1e-15},
          .reason =
              "mode N of the distance from a circle's centre to the other circle, to the "
              "power -N",
          .api = {"stokesbook::assemble", "stokesbook::double_layer_matrix"}};
}

Line gap_line(const std::string& key, const std::string& id, const Pair& pair,
              const std::string& label, const std::string& defect, const PairError& wrong) {
  const std::vector<double> nodes = node_counts(4.0 / pair.rate(), 24.0 / pair.rate(), 11);
  const PairError right = of_form(ClosureForm::scaled_bordered);
  return {.key = key,
          .label = label,
          .measure = at(nodes, [=](double n) { return right(pair, n); }),
          .claim = gap_claim(id, pair),
          .control = Control{defect, at(nodes, [=](double n) { return wrong(pair, n); })}};
}

/// Measures errors with their costs: unknowns, and evaluations of the double layer's kernel.
Measure at_cost(const Pair& pair, const PairError& error, int border, double blocks) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double nodes = 12.0; nodes <= 96.0; nodes += size == Size::full ? 6.0 : 12.0) {
      measurements.push_back({.x = nodes,
                              .error = error(pair, nodes),
                              .unknowns = 4.0 * nodes + border,
                              .operations = blocks * nodes * nodes});
    }
    return measurements;
  };
}

}  // namespace

Experiment gaps() {
  const Pair touching{1.0, 0.01};
  const auto touching_error = [=](double n) {
    return error_of_form(touching, n, ClosureForm::scaled_bordered);
  };
  return {
      .key = "gaps",
      .title = "Two circles and their gap",
      .x = "nodes of each circle N",
      .error = "relative error of the speed along the line of centres",
      .axes = Axes::semi_log,
      .lines = {gap_line("half", "03_31", {1.0, 0.5}, "gap 0.5",
                         "the other circle's normals into the fluid", error_with_normals_turned),
                gap_line("fifth", "03_32", {1.0, 0.2}, "gap 0.2",
                         "no double layer of one circle on the other", error_one_by_one),
                gap_line("tenth", "03_33", {1.0, 0.1}, "gap 0.1",
                         "half as many nodes on the other circle", error_with_fewer_nodes),
                {.key = "hundredth",
                 .label = "gap 0.01",
                 .measure = at(node_counts(16, 256, 13), touching_error)}}};
}

Experiment streams() {
  const std::vector<double> nodes = node_counts(8, 80, 13);
  const Measure with_rigid_part = at(
      nodes, [](double n) { return drift(n, assemble_with_rigid_part); }, 4.0);
  return {
      .key = "streams",
      .title = "Two circles in a uniform stream",
      .x = "nodes of each circle N",
      .error = "change of U beside the stream, relative to it",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "without_rigid_part",
           .label = "D (I - P) η",
           .measure = at(
               nodes, [](double n) { return drift(n, assemble_reduced); }, 4.0),
           .claim =
               Claim{.id = "03_34",
                     .statement = "A uniform stream carries all bodies with it, "
                                  "however few the nodes.",
                     .law = Identity{1e-14},
                     .reason = "the stream is in P eta, to which the double layer is not applied",
                     .api = {"stokesbook::Closure"}},
           .control = Control{"D of the rigid part too", with_rigid_part}},
          {.key = "with_rigid_part", .label = "Dη, by quadrature", .measure = with_rigid_part}}};
}

Experiment pair_units() {
  constexpr double nodes = 36.0;
  const std::vector<double> radii = log_points(1e-8, 1e4, 13);
  const auto measure = [&](ClosureForm form) {
    return at(radii, [=](double a) { return error_of_form({a, 0.5}, nodes, form); });
  };
  return {.key = "pair_units",
          .title = "Two circles of 36 nodes, and the unit of length",
          .x = "radius a",
          .error = "relative error of the speed along the line of centres",
          .lines = {{.key = "power",
                     .label = "Power's border",
                     .measure = measure(ClosureForm::power_bordered),
                     .claim = Claim{.id = "03_35",
                                    .statement = "In small units the quadrature error of the "
                                                 "Power's form grows as the inverse of the length.",
                                    .law = Algebraic{1.0, 0.05},
                                    .window = {.to = 1e-3},
                                    .reason = "its density has the mean F / (2 pi a), beside "
                                              "velocities U ~ F / mu",
                                    .api = {"stokesbook::ClosureForm"}},
                     .control = Control{"zero on the right of its border",
                                        at(radii, error_of_power_with_zero)}},
                    {.key = "reduced",
                     .label = "reduced",
                     .measure = measure(ClosureForm::reduced),
                     .claim = Claim{.id = "03_36",
                                    .statement = "That of the reduced form does not depend on the "
                                                 "unit.",
                                    .law = Algebraic{0.0, 1e-6},
                                    .reason = "all terms of the density are velocities",
                                    .api = {"stokesbook::ClosureForm"}},
                     .control = Control{"means of the density as large as the loads",
                                        measure(ClosureForm::power_bordered)}}}};
}

Experiment forms_at_work() {
  // The radius is one micrometre, in metres.
  const Pair pair{1e-6, 0.5}, touching{1e-6, 0.01};
  return {.key = "forms",
          .title = "The forms of the closure at work: two circles of a micrometre, in metres",
          .x = "nodes of each circle N",
          .error = "relative error of the speed along the line of centres",
          .axes = Axes::semi_log,
          .lines = {{.key = "reduced",
                     .label = "reduced",
                     .measure = at_cost(pair, of_form(ClosureForm::reduced), 0, 4.0),
                     .claim = gap_claim("03_37", pair),
                     .control = Control{"no double layer of one circle on the other",
                                        at_cost(pair, error_one_by_one, 6, 2.0)}},
                    {.key = "scaled",
                     .label = "scaled border",
                     .measure = at_cost(pair, of_form(ClosureForm::scaled_bordered), 6, 4.0)},
                    {.key = "power",
                     .label = "Power's border",
                     .measure = at_cost(pair, of_form(ClosureForm::power_bordered), 6, 4.0)},
                    {.key = "one_by_one",
                     .label = "no double layer of one circle on the other",
                     .measure = at_cost(pair, error_one_by_one, 6, 2.0)},
                    {.key = "touching",
                     .label = "reduced, gap 0.01",
                     .measure = at_cost(touching, of_form(ClosureForm::reduced), 0, 4.0)}},
          .work_precision = true,
          .operation = "kernel evaluations"};
}

}  // namespace stokesbook::verification::closure
