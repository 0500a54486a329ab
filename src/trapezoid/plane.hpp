#pragma once

#include <complex>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup trapezoid
/// @{

/// A point or vector of the plane, \f$ v = v_1 + i v_2 \f$; a product with \f$ e^{i\theta} \f$
/// turns it counter-clockwise by \f$ \theta \f$.
using Complex = std::complex<double>;

/// Plane vectors, one entry a node, in node order (2 contiguous doubles each).
using ComplexVector = Eigen::VectorXcd;

/// Imaginary unit.
inline constexpr Complex imaginary{0.0, 1.0};

/// Scalar product \f$ a \cdot b = \mathrm{Re}(\bar a b) \f$.
inline double dot(Complex a, Complex b) {
  return a.real() * b.real() + a.imag() * b.imag();
}

/// Cross product \f$ a \times b = a_1 b_2 - a_2 b_1 = a^\perp \cdot b \f$ (torque of b with arm a).
inline double cross(Complex a, Complex b) {
  return a.real() * b.imag() - a.imag() * b.real();
}

/// Rotation by +90 degrees, \f$ a^\perp = (-a_2, a_1) = i a \f$.
inline Complex perp(Complex a) {
  return {-a.imag(), a.real()};
}

/// @}

}  // namespace stokesbook
