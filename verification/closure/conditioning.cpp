// Computes condition numbers of the three forms of the closure by the size of the body, the number
// of nodes and the viscosity. The body is an ellipse near to the circle, whose singular values are
// known.
#include "experiments.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;

namespace {

constexpr double aspect_ratio = 2.0;

/// Returns the problem of a free ellipse of minor semi-axis b. The matrix does not depend on the
/// load, which is 0.
StokesProblem free_ellipse(double b, double nodes = 48.0) {
  const Ellipse ellipse{aspect_ratio * b, b};
  return {{free_body(ellipse, count(nodes), {b * Complex{0.3, 0.1}, 0.4})}, 1.3, {}, {}};
}

StokesProblem held_at_viscosity(double mu) {
  return {{held_body(Ellipse{aspect_ratio, 1.0}, 48, {{0.3, 0.1}, 0.4}, {})}, mu, {}, 20.0};
}

/// A planted defect: the row of the torque has the units of the force's row.
double with_scaled_torque(double b) {
  const StokesProblem problem = free_ellipse(b);
  DenseSystem system = assemble(problem, ClosureForm::power_bordered);
  system.matrix.bottomRows(1) /= b;
  return test::mean_square_condition(system.matrix, problem);
}

/// A planted defect: the unknown is omega instead of a omega.
double with_plain_turn(double b) {
  const StokesProblem problem = free_ellipse(b);
  DenseSystem system = assemble(problem, ClosureForm::scaled_bordered);
  system.matrix.rightCols(1) *= b;
  return test::mean_square_condition(system.matrix, problem);
}

/// A planted defect: P contains integrals instead of means.
double with_integrals(double b) {
  const StokesProblem problem = free_ellipse(b);
  const double length = perimeter(problem.components[0].curve);
  const Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  return test::mean_square_condition(matrix + (1.0 - length) * projection_matrix(problem), problem);
}

/// A planted defect: the border contains sums over the nodes instead of means.
double with_sums(double nodes) {
  const StokesProblem problem = free_ellipse(1.0, nodes);
  DenseSystem system = assemble(problem, ClosureForm::scaled_bordered);
  system.matrix.bottomRows(3) *= nodes;
  return test::mean_square_condition(system.matrix, problem);
}

/// A planted defect: P contains sums over the nodes instead of means.
double with_sums_in_projection(double nodes) {
  const StokesProblem problem = free_ellipse(1.0, nodes);
  const Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  return test::mean_square_condition(matrix + (1.0 - nodes) * projection_matrix(problem), problem);
}

/// Returns the condition number in the plain 2-norm of node values.
double plain_condition(const StokesProblem& problem, ClosureForm form) {
  return condition_number(assemble(problem, form).matrix);
}

/// A planted defect: the border's columns are divided by the square root of the number of nodes,
/// and its rows are multiplied by the same root.
double with_balanced_border(double nodes) {
  const StokesProblem problem = free_ellipse(1.0, nodes);
  DenseSystem system = assemble(problem, ClosureForm::scaled_bordered);
  system.matrix.rightCols(3) /= std::sqrt(nodes);
  system.matrix.bottomRows(3) *= std::sqrt(nodes);
  return condition_number(system.matrix);
}

/// A planted defect: the singularities lack the factor 1 / (4 pi mu).
double without_viscosity(double mu) {
  const StokesProblem problem = held_at_viscosity(mu);
  DenseSystem system = assemble(problem, ClosureForm::power_bordered);
  system.matrix.topRightCorner(system.matrix.rows() - 3, 3) *= 4.0 * std::numbers::pi * mu;
  return test::mean_square_condition(system.matrix, problem);
}

/// A planted defect: the unknown is F / (4 pi) instead of F / (4 pi mu).
double with_load_unscaled(double mu) {
  const StokesProblem problem = held_at_viscosity(mu);
  DenseSystem system = assemble(problem, ClosureForm::scaled_bordered);
  system.matrix.rightCols(3) /= mu;
  return test::mean_square_condition(system.matrix, problem);
}

/// A planted defect: P lacks the factor between motions and loads.
double with_load_for_motion(double mu) {
  const StokesProblem problem = held_at_viscosity(mu);
  const DenseSystem bordered = assemble(problem, ClosureForm::scaled_bordered);
  const Eigen::Index n = bordered.matrix.rows() - 3;
  const Eigen::MatrixXd loads =
      -bordered.matrix.topRightCorner(n, 3) * bordered.matrix.bottomLeftCorner(3, n);
  const Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  return test::mean_square_condition(matrix + (1.0 / mu - 1.0) * loads, problem);
}

Measure over_sizes(double a, double b, int points, ClosureForm form) {
  return at(log_points(a, b, points),
            [=](double size) { return test::mean_square_condition(free_ellipse(size), form); });
}

Measure over_nodes(ClosureForm form) {
  return at(node_counts(32, 128, 9), [=](double nodes) {
    return test::mean_square_condition(free_ellipse(1.0, nodes), form);
  });
}

Measure over_viscosities(double a, double b, int points, ClosureForm form) {
  return at(log_points(a, b, points),
            [=](double mu) { return test::mean_square_condition(held_at_viscosity(mu), form); });
}

const std::vector<std::string> assemble_api{"stokesbook::assemble", "stokesbook::ClosureForm"};

}  // namespace

Experiment condition_and_size() {
  return {
      .key = "sizes",
      .title = "Conditioning and the size of the body",
      .x = "minor semi-axis b",
      .error = "condition number between mean-square norms",
      .lines = {
          {.key = "power_small",
           .label = "Power's border, small body",
           .measure = over_sizes(1e-3, 3e-2, 7, ClosureForm::power_bordered),
           .claim =
               Claim{.id = "03_15",
                     .statement = "The condition number of Power's form grows as the "
                                  "inverse square of a small body's size.",
                     .law = Algebraic{2.0, 0.05},
                     .reason = "the torque's row is an integral of a length: a^2, beside -1 in "
                               "the columns of U",
                     .api = assemble_api},
           .control = Control{"the torque's row divided by the body's size",
                              at(log_points(1e-3, 3e-2, 7), with_scaled_torque)}},
          {.key = "power_large",
           .label = "Power's border, large body",
           .measure = over_sizes(3.0, 1e3, 7, ClosureForm::power_bordered),
           .claim = Claim{.id = "03_16",
                          .statement = "The condition number of Power's form grows as the "
                                       "square of a large body's size.",
                          .law = Algebraic{-2.0, 0.05},
                          .reason = "the torque's row a^2, beside 1/2 of -1/2 + D",
                          .api = assemble_api},
           .control = Control{"the torque's row divided by the body's size",
                              at(log_points(3.0, 1e3, 7), with_scaled_torque)}},
          {.key = "scaled",
           .label = "scaled border",
           .measure = over_sizes(1e-3, 1e3, 13, ClosureForm::scaled_bordered),
           .claim = Claim{.id = "03_17",
                          .statement = "With means in the border and a omega as unknown the "
                                       "condition number does not depend on the unit of length.",
                          .law = Algebraic{0.0, 1e-9},
                          .reason = "all entries are without dimension",
                          .api = assemble_api},
           .control = Control{"omega as unknown, not a omega",
                              at(log_points(1e-3, 1e3, 13), with_plain_turn)}},
          {.key = "reduced",
           .label = "reduced",
           .measure = over_sizes(1e-3, 1e3, 13, ClosureForm::reduced),
           .claim = Claim{.id = "03_18",
                          .statement = "Nor does that of the reduced form.",
                          .law = Algebraic{0.0, 1e-9},
                          .reason = "P is a projection",
                          .api = assemble_api},
           .control = Control{"integrals instead of means in the projection",
                              at(log_points(1e-3, 1e3, 13), with_integrals)}}}};
}

Experiment condition_and_nodes() {
  return {
      .key = "nodes",
      .title = "Conditioning and the number of nodes",
      .x = "nodes N",
      .error = "condition number",
      .lines = {
          {.key = "plain",
           .label = "scaled border, plain vectors of node values",
           .measure = at(node_counts(32, 128, 9),
                         [](double nodes) {
                           return plain_condition(free_ellipse(1.0, nodes),
                                                  ClosureForm::scaled_bordered);
                         }),
           .claim = Claim{.id = "03_19",
                          .statement = "In the plain norm of node values the condition number of a "
                                       "bordered system grows with the number of nodes.",
                          .law = Algebraic{-1.0, 0.05},
                          .reason = "a column of N ones has the norm N^(1/2), a row of means "
                                    "N^(-1/2)",
                          .api = assemble_api},
           .control = Control{"columns and rows of the border balanced by N^(1/2)",
                              at(node_counts(32, 128, 9), with_balanced_border)}},
          {.key = "scaled",
           .label = "scaled border, mean squares",
           .measure = over_nodes(ClosureForm::scaled_bordered),
           .claim = Claim{.id = "03_20",
                          .statement = "Between mean-square norms the condition number of the "
                                       "scaled form does not grow with the number of nodes.",
                          .law = Algebraic{0.0, 1e-6},
                          .reason = "the singular values are those of a second-kind operator",
                          .api = assemble_api},
           .control = Control{"sums over the nodes instead of means in the border",
                              at(node_counts(32, 128, 9), with_sums)}},
          {.key = "reduced",
           .label = "reduced, mean squares",
           .measure = over_nodes(ClosureForm::reduced),
           .claim = Claim{.id = "03_21",
                          .statement = "Nor does that of the reduced form.",
                          .law = Algebraic{0.0, 1e-6},
                          .reason = "a second-kind operator",
                          .api = assemble_api},
           .control = Control{"sums over the nodes instead of means in the projection",
                              at(node_counts(32, 128, 9), with_sums_in_projection)}},
          {.key = "reduced_plain",
           .label = "reduced, plain vectors of node values",
           .measure = at(node_counts(32, 128, 9), [](double nodes) {
             return plain_condition(free_ellipse(1.0, nodes), ClosureForm::reduced);
           })}}};
}

Experiment condition_and_viscosity() {
  return {
      .key = "viscosities",
      .title = "Conditioning and the viscosity, held body",
      .x = "viscosity μ",
      .error = "condition number between mean-square norms",
      .lines = {{.key = "power_thin",
                 .label = "Power's border, thin fluid",
                 .measure = over_viscosities(1e-5, 1e-3, 5, ClosureForm::power_bordered),
                 .claim = Claim{.id = "03_22",
                                .statement = "For held bodies the condition number of Power's form "
                                             "grows as 1 / mu in a thin fluid.",
                                .law = Algebraic{1.0, 0.05},
                                .reason = "the columns of F hold 1 / (4 pi mu)",
                                .api = assemble_api},
                 .control = Control{"singularities without 1 / (4 pi mu)",
                                    at(log_points(1e-5, 1e-3, 5), without_viscosity)}},
                {.key = "power_thick",
                 .label = "Power's border, thick fluid",
                 .measure = over_viscosities(1e1, 1e4, 7, ClosureForm::power_bordered),
                 .claim = Claim{.id = "03_23",
                                .statement = "For held bodies the condition number of the "
                                             "Power's form grows as mu in a thick fluid.",
                                .law = Algebraic{-1.0, 0.05},
                                .reason = "the same columns, which vanish",
                                .api = assemble_api},
                 .control = Control{"singularities without 1 / (4 pi mu)",
                                    at(log_points(1e1, 1e4, 7), without_viscosity)}},
                {.key = "scaled",
                 .label = "scaled border",
                 .measure = over_viscosities(1e-5, 1e4, 13, ClosureForm::scaled_bordered),
                 .claim = Claim{.id = "03_24",
                                .statement = "With F / (4 pi mu) as unknown the condition "
                                             "number does not depend on the viscosity.",
                                .law = Algebraic{0.0, 1e-9},
                                .reason = "the viscosity does not enter the matrix",
                                .api = assemble_api},
                 .control = Control{"F / (4 pi) as unknown",
                                    at(log_points(1e-5, 1e4, 13), with_load_unscaled)}},
                {.key = "reduced",
                 .label = "reduced",
                 .measure = over_viscosities(1e-5, 1e4, 13, ClosureForm::reduced),
                 .claim = Claim{.id = "03_25",
                                .statement = "Nor does that of the reduced form.",
                                .law = Algebraic{0.0, 1e-9},
                                .reason = "the viscosity does not enter the matrix",
                                .api = assemble_api},
                 .control = Control{"F = -4 pi U, without the viscosity",
                                    at(log_points(1e-5, 1e4, 13), with_load_for_motion)}}}};
}

}  // namespace stokesbook::verification::closure
