#pragma once

#include <complex>

#include <Eigen/Core>

/// The libraries of the book.
namespace stokesbook {

/// A point or vector of the plane, \f$ v = v_1 + i v_2 \f$. Multiplication by
/// \f$ e^{i\theta} \f$ turns the vector counter-clockwise by \f$ \theta \f$.
using Complex = std::complex<double>;

/// Plane vectors, one entry per node, in node order (2 contiguous doubles each).
using ComplexVector = Eigen::VectorXcd;

/// Imaginary unit.
inline constexpr Complex imaginary{0.0, 1.0};

/// Returns the scalar product \f$ a \cdot b = \mathrm{Re}(\bar a b) \f$.
inline double dot(Complex a, Complex b) {
  return a.real() * b.real() + a.imag() * b.imag();
}

/// Returns the cross product \f$ a \times b = a_1 b_2 - a_2 b_1 = a^\perp \cdot b \f$: the torque
/// of a force b with the arm a, > 0 if b points counter-clockwise of a.
inline double cross(Complex a, Complex b) {
  return a.real() * b.imag() - a.imag() * b.real();
}

/// Turns a vector by +90 degrees, \f$ a^\perp = (-a_2, a_1) = i a \f$.
inline Complex perp(Complex a) {
  return {-a.imag(), a.real()};
}

/// Position and orientation of the frame of a curve or a component.
struct Pose {
  Complex position;          ///< position of the frame's origin, length
  double orientation = 0.0;  ///< radians, counter-clockwise
};

}  // namespace stokesbook
