#pragma once

#include <vector>

#include <Eigen/Core>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// Computes the Fourier coefficients \f$ c_k = \frac1N \sum_j f(t_j) e^{-i k t_j} \f$,
/// \f$ t_j = 2\pi j/N \f$.
///
/// @param  f  values at the N nodes, in node order, any N >= 1
/// @return    N coefficients for k = 0, 1, ..., N/2-1, -N/2, ..., -1, unit of f
/// @par Cost  O(N log N) (GSL's mixed-radix transform; O(N^2) if N is prime)
ComplexVector fourier_coefficients(const ComplexVector& f);

/// Computes the values \f$ f(t_j) = \sum_k c_k e^{i k t_j} \f$: the inverse of
/// fourier_coefficients(), at the same cost.
ComplexVector fourier_values(const ComplexVector& c);

/// Returns the wave number k, from -n/2 to (n-1)/2, of entry i of n Fourier coefficients.
Eigen::Index wave_number(Eigen::Index i, Eigen::Index n);

/// Differentiates the trigonometric interpolant with respect to the parameter t.
///
/// The mode k = -N/2 is dropped: it stands for cos(N t / 2), whose derivative vanishes at every
/// node.
/// @throws std::invalid_argument when N is odd or 0
/// @par Accuracy  geometric in N for analytic f: @ref claim_01_8
/// @par Cost      O(N log N)
ComplexVector differentiate(const ComplexVector& f);

/// Returns the n x n matrix of differentiate(): \f$ \frac12 (-1)^{j-k} \cot\frac{t_j-t_k}{2} \f$,
/// 0 for j = k.
///
/// @throws std::invalid_argument when n is odd or < 2
/// @par Not for   single vectors: differentiate() is faster
/// @sa source: Trefethen, Spectral Methods in MATLAB, 2000, chapter 3
Eigen::MatrixXd differentiation_matrix(Eigen::Index n);

/// Evaluates the trigonometric interpolant of node values at m equidistant nodes.
///
/// @param  f  values at N nodes, any N >= 1
/// @param  m  number of new nodes, even; m < N truncates the series
/// @throws std::invalid_argument when m is odd or < 2
/// @par Accuracy  geometric in the smaller of N and m for analytic f: @ref claim_01_7; m >= N keeps
/// the interpolant
/// @par Cost      O(N log N + m log m)
ComplexVector resample(const ComplexVector& f, Eigen::Index m);

/// Returns the weights with which node values enter the trigonometric interpolant at a parameter:
/// \f$ \frac1N \sin\frac{N\tau}{2} \cot\frac{\tau}{2},\ \tau = t - t_j \f$.
///
/// @param  t  radians, any real number
/// @throws std::invalid_argument when n is odd or < 2
/// @par Accuracy  of the interpolant: geometric in N for analytic functions: @ref claim_01_7
/// @par Cost      O(N)
/// @par Not for   many values of one function: use TrigonometricPolynomial
Eigen::RowVectorXd interpolation_weights(Eigen::Index n, double t);

/// Interpolates the values of several functions to the same n parameters, radians.
///
/// @param  f  N x m, a column of node values for each function
/// @return    n x m
/// @throws std::invalid_argument when N is odd or 0
/// @par Accuracy  geometric in N for analytic functions: @ref claim_01_7
/// @par Cost      O(N n m): a matrix of N n modes, multiplied by the coefficients
Eigen::MatrixXcd interpolated(const Eigen::MatrixXcd& f, const std::vector<double>& parameters);

/// Returns the largest coefficient of the highest modes: max |c_k| over |k| >= N/2 - max(2, N/16).
///
/// For a resolved analytic function, this coefficient has the size of the interpolation error.
/// @throws std::invalid_argument when N is odd or 0
double fourier_tail(const ComplexVector& f);

/// A trigonometric polynomial, which can be evaluated at any parameter.
class TrigonometricPolynomial {
 public:
  /// Value and first two derivatives with respect to the parameter, all in the unit of the values.
  struct Jet {
    Complex value,  ///< p(t)
        first,      ///< p'(t)
        second;     ///< p''(t)
  };

  /// Interpolates values at equidistant nodes.
  ///
  /// @throws std::invalid_argument when the number N of values is 0
  /// @par Accuracy  geometric in N for analytic functions: @ref claim_01_7
  /// @par Cost      O(N log N)
  explicit TrigonometricPolynomial(const ComplexVector& values);

  /// Evaluates the polynomial and its derivatives at any real t, radians, by O(N) operations.
  Jet operator()(double t) const;

 private:
  ComplexVector coefficients_;  // k ascending from -m to m, m = N/2 rounded down
};

}  // namespace stokesbook
