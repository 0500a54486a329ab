#pragma once

#include <Eigen/Core>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup trapezoid
/// @{

/// Computes the Fourier coefficients \f$ c_k = \frac1N \sum_j f(t_j) e^{-i k t_j} \f$,
/// \f$ t_j = 2\pi j/N \f$.
///
/// @param  f  values at the N nodes, in node order
/// @return    N coefficients for k = 0, 1, ..., N/2-1, -N/2, ..., -1
/// @par Cost  O(N log N) (GSL's mixed-radix transform; any N)
ComplexVector fourier_coefficients(const ComplexVector& f);

/// Computes the values \f$ f(t_j) = \sum_k c_k e^{i k t_j} \f$, inverse of fourier_coefficients().
///
/// @param  c  N coefficients, ordered as by fourier_coefficients()
/// @return    values at the N nodes
ComplexVector fourier_values(const ComplexVector& c);

/// Returns the wave number k of entry i of N Fourier coefficients.
Eigen::Index wave_number(Eigen::Index i, Eigen::Index n);

/// Differentiates the trigonometric interpolant with respect to the parameter t.
///
/// The mode k = -N/2 has no derivative that is a trigonometric polynomial of the same degree; it is
/// dropped.
/// @param  f  values at the N nodes, N even
/// @return    derivative at the same nodes, unit of f
/// @par Accuracy  geometric in N for analytic f
/// @par Cost      O(N log N)
ComplexVector differentiate(const ComplexVector& f);

/// Returns the matrix that differentiates node values:
/// \f$ \frac12 (-1)^{j-k} \cot\frac{t_j-t_k}{2} \f$, 0 for j = k.
///
/// @param  n  number of nodes, even
/// @return    n x n, the same map as differentiate()
/// @sa source: Trefethen, Spectral Methods in MATLAB, 2000, chapter 3
Eigen::MatrixXd differentiation_matrix(Eigen::Index n);

/// Interpolates the values to m equidistant nodes, from the same trigonometric polynomial.
///
/// @param  f  values at N nodes, any N >= 1
/// @param  m  number of new nodes, even; m < N truncates the series
/// @return    values at the m nodes
ComplexVector resample(const ComplexVector& f, Eigen::Index m);

/// Measures what the highest modes carry: max |c_k| over |k| >= N/2 - N/16 (at least N/2 - 2).
///
/// For a resolved analytic function this is the size of the interpolation error.
/// @param  f  values at the N nodes, N even
/// @return    largest modulus of the tail's coefficients, unit of f
double fourier_tail(const ComplexVector& f);

/// A trigonometric polynomial, evaluated anywhere.
class TrigonometricPolynomial {
 public:
  /// Value and first two derivatives with respect to the parameter.
  struct Jet {
    Complex value, first, second;
  };

  /// Interpolates the values at N equidistant nodes, N even.
  explicit TrigonometricPolynomial(const ComplexVector& values);

  /// Evaluates at the parameter t. Cost: O(N).
  Jet operator()(double t) const;

 private:
  ComplexVector coefficients_;  // k = -N/2 ... N/2, ascending
};

/// @}

}  // namespace stokesbook
