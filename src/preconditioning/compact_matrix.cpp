// Stores matrices of a preconditioner with 16 bits a number, and multiplies them by vectors
// (chapter 13, section "A tree of groups").
#include "preconditioning/compact_matrix.hpp"

#include <cmath>

#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXf;
using Eigen::VectorXf;

CompactMatrix::CompactMatrix(const MatrixXf& matrix)
    : numbers_(matrix.rows(), matrix.cols()), units_(matrix.cols()) {
  require<std::domain_error>(matrix.allFinite(),
                             "a matrix to be rounded has a number that is not finite");
  if (matrix.rows() == 0) return;
  norms_ = matrix.rowwise().norm();
  norms_ = (norms_.array() > 0.0F).select(norms_, 1.0F);
  for (Index j = 0; j < matrix.cols(); ++j) {
    const VectorXf column = matrix.col(j).cwiseQuotient(norms_);
    const float largest = column.cwiseAbs().maxCoeff();
    units_[j] = largest / 32767.0F;
    const float factor = largest > 0.0F ? 32767.0F / largest : 0.0F;
    numbers_.col(j) = (factor * column).array().round().cast<std::int16_t>();
  }
}

MatrixXf CompactMatrix::unpacked() const {
  return norms_.asDiagonal() * numbers_.cast<float>() * units_.asDiagonal();
}

VectorXf CompactMatrix::times(const Eigen::Ref<const VectorXf>& v) const {
  VectorXf result = VectorXf::Zero(rows());
  float* sum = result.data();
  for (Index j = 0; j < cols(); ++j) {
    const float factor = units_[j] * v[j];
    const std::int16_t* column = numbers_.data() + j * rows();
#pragma omp simd
    for (Index i = 0; i < rows(); ++i) sum[i] += factor * static_cast<float>(column[i]);
  }
  return result.cwiseProduct(norms_);
}

VectorXf CompactMatrix::transposed_times(const Eigen::Ref<const VectorXf>& v) const {
  VectorXf result(cols());
  const VectorXf scaled = v.cwiseProduct(norms_);
  const float* factors = scaled.data();
  for (Index j = 0; j < cols(); ++j) {
    const std::int16_t* column = numbers_.data() + j * rows();
    float sum = 0.0F;
#pragma omp simd reduction(+ : sum)
    for (Index i = 0; i < rows(); ++i) sum += factors[i] * static_cast<float>(column[i]);
    result[j] = units_[j] * sum;
  }
  return result;
}

}  // namespace stokesbook
