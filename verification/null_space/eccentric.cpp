// Compares eccentric circles with their closed form (04.10), from wide gaps to gaps that no
// affordable number of nodes resolves, and shows that far fewer nodes would resolve the density.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "text/number_text.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using test::EccentricAnnulus;

/// Returns the resistance matrix. Its columns are the loads (F_1, F_2, L) of an inner circle of
/// radius 1 that moves along axis 1, moves along axis 2, and turns. The outer circle is at rest.
template <class LoadOf>
Matrix3d resistance(EccentricAnnulus annulus, const LoadOf& load_of) {
  annulus.outer = {};
  const RigidMotion motions[]{{1.0, 0.0}, {imaginary, 0.0}, {0.0, 1.0}};
  Matrix3d result;
  for (Index column = 0; column < 3; ++column) {
    annulus.inner = motions[column];
    const Load load = load_of(annulus);
    result.col(column) << load.force.real(), load.force.imag(), load.torque;
  }
  return result;
}

/// Measures errors by the number N of nodes on each circle. All motions are compared at once,
/// because a single load may be accurate by accident.
Measure resistance_errors(double relative_gap, AnnulusMatrix matrix) {
  const EccentricAnnulus annulus = eccentric_annulus(relative_gap);
  const Matrix3d exact =
      resistance(annulus, [](const EccentricAnnulus& moving) { return inner_load(moving, 1.0); });
  return over_nodes(2.0 * wall_distance(annulus), 8.0, 28.0, [=](Index n) {
    const MatrixXd inverse = test::inverse(matrix(annulus_problem(annulus, 1.0, n, n)));
    const Matrix3d computed = resistance(annulus, [&](const EccentricAnnulus& moving) {
      const StokesProblem problem = annulus_problem(moving, 1.0, n, n);
      const ComplexVector rhs = Closure(problem).right_hand_side();
      const VectorXd solution = inverse * interleaved(rhs);
      return complete_dense(problem, ClosureForm::reduced, solution).loads[0];
    });
    return (computed - exact).norm() / exact.norm();
  });
}

struct Defect {
  std::string name;
  AnnulusMatrix matrix;
};

Line eccentric_line(const std::string& key, const std::string& id, double relative_gap,
                    const Defect& defect) {
  const double rate = 2.0 * wall_distance(eccentric_annulus(relative_gap));
  return {.key = key,
          .label = "relative gap " + short_number(relative_gap),
          .measure = resistance_errors(relative_gap, right_matrix),
          .claim = Claim{.id = id,
                         .statement = "Force and torque between eccentric circles converge as "
                                      "N^(3/2) e^{-2 d N}, d = log(R_2 / (R_1 + e)).",
                         .law = Geometric{rate, 0.03, 1.5},
                         .window = {.from = 13.0 / rate, .floor = 1e-15},
                         .reason = "two aliases N e^{-d N} in a row, and a saddle point N^(-1/2); "
                                   "d: the inner circle's distance in the wall's parameter",
                         .api = {"stokesbook::assemble", "stokesbook::null_space_matrix"}},
          .control = Control{defect.name, resistance_errors(relative_gap, defect.matrix)}};
}

/// Measures the Fourier coefficients of the wall's density from N nodes, relative to the largest
/// coefficient.
Measure density_coefficients(double relative_gap, Index n) {
  return [=](Size) {
    const StokesProblem problem = annulus_problem(eccentric_annulus(relative_gap), 1.0, n, n);
    const ComplexVector c =
        fourier_coefficients(solve_annulus(problem, right_matrix(problem)).outer);
    const double largest = c.cwiseAbs().maxCoeff();
    std::vector<Measurement> measurements;
    for (Index k = 2; k < std::min<Index>(n / 2, 48); k += 2) {
      measurements.push_back({.x = static_cast<double>(k),
                              .error = std::hypot(std::abs(c[k]), std::abs(c[n - k])) / largest});
    }
    return measurements;
  };
}

Line density_line(const std::string& key, const std::string& id, double relative_gap, Index n) {
  const EccentricAnnulus annulus = eccentric_annulus(relative_gap);
  const double e = std::abs(annulus.outer_centre - annulus.inner_centre);
  const double r1 = annulus.inner_radius, r2 = annulus.outer_radius;
  // alpha is the bipolar coordinate of the outer circle. The foci are at the distances R_2
  // e^{+-alpha} from the circle's centre, with cosh(alpha) = (R_2^2 - R_1^2 + e^2) / (2 e R_2).
  const double alpha = std::acosh((r2 * r2 - r1 * r1 + e * e) / (2.0 * e * r2));
  const double distance = wall_distance(annulus), nodes = static_cast<double>(n);
  return {.key = key,
          .label = "relative gap " + short_number(relative_gap),
          .measure = density_coefficients(relative_gap, n),
          .claim = Claim{.id = id,
                         .statement = "The modes of the wall's density fall as e^{-a k}, a the "
                                      "wall's bipolar coordinate: a is like the root of the gap.",
                         .law = Geometric{alpha, 0.02},
                         .window = {.floor = nodes * std::exp(-distance * nodes)},
                         .reason = "the flow's only singularities are the foci of the circles; "
                                   "the floor is the rule's error N e^{-d N} at these nodes",
                         .api = {"stokesbook::fourier_coefficients", "stokesbook::assemble"}},
          .control = Control{"a quarter of the nodes", density_coefficients(relative_gap, n / 4)}};
}

const std::vector<double> gaps{0.01, 0.014, 0.02, 0.05, 0.1, 0.2, 0.35, 0.5};

/// @param  narrowest  narrowest gap that is set up; a value other than 0 is a planted defect
Measure gap_errors(Index n, double narrowest = 0.0) {
  return over(gaps, [=](double gap) {
    const EccentricAnnulus annulus = eccentric_annulus(std::max(gap, narrowest));
    const StokesProblem problem = annulus_problem(annulus, 1.0, n, n);
    return relative_difference(solve_annulus(problem, right_matrix(problem)).load,
                               inner_load(annulus, 1.0));
  });
}

Measure gap_residuals(Index n) {
  return over(gaps, [=](double gap) {
    const StokesProblem problem = annulus_problem(eccentric_annulus(gap), 1.0, n, n);
    const MatrixXd matrix = right_matrix(problem);
    const ComplexVector rhs = Closure(problem).right_hand_side();
    const VectorXd b = interleaved(rhs);
    return (matrix * test::solve(matrix, b) - b).norm() / b.norm();
  });
}

/// Compares two torques that are equal by reciprocity: the torque of the outer circle about its
/// centre if only the inner circle turns, and the closed form of the inner circle's torque if only
/// the outer circle turns.
Measure torque_differences(bool with_arm) {
  return over({0.4, 0.5, 0.6, 0.7}, [=](double gap) {
    EccentricAnnulus annulus = eccentric_annulus(gap);
    annulus.inner = {{}, 1.0};
    annulus.outer = {};
    const StokesProblem problem = annulus_problem(annulus, 1.0, 96, 96);
    const Load inner = solve_annulus(problem, right_matrix(problem)).load;
    const Complex arm = annulus.inner_centre - annulus.outer_centre;
    const double outer = -inner.torque - (with_arm ? cross(arm, inner.force) : 0.0);
    std::swap(annulus.inner, annulus.outer);
    return std::abs(outer / inner_load(annulus, 1.0).torque - 1.0);
  });
}

}  // namespace

Experiment eccentric() {
  return {.key = "eccentric",
          .title = "Resistance of a circle in an eccentric container",
          .x = "nodes N",
          .error = "relative error of the resistance matrix (Frobenius norm)",
          .axes = Axes::semi_log,
          .lines = {eccentric_line("half", "04_19", 0.5,
                                   {"the wall's normal into the fluid", matrix_with_turned_wall}),
                    eccentric_line("quarter", "04_20", 0.25,
                                   {"the integral of N_0 forgotten", matrix_with_local_n0}),
                    eccentric_line(
                        "eighth", "04_21", 0.125,
                        {"the mean of the density instead of its normal part", matrix_with_mean})}};
}

Experiment choices() {
  constexpr double gap = 0.5;
  const double rate = 2.0 * wall_distance(eccentric_annulus(gap));
  const auto line = [](const std::string& key, const std::string& label, AnnulusMatrix matrix) {
    return Line{.key = key, .label = label, .measure = resistance_errors(gap, matrix)};
  };
  Line other_sign = line("sign", "plus n <n . eta>", matrix_with_other_sign);
  other_sign.claim =
      Claim{.id = "04_28",
            .statement = "N_0 of the other sign gives the same loads, at the same rate.",
            .law = Geometric{rate, 0.03, 1.5},
            .window = {.from = 13.0 / rate, .floor = 1e-15},
            .reason = "for compatible data N_0 eta vanishes",
            .api = {"stokesbook::null_space_matrix"}};
  other_sign.control =
      Control{"the wall's normal into the fluid", resistance_errors(gap, matrix_with_turned_wall)};
  return {
      .key = "choices",
      .title = "Resistance of a circle in an eccentric container: other choices",
      .x = "nodes N",
      .error = "relative error of the resistance matrix (Frobenius norm)",
      .axes = Axes::semi_log,
      .lines = {line("right", "minus n <n . eta>: N_0", right_matrix), other_sign,
                line("without", "no N_0", matrix_without_n0),
                line("local", "minus n (n . eta), at every node", matrix_with_local_n0),
                line("mean", "minus <eta>", matrix_with_mean),
                line("turned", "N_0, the wall's normal into the fluid", matrix_with_turned_wall)}};
}

Experiment density() {
  return {
      .key = "density",
      .title = "Modes of the wall's density",
      .x = "wave number k",
      .error = "coefficient, relative to the largest",
      .axes = Axes::semi_log,
      .lines = {density_line("half", "04_22", 0.5, 96), density_line("fifth", "04_23", 0.2, 240)}};
}

Experiment closing_gap() {
  return {.key = "gap",
          .title = "Fixed numbers of nodes and a closing gap",
          .x = "relative gap δ/(R₂-R₁)",
          .error = "relative error of the inner circle's load",
          .axes = Axes::log_log,
          .lines = {
              {.key = "n32", .label = "32 nodes a circle", .measure = gap_errors(32)},
              {.key = "n64", .label = "64 nodes a circle", .measure = gap_errors(64)},
              {.key = "n128",
               .label = "128 nodes a circle",
               .measure = gap_errors(128),
               .claim = Claim{.id = "04_24",
                              .statement = "With 128 nodes no digit of the load is right at "
                                           "relative gaps of 0.02 and below.",
                              .law = Floor{1.0, 3.0},
                              .window = {.to = 0.0201},
                              .reason = "2 d N is below 3, so that nothing has begun to "
                                        "converge; the true load outgrows the computed one",
                              .api = {"stokesbook::assemble"}},
               .control = Control{"gaps that do not close further than 0.2", gap_errors(128, 0.2)}},
              {.key = "residual",
               .label = "residual of the linear system, 128 nodes",
               .measure = gap_residuals(128)}}};
}

Experiment balance() {
  return {
      .key = "balance",
      .title = "Torque on the outer circle when the inner one turns",
      .x = "relative gap δ/(R₂-R₁)",
      .error = "relative difference from the closed form",
      .axes = Axes::log_log,
      .lines = {{.key = "torque",
                 .label = "96 nodes a circle",
                 .measure = torque_differences(true),
                 .claim = Claim{.id = "04_25",
                                .statement = "The torque on the wall is that on the inner circle "
                                             "in the other problem of the reciprocal theorem.",
                                .law = Identity{1e-13},
                                .reason = "stress is free of divergence; the resistance matrix "
                                          "of both circles is symmetric",
                                .api = {"stokesbook::with_balance"}},
                 .control = Control{"the arm of the force forgotten", torque_differences(false)}}}};
}

}  // namespace stokesbook::verification::null_space
