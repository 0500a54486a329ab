// Computes condition numbers of a circular wall in various units of length, with the scaled N_0,
// with an unscaled N_0, and without N_0; measures the effect of a factor of N_0 on the results.
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/spectra.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

double one(double) {
  return 1.0;
}

Measure conditions(Factor factor) {
  return over({1e-3, 1e-2, 1e-1, 1.0, 10.0, 100.0, 1e3, 1e4}, [=](double radius) {
    const Curve wall = place(sample(Circle{radius}, 32, Side::fluid_inside), {radius, 0.3}, 0.2);
    MatrixXd matrix = double_layer_matrix(wall) + factor(perimeter(wall)) * null_space_matrix(wall);
    matrix.diagonal().array() -= 0.5;
    return test::condition_number(matrix);
  });
}

/// Measures the error of the load in an annulus with c N_0 on the wall. N_0 is obtained as the
/// difference of two matrices.
Measure load_errors(double sign, AnnulusMatrix with_n0) {
  std::vector<double> factors;
  for (int k = -12; k <= 12; k += 2) factors.push_back(std::pow(10.0, k));
  return over(factors, [=](double factor) {
    const test::EccentricAnnulus annulus = eccentric_annulus(0.5);
    const StokesProblem problem = annulus_problem(annulus, 1.0, 80, 80);
    const MatrixXd bare = matrix_without_n0(problem);
    const MatrixXd matrix = bare + sign * factor * (with_n0(problem) - bare);
    return relative_difference(solve_annulus(problem, matrix).load, inner_load(annulus, 1.0));
  });
}

}  // namespace

Experiment conditioning() {
  return {
      .key = "condition",
      .title = "Condition number of a circular wall in any unit of length",
      .x = "radius R",
      .error = "condition number",
      .axes = Axes::log_log,
      .lines = {
          {.key = "scaled",
           .label = "N_0 over the wall's length",
           .measure = conditions(one),
           .claim = Claim{.id = "04_9",
                          .statement = "With N_0 the condition number of a circular wall is 2 at "
                                       "any radius.",
                          .law = Floor{2.0, 1.1},
                          .reason = "the eigenvalues of the symmetric matrix are -1 and -1/2",
                          .api = {"stokesbook::null_space_matrix"}},
           .control = Control{"the factor of the unscaled N_0", conditions(unscaled_factor)}},
          {.key = "unscaled",
           .label = "N_0 that is not scaled",
           .measure = conditions(unscaled_factor),
           .claim = Claim{.id = "04_10",
                          .statement = "Without the division by the length, the condition number "
                                       "grows with the wall: it is 4 pi R.",
                          .law = Algebraic{-1.0, 0.01},
                          .window = {.from = 1.0},
                          .reason = "one eigenvalue is the length 2 pi R, the least ones are 1/2",
                          .api = {"stokesbook::null_space_matrix"}},
           .control = Control{"N_0 over the wall's length", conditions(one)}},
          {.key = "without", .label = "without N_0", .measure = conditions(zero_factor)}}};
}

Experiment scale() {
  return {
      .key = "factor",
      .title = "Loads with a factor in front of N_0",
      .x = "factor c",
      .error = "relative error of the inner circle's load",
      .axes = Axes::log_log,
      .lines = {
          {.key = "plus",
           .label = "c N_0",
           .measure = load_errors(1.0, right_matrix),
           .claim = Claim{.id = "04_11",
                          .statement = "No factor up to 1 costs a digit of the load, though the "
                                       "condition number grows beyond 1e12.",
                          .law = Identity{1e-13},
                          .window = {.to = 2.0},
                          .reason = "for compatible data N_0 eta vanishes; rounding in the "
                                    "direction that N_0 deflates makes no flow",
                          .api = {"stokesbook::null_space_matrix"}},
           .control =
               Control{"the integral of N_0 forgotten", load_errors(1.0, matrix_with_local_n0)}},
          {.key = "minus",
           .label = "-c N_0",
           .measure = load_errors(-1.0, right_matrix),
           .claim = Claim{.id = "04_12",
                          .statement = "Either sign gives the same loads; large factors cost "
                                       "digits: rounding times c.",
                          .law = Algebraic{-1.0, 0.1},
                          .window = {.from = 1e3, .to = 1e11},
                          .reason = "entries of the size c round off those of -1/2 + D",
                          .api = {"stokesbook::null_space_matrix"}},
           .control =
               Control{"the integral of N_0 forgotten", load_errors(-1.0, matrix_with_local_n0)}}}};
}

}  // namespace stokesbook::verification::null_space
