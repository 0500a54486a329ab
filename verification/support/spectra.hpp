#pragma once

#include <Eigen/Core>

#include "trapezoid/curve.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook::test {

/// Returns the singular values, largest first. Each value has an error of a few hundred rounding
/// units of the largest value.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// Returns the condition number |A| |A^-1| in the 2-norm. The relative error of the result is the
/// condition number times the rounding unit. The quotient of the extreme singular values of A would
/// be less accurate.
double condition_number(const Eigen::MatrixXd& matrix);

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

/// Holds eigenvalues, and eigenvectors as columns in the same order.
struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};

Eigenpairs eigenpairs(const Eigen::MatrixXd& matrix);

/// Returns the eigenvalues of a symmetric matrix, smallest first. Only the lower triangle is read.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& matrix);

/// Compares the eigenvalues of a matrix with real numbers. Each number occurs as often as its
/// multiplicity. The function sorts both lists by real parts, and returns the largest distance
/// between two values of equal rank.
///
/// @param  values  n eigenvalues
/// @param  known   n numbers
/// @param  outer   how many values are compared at either end, at most n
/// @return         distance
double spectrum_distance(const Eigen::VectorXcd& values, const Eigen::VectorXd& known,
                         Eigen::Index outer);

/// Compares all n eigenvalues.
double spectrum_distance(const Eigen::VectorXcd& values, const Eigen::VectorXd& known);

/// Returns the eigenvalues of the double layer of an ellipse in closed form (01.10). The list
/// contains the eigenvalues of the constants and of the modes that N nodes resolve.
///
/// @param  ellipse  major axis first
/// @param  side     where the fluid is
/// @param  nodes    N, even
/// @return          2N eigenvalues, ascending
Eigen::VectorXd ellipse_spectrum(const Ellipse& ellipse, Side side, Eigen::Index nodes);

}  // namespace stokesbook::test
