// Checks the directions of a group with couplings whose singular vectors are known.
#include "preconditioning/directions.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <boost/test/unit_test.hpp>

namespace stokesbook::test {

using Eigen::Index;
using Eigen::MatrixXf;
using Eigen::VectorXf;

namespace {

// The vectors of the discrete cosine transform of type IV.
MatrixXf orthonormal(Index n) {
  MatrixXf matrix(n, n);
  const double step = std::numbers::pi / static_cast<double>(n);
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < n; ++k) {
      const double angle = step * (static_cast<double>(i) + 0.5) * (static_cast<double>(k) + 0.5);
      matrix(i, k) = static_cast<float>(std::sqrt(2.0 / static_cast<double>(n)) * std::cos(angle));
    }
  }
  return matrix;
}

MatrixXf factor_of_couplings(double tau, const MatrixXf& couplings) {
  MatrixXf gram = MatrixXf::Zero(couplings.rows(), couplings.rows());
  add_products(couplings, gram);
  return factor_of(tau, std::move(gram));
}

float difference(const MatrixXf& a, const MatrixXf& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(directions)

BOOST_AUTO_TEST_CASE(directions_are_the_singular_vectors_above_tau) {
  const MatrixXf vectors = orthonormal(20);
  VectorXf values = VectorXf::Constant(20, 1e-3F);
  values.head<6>() << 9.0F, 3.0F, 1.0F, 0.45F, 0.2F, 0.1F;
  const MatrixXf factor = factor_of_couplings(0.05, vectors * values.asDiagonal());
  BOOST_TEST(basis_above(10.0, factor).cols() == 0);
  for (const auto& [tau, count] : {std::pair{0.4, 4}, {0.3, 4}, {0.05, 6}}) {
    const MatrixXf basis = basis_above(tau, factor);
    BOOST_TEST(basis.cols() == count);
    const MatrixXf expected = vectors.leftCols(count);
    BOOST_TEST(difference(basis * basis.transpose(), expected * expected.transpose()) < 1e-3F);
    BOOST_TEST(difference(basis.transpose() * basis, MatrixXf::Identity(count, count)) < 1e-5F);
  }
}

BOOST_AUTO_TEST_CASE(a_factor_leaves_little_of_the_gram_matrix) {
  const MatrixXf vectors = orthonormal(30);
  VectorXf values(30);
  for (Index k = 0; k < 30; ++k) values[k] = std::pow(0.8F, static_cast<float>(k));
  const MatrixXf couplings = vectors * values.asDiagonal();
  for (const double tau : {0.6, 0.2, 0.05}) {
    const MatrixXf factor = factor_of_couplings(tau, couplings);
    BOOST_TEST(factor.cols() < 30);
    const MatrixXf rest = couplings * couplings.transpose() - factor * factor.transpose();
    BOOST_TEST(rest.diagonal().maxCoeff() <= 0.1601F * static_cast<float>(tau * tau));
    BOOST_TEST(rest.diagonal().minCoeff() >= -1e-5F);
  }
}

BOOST_AUTO_TEST_CASE(further_directions_are_orthogonal_to_the_first) {
  const MatrixXf vectors = orthonormal(20);
  VectorXf values = VectorXf::Constant(20, 1e-3F);
  values.head<3>() << 2.0F, 1.0F, 0.6F;
  const MatrixXf factor = factor_of_couplings(0.3, vectors * values.asDiagonal());
  const MatrixXf first = vectors(Eigen::all, {0, 7});
  const MatrixXf further = basis_above(0.3, factor, first);
  BOOST_TEST(difference(further * further.transpose(),
                        vectors.middleCols(1, 2) * vectors.middleCols(1, 2).transpose()) < 1e-3F);
  BOOST_TEST((first.transpose() * further).cwiseAbs().maxCoeff() < 1e-5F);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
