#pragma once

#include <Eigen/Core>

#include "trapezoid/curve.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook::test {

/// Largest first; each to a few hundred rounding units of the largest.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// |A| |A^-1| in the 2-norm, to a relative error of the condition number in rounding units: the
/// least singular value itself would be worse.
double condition_number(const Eigen::MatrixXd& matrix);

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

/// Eigenvalues, and the eigenvectors as columns in the same order.
struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};

Eigenpairs eigenpairs(const Eigen::MatrixXd& matrix);

/// Of a symmetric matrix, of which only the lower half is read; smallest first.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// Compares the eigenvalues of a matrix with real numbers, each as often as it occurs: sorts both
/// by their real parts, and takes the largest distance of two in the same place.
///
/// @param  values  n eigenvalues
/// @param  known   n numbers
/// @param  outer   how many at either end are compared, at most n
/// @return         distance
double spectrum_distance(const Eigen::VectorXcd& values, const Eigen::VectorXd& known,
                         Eigen::Index outer);

/// The same for all n of them.
double spectrum_distance(const Eigen::VectorXcd& values, const Eigen::VectorXd& known);

/// Eigenvalues of the double layer of an ellipse in closed form (01.10): of constants and of the
/// modes that N nodes resolve.
///
/// @param  ellipse  major axis first
/// @param  side     where the fluid is
/// @param  nodes    N, even
/// @return          2N eigenvalues, ascending
Eigen::VectorXd ellipse_spectrum(const Ellipse& ellipse, Side side, Eigen::Index nodes);

}  // namespace stokesbook::test
