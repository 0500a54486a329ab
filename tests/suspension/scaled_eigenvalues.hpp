#pragma once

#include "support/spectra.hpp"

namespace stokesbook::test {

/// Returns the eigenvalues of the symmetric part of a mobility that is scaled to a unit diagonal,
/// in ascending order.
inline Eigen::VectorXd scaled_eigenvalues(const Eigen::MatrixXd& works) {
  const Eigen::VectorXd unit = works.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = unit.asDiagonal() * works * unit.asDiagonal();
  return symmetric_eigenvalues(0.5 * (scaled + scaled.transpose()));
}

}  // namespace stokesbook::test
