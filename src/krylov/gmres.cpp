// Solves linear systems by GMRES: Arnoldi's method (05.3), least squares by Givens rotations (05.4)
// and (05.5), and a preconditioner from the right (05.9).
#include "krylov/gmres.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Jacobi>

#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Rounding error of a product A z, over |A| |z|, with a margin for fast sums.
constexpr double product_rounding = 1e-13;

// The residual of the recurrence is that of the solution if rounding errors are below this part of
// the tolerance.
constexpr double negligible = 0.01;

void require_finite(const VectorXd& v, const char* what, int iteration) {
  require<std::domain_error>(v.allFinite(), "GMRES: ", what,
                             " has an entry that is not finite, at iteration ", iteration);
}

// The least-squares problem min |beta e_1 - H y| of (05.4), kept triangular by Givens rotations.
class HessenbergLeastSquares {
 public:
  explicit HessenbergLeastSquares(double beta) : rhs_{beta} {}

  //! [rotate]
  // Appends column k of H (k + 2 entries) and returns the new residual norm (05.5).
  double append(VectorXd column) {
    const auto k = static_cast<Index>(rotations_.size());
    for (Index i = 0; i < k; ++i) {
      column.applyOnTheLeft(i, i + 1, rotations_[static_cast<std::size_t>(i)].adjoint());
    }
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(column[k], column[k + 1]);
    column.applyOnTheLeft(k, k + 1, rotation.adjoint());
    rotations_.push_back(rotation);
    columns_.push_back(column.head(k + 1));
    Eigen::Vector2d last{rhs_.back(), 0.0};
    last.applyOnTheLeft(0, 1, rotation.adjoint());
    rhs_.back() = last[0];
    rhs_.push_back(last[1]);
    return std::abs(last[1]);
  }
  //! [rotate]

  // Solves the triangular system by back substitution.
  VectorXd solve() const {
    const auto k = static_cast<Index>(columns_.size());
    VectorXd y(k);
    for (Index i = k - 1; i >= 0; --i) {
      double sum = rhs_[static_cast<std::size_t>(i)];
      for (Index j = i + 1; j < k; ++j) sum -= columns_[static_cast<std::size_t>(j)][i] * y[j];
      y[i] = sum / columns_[static_cast<std::size_t>(i)][i];
    }
    return y;
  }

 private:
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  std::vector<VectorXd> columns_;
  std::vector<double> rhs_;
};

}  // namespace

GmresResult gmres(const LinearMap& apply, const LinearMap& precondition, const VectorXd& b,
                  const GmresOptions& options, const VectorXd& guess) {
  require_finite(b, "the right-hand side", 0);
  const double norm = b.norm();
  GmresResult result;
  result.solution = VectorXd::Zero(b.size());
  VectorXd residual = b;
  if (guess.size() > 0) {
    const VectorXd of_guess = b - apply(guess);
    ++result.applications;
    if (of_guess.norm() < norm) {
      residual = of_guess;
      result.solution = guess;
    }
  }
  const double first = residual.norm();
  result.residual = norm > 0.0 ? first / norm : 0.0;
  result.history.push_back(result.residual);
  result.converged = result.residual <= options.tolerance;
  if (result.converged) return result;

  const Index most = std::min<Index>(options.max_iterations, b.size());
  // The basis grows with the iterations: most solves take far fewer than `most`.
  MatrixXd basis(b.size(), std::min<Index>(most, 31) + 1);
  basis.col(0) = residual / first;
  std::vector<VectorXd> preconditioned;
  HessenbergLeastSquares least_squares(first);
  for (Index k = 0; k < most; ++k) {
    //! [arnoldi]
    if (precondition) preconditioned.push_back(precondition(basis.col(k)));
    VectorXd w = apply(precondition ? preconditioned.back() : basis.col(k));
    require_finite(w, "the product with the operator", static_cast<int>(k + 1));
    VectorXd column = VectorXd::Zero(k + 2);
    // Two passes of classical Gram-Schmidt, w -= V (V^T w).
    for (int pass = 0; pass < 2; ++pass) {
      const VectorXd overlap = basis.leftCols(k + 1).transpose() * w;
      w.noalias() -= basis.leftCols(k + 1) * overlap;
      column.head(k + 1) += overlap;
    }
    column[k + 1] = w.norm();
    result.history.push_back(least_squares.append(column) / norm);
    //! [arnoldi]
    ++result.iterations;
    result.converged = result.history.back() <= options.tolerance;
    if (result.converged) break;
    if (k + 2 > basis.cols()) {
      basis.conservativeResize(Eigen::NoChange, std::min(2 * basis.cols(), most + 1));
    }
    basis.col(k + 1) = w / column[k + 1];
  }
  // x = x_0 + sum_k y_k M^{-1} v_k, with the vectors M^{-1} v_k that the iteration has computed.
  const VectorXd y = least_squares.solve();
  double sum_of_norms = 0.0;  // of the terms y_k M^{-1} v_k
  if (precondition) {
    for (Index k = 0; k < y.size(); ++k) {
      const VectorXd& direction = preconditioned[static_cast<std::size_t>(k)];
      result.solution += y[k] * direction;
      sum_of_norms += std::abs(y[k]) * direction.norm();
    }
  } else {
    result.solution += basis.leftCols(y.size()) * y;
    sum_of_norms = y.cwiseAbs().sum();
  }
  result.applications += result.iterations;
  result.residual = result.history.back();
  const double rounding = product_rounding * options.norm * sum_of_norms / norm;
  if (result.converged && rounding <= negligible * options.tolerance) return result;
  result.residual = (b - apply(result.solution)).norm() / norm;
  ++result.applications;
  // Rounding alone makes a smaller difference between the two residuals: 1e-12 for disks that are
  // 1e-7 of their radius apart. If the operator is singular, the residual of the recurrence
  // vanishes, but the true one does not.
  require<std::domain_error>(
      !result.converged || result.residual <= 10.0 * options.tolerance + 1e-11,
      "GMRES broke down: the recurrence has the residual ", result.history.back(),
      ", but the solution has the residual ", result.residual,
      "; the operator is singular to rounding");
  return result;
}

}  // namespace stokesbook
