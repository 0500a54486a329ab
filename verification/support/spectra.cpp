// Computes singular values, eigenvalues and condition numbers of dense matrices, and the spectrum
// of the double layer of an ellipse in closed form (01.10). Eigen's eigenvalues of general matrices
// take long to compile, so this file uses GSL's.
#include "support/spectra.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gsl/gsl_eigen.h>

#include "support/dense.hpp"
#include "support/gsl_matrix.hpp"

namespace stokesbook::test {
namespace {

// Returns the memory of complex numbers in the form of GSL, real and imaginary parts in turn.
template <class Complexes>
double* reals(Complexes& complexes) {
  return reinterpret_cast<double*>(complexes.data());
}

}  // namespace

Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix) {
  // The singular values of A are the eigenvalues >= 0 of (0 A; A^T 0). Eigen's BDCSVD
  // takes long to compile.
  const Eigen::Index rows = matrix.rows(), columns = matrix.cols();
  Eigen::MatrixXd augmented = Eigen::MatrixXd::Zero(rows + columns, rows + columns);
  augmented.bottomLeftCorner(columns, rows) = matrix.transpose();
  return symmetric_eigenvalues(augmented).tail(std::min(rows, columns)).reverse();
}

double condition_number(const Eigen::MatrixXd& matrix) {
  return singular_values(matrix)[0] * singular_values(inverse(matrix))[0];
}

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix) {
  const auto n = static_cast<std::size_t>(matrix.rows());
  RowMajorMatrix copy = matrix;
  gsl_matrix_view a = gsl_view(copy);
  Eigen::VectorXcd values(matrix.rows());
  gsl_vector_complex_view result = gsl_vector_complex_view_array(reals(values), n);
  gsl_eigen_nonsymm_workspace* work = gsl_eigen_nonsymm_alloc(n);
  gsl_eigen_nonsymm(&a.matrix, &result.vector, work);
  gsl_eigen_nonsymm_free(work);
  return values;
}

Eigenpairs eigenpairs(const Eigen::MatrixXd& matrix) {
  const auto n = static_cast<std::size_t>(matrix.rows());
  RowMajorMatrix copy = matrix;
  gsl_matrix_view a = gsl_view(copy);
  Eigen::VectorXcd values(matrix.rows());
  gsl_vector_complex_view result = gsl_vector_complex_view_array(reals(values), n);
  Eigen::MatrixXcd transposed(matrix.rows(), matrix.rows());
  gsl_matrix_complex_view vectors = gsl_matrix_complex_view_array(reals(transposed), n, n);
  gsl_eigen_nonsymmv_workspace* work = gsl_eigen_nonsymmv_alloc(n);
  gsl_eigen_nonsymmv(&a.matrix, &result.vector, &vectors.matrix, work);
  gsl_eigen_nonsymmv_free(work);
  return {values, transposed.transpose()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix) {
  return matrix.selfadjointView<Eigen::Lower>().eigenvalues();
}

double spectrum_distance(const Eigen::VectorXcd& values, const Eigen::VectorXd& known,
                         Eigen::Index outer) {
  if (values.size() != known.size() || outer > known.size()) {
    throw std::invalid_argument("spectrum_distance: sizes differ");
  }
  Eigen::VectorXcd computed = values;
  Eigen::VectorXd sorted = known;
  std::ranges::sort(computed, {}, [](Complex value) { return value.real(); });
  std::ranges::sort(sorted);
  const Eigen::ArrayXd distances = (computed - sorted).cwiseAbs();
  return std::max(distances.head(outer).maxCoeff(), distances.tail(outer).maxCoeff());
}

double spectrum_distance(const Eigen::VectorXcd& values, const Eigen::VectorXd& known) {
  return spectrum_distance(values, known, known.size());
}

Eigen::VectorXd ellipse_spectrum(const Ellipse& ellipse, Side side, Eigen::Index nodes) {
  const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
  const double of_constants = side == Side::fluid_outside ? 0.5 : -0.5;
  std::vector<double> values{of_constants, of_constants};
  for (Eigen::Index n = 1; n < nodes / 2; ++n) {
    const auto k = static_cast<double>(n);
    const double c = (1.0 - m * m) * k * std::pow(m, k - 1.0);
    const double root = std::hypot(c, 2.0 * std::pow(m, k));
    for (const double sum : {c + root, c - root, -c + root, -c - root}) {
      values.push_back(0.25 * sum);
    }
  }
  values.resize(static_cast<std::size_t>(2 * nodes), 0.0);  // modes from N / 2 on are below m^{N/2}
  std::ranges::sort(values);
  return Eigen::Map<Eigen::VectorXd>(values.data(), 2 * nodes);
}

}  // namespace stokesbook::test
