#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace stokesbook {

/// A matrix with 16 bits for each number: half the memory of single precision, and half the time of
/// products with vectors, which wait for the memory. Rows are scaled to the same norm, and then
/// numbers are rounded to units of a 32767th of the largest one of their column. Without the scales,
/// the small rows of the inverse of a nearly singular matrix would be lost beside the large ones.
class CompactMatrix {
 public:
  CompactMatrix() = default;  ///< holds a matrix without rows and columns

  /// Rounds a matrix.
  ///
  /// @throws std::domain_error when a number is not finite
  explicit CompactMatrix(const Eigen::MatrixXf& matrix);

  Eigen::Index rows() const { return numbers_.rows(); }  ///< returns the number of rows
  Eigen::Index cols() const { return numbers_.cols(); }  ///< returns the number of columns
  Eigen::Index size() const { return numbers_.size(); }  ///< returns how many numbers there are

  /// Returns the rounded numbers in single precision.
  Eigen::MatrixXf unpacked() const;

  /// Multiplies the matrix by a vector.
  Eigen::VectorXf times(const Eigen::Ref<const Eigen::VectorXf>& v) const;

  /// Multiplies the transposed matrix by a vector.
  Eigen::VectorXf transposed_times(const Eigen::Ref<const Eigen::VectorXf>& v) const;

 private:
  Eigen::Matrix<std::int16_t, Eigen::Dynamic, Eigen::Dynamic> numbers_;
  Eigen::VectorXf norms_;  // of the rows, 1 for a row of zeros
  Eigen::VectorXf units_;  // one for each column
};

}  // namespace stokesbook
