#pragma once

#include <Eigen/Core>
#include <gsl/gsl_matrix.h>

namespace stokesbook::test {

/// A matrix with the memory layout of GSL.
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Returns the matrix as a parameter for functions of GSL, which may change it. GSL stops the program
/// if the matrix is empty.
inline gsl_matrix_view gsl_view(RowMajorMatrix& matrix) {
  return gsl_matrix_view_array(matrix.data(), static_cast<std::size_t>(matrix.rows()),
                               static_cast<std::size_t>(matrix.cols()));
}

/// Returns the vector as a parameter for functions of GSL, which may change it.
template <class Vector>
gsl_vector_view gsl_view(Vector& vector) {
  return gsl_vector_view_array(vector.data(), static_cast<std::size_t>(vector.size()));
}

}  // namespace stokesbook::test
