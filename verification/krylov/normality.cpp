// Compares normal and non-normal matrices with equal eigenvalues. The comparison shows whether the
// eigenvalues determine the residuals of GMRES.
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/body_systems.hpp"
#include "support/spectra.hpp"
#include "support/vectors.hpp"

namespace stokesbook::verification::krylov {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double pair_gap = 0.1;
constexpr Index pair_nodes = 96;  // resolve the modes of that gap to e^{-15}

std::vector<Measurement> residuals_of(const LinearMap& apply, const VectorXd& rhs, int iterations) {
  const std::vector<double> history = gmres(apply, {}, rhs, {1e-15, iterations}).history;
  std::vector<Measurement> measurements;
  for (std::size_t k = 1; k < history.size(); ++k) {
    measurements.push_back({.x = static_cast<double>(k), .error = history[k]});
  }
  return measurements;
}

/// Measures residuals for the operator 1 + coupling N with (N v)_i = v_{i+1}. All eigenvalues of
/// the operator are 1.
Measure jordan_block(double coupling) {
  return [=](Size) {
    const LinearMap apply = [=](const VectorXd& v) -> VectorXd {
      VectorXd result = v;
      result.head(matrix_order - 1) += coupling * v.tail(matrix_order - 1);
      return result;
    };
    return residuals_of(apply, VectorXd::Unit(matrix_order, matrix_order - 1), 45);
  };
}

/// Measures residuals for a normal matrix with the given eigenvalues. The right-hand side has equal
/// parts of all eigenvectors.
std::vector<Measurement> normal_matrix(const VectorXd& eigenvalues, int iterations) {
  return residuals_of([&](const VectorXd& v) -> VectorXd { return eigenvalues.cwiseProduct(v); },
                      VectorXd::Ones(eigenvalues.size()), iterations);
}

/// Holds the system of two circles with their own blocks, and random data.
struct Pair {
  BodySystem system{circle_pair(pair_gap), pair_nodes, shear};
  BlockDiagonalPreconditioner solve_blocks = block_diagonal(circle_pair(pair_gap), pair_nodes);
  ComplexVector data = test::random_vector(2 * pair_nodes, 1);

  VectorXd apply(const VectorXd& v) const { return system.apply(solve_blocks(v)); }
};

std::vector<Measurement> pair_residuals(Size) {
  const Pair pair;
  return residuals_of([&](const VectorXd& v) { return pair.apply(v); }, interleaved(pair.data), 45);
}

/// Measures residuals for a normal matrix with the eigenvalues of the pair.
std::vector<Measurement> pair_if_normal(Size) {
  const Pair pair;
  const Index size = pair.system.size();
  MatrixXd matrix(size, size);
  for (Index column = 0; column < size; ++column) {
    matrix.col(column) = pair.apply(VectorXd::Unit(size, column));
  }
  return normal_matrix(test::eigenvalues(matrix).real(), 45);
}

/// Measures residuals for eigenvalues within a tenth of 1. The function is a planted defect: it
/// does not use the eigenvalues of the pair.
std::vector<Measurement> normal_near_one(Size) {
  return normal_matrix(VectorXd::LinSpaced(matrix_order, 0.9, 1.1), 45);
}

}  // namespace

Experiment normality() {
  return {
      .key = "normality",
      .title = "Whether eigenvalues determine the residuals",
      .x = "iterations k",
      .error = "residual, relative to the right-hand side",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "half",
           .label = "every eigenvalue 1, coupled by 1/2",
           .measure = jordan_block(0.5),
           .claim = Claim{.id = "05_25",
                          .statement = "A Jordan block with the eigenvalue 1 and the coupling r "
                                       "behaves like eigenvalues all over the circle of radius r "
                                       "about 1.",
                          .law = Geometric{std::log(2.0), 0.01},
                          .window = {.from = 4.0, .floor = 1e-15},
                          .reason = "p(1 + r N) b has the coefficients of p(1 + r z) as entries: "
                                    "its norm is the mean square of p over the circle, as long as "
                                    "the degree is below the order",
                          .api = {"stokesbook::gmres"}},
           .control = Control{"a normal matrix with eigenvalues from .9 to 1.1", normal_near_one}},
          {.key = "two", .label = "every eigenvalue 1, coupled by 2", .measure = jordan_block(2.0)},
          {.key = "pair",
           .label = "two circles, gap 0.1, block-diagonal",
           .measure = pair_residuals},
          {.key = "pair_if_normal",
           .label = "a normal matrix with their eigenvalues",
           .measure = pair_if_normal}}};
}

}  // namespace stokesbook::verification::krylov
