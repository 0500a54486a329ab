// Implements the shared parts of the experiments: annuli, their matrices with and without defects,
// and their flow.
#include <cmath>

#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "support/over_nodes.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;

test::EccentricAnnulus eccentric_annulus(double relative_gap) {
  constexpr double inner = 1.0, outer = 2.0;
  const Complex centre{0.4, -0.3};
  const double eccentricity = (outer - inner) * (1.0 - relative_gap);
  return {inner,
          outer,
          centre,
          centre + std::polar(eccentricity, 0.7),
          {{0.3, -0.2}, 1.0},
          {{0.1, 0.0}, -0.4}};
}

double wall_distance(const test::EccentricAnnulus& annulus) {
  const double eccentricity = std::abs(annulus.outer_centre - annulus.inner_centre);
  return std::log(annulus.outer_radius / (annulus.inner_radius + eccentricity));
}

Measure over_nodes(double rate, double first, double last, const ErrorOfNodes& error, int curves) {
  return test::over_nodes(first / rate, last / rate, 16, error, 2.0 * curves);
}

Measure over_nodes(const std::vector<Index>& counts, const ErrorOfNodes& error, int curves) {
  return [=](Size) { return test::errors_at(counts, error, 2.0 * curves); };
}

Measure over(const std::vector<double>& points, const std::function<double(double)>& error) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double x : points) measurements.push_back({.x = x, .error = error(x)});
    return measurements;
  };
}

MatrixXd matrix_without_n0(const StokesProblem& problem) {
  return assemble(problem, ClosureForm::reduced).matrix;
}

MatrixXd right_matrix(const StokesProblem& problem) {
  return test::assemble_bounded(problem, ClosureForm::reduced).matrix;
}

MatrixXd matrix_with_other_sign(const StokesProblem& problem) {
  return test::assemble_bounded(problem, ClosureForm::reduced, -1.0).matrix;
}

MatrixXd matrix_with_local_n0(const StokesProblem& problem) {
  const ComplexVector normal = normals(problem.components[1].curve);
  MatrixXd matrix = matrix_without_n0(problem);
  const Index first = matrix.rows() - 2 * normal.size();
  for (Index j = 0; j < normal.size(); ++j) {
    const Eigen::Vector2d n{normal[j].real(), normal[j].imag()};
    matrix.block<2, 2>(first + 2 * j, first + 2 * j) -= n * n.transpose();
  }
  return matrix;
}

MatrixXd matrix_with_mean(const StokesProblem& problem) {
  const Eigen::VectorXd shares =
      weights(problem.components[1].curve) / perimeter(problem.components[1].curve);
  MatrixXd matrix = matrix_without_n0(problem);
  const Index n = shares.size(), first = matrix.rows() - 2 * n;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      matrix.block<2, 2>(first + 2 * i, first + 2 * j).diagonal().array() -= shares[j];
    }
  }
  return matrix;
}

MatrixXd matrix_with_turned_wall(const StokesProblem& problem) {
  StokesProblem turned = problem;
  turned.components[1].curve.side = Side::fluid_outside;
  return right_matrix(turned);
}

double zero_factor(double) {
  return 0.0;
}

double unscaled_factor(double length) {
  return -length;
}

AnnulusSolution solve_annulus(const StokesProblem& problem, const MatrixXd& matrix) {
  const ComplexVector rhs = Closure(problem).right_hand_side();
  const Eigen::VectorXd solution = test::solve(matrix, interleaved(rhs));
  const ComplexVector density = deinterleaved(solution);
  return {density.head(problem.components[0].curve.size()),
          density.tail(problem.components[1].curve.size()),
          complete_dense(problem, ClosureForm::reduced, solution).loads[0]};
}

ComplexVector velocity_at(const StokesProblem& problem, const AnnulusSolution& solution,
                          const ComplexVector& points) {
  const std::vector<Curve> curves{problem.components[0].curve, problem.components[1].curve};
  ComplexVector density(solution.inner.size() + solution.outer.size());
  density << solution.inner, solution.outer;
  Completion singular;
  singular.loads = {solution.load, {}};
  return StressletSum(curves)(points, density) +
         Closure(problem).singular_velocity(singular, points);
}

double flux_through(const Curve& curve, const ComplexVector& v) {
  return normals(curve).conjugate().cwiseProduct(v).real().dot(weights(curve));
}

double relative_difference(const Load& load, const Load& exact) {
  return std::hypot(std::abs(load.force - exact.force), load.torque - exact.torque) /
         std::hypot(std::abs(exact.force), exact.torque);
}

}  // namespace stokesbook::verification::null_space
