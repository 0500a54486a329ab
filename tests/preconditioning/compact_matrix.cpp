// Checks products with a matrix of 16 bits a number against those in single precision.
#include "preconditioning/compact_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

namespace stokesbook::test {

using Eigen::MatrixXf;
using Eigen::VectorXf;

namespace {

// Returns a matrix whose rows and columns have very different sizes, one of each zero.
MatrixXf numbers_of_many_sizes() {
  MatrixXf matrix(37, 5);
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      matrix(i, j) = std::pow(1e-3F, static_cast<float>(j + i % 3)) *
                     std::sin(static_cast<float>(3 * i * i + 5 * j) + 0.4F);
    }
  }
  matrix.col(2).setZero();
  matrix.row(30).setZero();
  return matrix;
}

// Returns half a unit of each number: a 65534th of the largest number of its column, when all rows
// have been scaled to the norm 1, times the norm of its row.
MatrixXf rounding_of(const MatrixXf& matrix) {
  MatrixXf rounding(matrix.rows(), matrix.cols());
  const VectorXf norms = matrix.rowwise().norm();
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    float largest = 0.0F;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      if (norms[i] > 0.0F) largest = std::max(largest, std::abs(matrix(i, j)) / norms[i]);
    }
    rounding.col(j) = largest / 65534.0F * norms;
  }
  return rounding;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(compact_matrix)

BOOST_AUTO_TEST_CASE(numbers_are_rounded_to_the_unit_of_their_row_and_column) {
  const MatrixXf matrix = numbers_of_many_sizes();
  const CompactMatrix compact(matrix);
  BOOST_TEST(compact.rows() == 37);
  BOOST_TEST(compact.cols() == 5);
  BOOST_TEST(compact.size() == 185);
  const MatrixXf rounding = rounding_of(matrix);
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    const VectorXf column = compact.times(VectorXf::Unit(5, j));
    const VectorXf error = (column - matrix.col(j)).cwiseAbs();
    BOOST_TEST((error.array() <= 1.001F * rounding.col(j).array()).all());
  }
}

BOOST_AUTO_TEST_CASE(products_are_those_of_the_rounded_matrix) {
  const MatrixXf matrix = numbers_of_many_sizes();
  const CompactMatrix compact(matrix);
  MatrixXf rounded(37, 5);
  for (Eigen::Index j = 0; j < 5; ++j) rounded.col(j) = compact.times(VectorXf::Unit(5, j));
  const VectorXf few = VectorXf::LinSpaced(5, -1.0F, 2.0F);
  const VectorXf many = VectorXf::LinSpaced(37, 2.0F, -1.0F);
  BOOST_TEST((compact.times(few) - rounded * few).norm() <= 1e-6F * (rounded * few).norm());
  const VectorXf expected = rounded.transpose() * many;
  BOOST_TEST((compact.transposed_times(many) - expected).norm() <= 1e-6F * expected.norm());
  BOOST_TEST(compact.transposed_times(many)[2] == 0.0F);
}

BOOST_AUTO_TEST_CASE(empty_matrices_and_numbers_that_are_not_finite) {
  BOOST_TEST(CompactMatrix().size() == 0);
  BOOST_TEST(CompactMatrix(MatrixXf(3, 0)).times(VectorXf(0)).norm() == 0.0F);
  BOOST_TEST(CompactMatrix(MatrixXf(3, 0)).times(VectorXf(0)).size() == 3);
  MatrixXf matrix = numbers_of_many_sizes();
  matrix(4, 1) = std::numeric_limits<float>::infinity();
  BOOST_CHECK_THROW(CompactMatrix{matrix}, std::domain_error);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
