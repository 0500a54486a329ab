// Checks that rounding does not increase iteration counts: on ill-conditioned systems the counts
// equal those of the same method in extended precision.
#include <cmath>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "krylov/gmres.hpp"
#include "krylov/matrices.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::map_of;
using test::normal_matrix;
using test::orthogonal_matrix;

namespace {

using ExtendedMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using ExtendedVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

// Returns the part of w orthogonal to the first columns of a basis, scaled to length 1, by modified
// Gram-Schmidt in two passes.
ExtendedVector next_direction(const ExtendedMatrix& basis, Index columns, ExtendedVector w) {
  for (int pass = 0; pass < 2; ++pass) {
    for (Index i = 0; i < columns; ++i) w -= basis.col(i).dot(w) * basis.col(i);
  }
  return w / w.norm();
}

// Returns the relative residuals of GMRES in extended precision, from orthonormal bases of the
// Krylov space and of its image: the residual is the part of b orthogonal to the image.
std::vector<double> extended_history(const ExtendedMatrix& a, const ExtendedVector& b, Index most) {
  ExtendedMatrix basis(b.size(), most + 1), image(b.size(), most);
  basis.col(0) = b / b.norm();
  ExtendedVector residual = basis.col(0);
  std::vector<double> history{1.0};
  for (Index k = 0; k < most; ++k) {
    const ExtendedVector w = a * basis.col(k);
    basis.col(k + 1) = next_direction(basis, k + 1, w);
    image.col(k) = next_direction(image, k, w);
    residual -= image.col(k).dot(residual) * image.col(k);
    history.push_back(static_cast<double>(residual.norm()));
  }
  return history;
}

int iterations_to(const std::vector<double>& history, double tolerance) {
  int k = 0;
  while (history[static_cast<std::size_t>(k)] > tolerance) ++k;
  return k;
}

// The logarithms of the singular values are evenly spaced.
MatrixXd ill_conditioned_matrix(Index n, double decades) {
  const VectorXd spread =
      VectorXd::LinSpaced(n, 0.0, -decades).unaryExpr([](double e) { return std::pow(10.0, e); });
  return orthogonal_matrix(n, 1) * spread.asDiagonal() * orthogonal_matrix(n, 2);
}

}  // namespace

BOOST_AUTO_TEST_CASE(counts_are_those_of_extended_precision) {
  for (double decades : {2.0, 5.0}) {
    const MatrixXd a = ill_conditioned_matrix(60, decades);
    const VectorXd b = a * normal_matrix(60, 1, 3);
    const std::vector<double> exact =
        extended_history(a.cast<long double>(), b.cast<long double>(), 60);
    const GmresResult result = gmres(map_of(a), {}, b, {1e-13, 60});
    for (double tolerance : {1e-2, 1e-6, 1e-10, 1e-12}) {
      BOOST_TEST(iterations_to(result.history, tolerance) == iterations_to(exact, tolerance));
    }
    // The residuals themselves agree as well, up to rounding relative to |b|.
    for (std::size_t k = 0; k < result.history.size(); ++k) {
      BOOST_TEST(std::abs(result.history[k] - exact[k]) < 1e-13 + 1e-6 * exact[k]);
    }
  }
}

BOOST_AUTO_TEST_CASE(eigenvalues_clustered_at_one_and_a_few_far_away) {
  // Second-kind operators with near contacts have such a spectrum. Each outlier costs one
  // iteration.
  const Index n = 100;
  VectorXd eigenvalues = VectorXd::Ones(n) + 0.01 * VectorXd::LinSpaced(n, -1.0, 1.0);
  for (Index k = 0; k < 8; ++k) eigenvalues[k] = std::pow(10.0, -0.5 * static_cast<double>(k + 1));
  const MatrixXd modes = orthogonal_matrix(n, 4);
  const MatrixXd a = modes * eigenvalues.asDiagonal() * modes.transpose();
  const VectorXd b = normal_matrix(n, 1, 5);
  const std::vector<double> exact =
      extended_history(a.cast<long double>(), b.cast<long double>(), 30);
  const GmresResult result = gmres(map_of(a), {}, b, {1e-12, 500});
  BOOST_TEST(result.converged);
  BOOST_TEST(result.iterations == iterations_to(exact, 1e-12));
}
