#pragma once

#include <vector>

#include "trapezoid/curve.hpp"

namespace stokesbook::test {

/// Describes a stresslet and a source of fluid at one point. The flow of both exerts neither a
/// force nor a torque.
struct Pole {
  Complex at;
  Complex dipole;       ///< a of the Goursat function phi = a / r
  double source = 0.0;  ///< m of the radial flow m r / rho^2
};

/// Describes an exact Stokes flow of viscosity 1: the sum of poles outside the fluid and the
/// extension e (x, -y).
///
/// \f$ u = \sum [a/r + r\,\overline{a/r^2} + m/\bar r] + e\bar z,\ r = z - z_k \f$, which is
/// u = phi - z conj(phi') - conj(psi) with p = -4 Re phi'. The formula is independent of the
/// kernels under test.
struct ExactFlow {
  std::vector<Pole> poles;
  double extension = 0.0;

  Complex velocity(Complex z) const {
    Complex u = extension * std::conj(z);
    for (const Pole& pole : poles) {
      const Complex r = z - pole.at;
      u += pole.dipole / r + r * std::conj(pole.dipole / (r * r)) + pole.source / std::conj(r);
    }
    return u;
  }

  ComplexVector velocity(const ComplexVector& z) const {
    return z.unaryExpr([this](Complex point) { return velocity(point); });
  }

  double pressure(Complex z) const {
    double p = 0.0;
    for (const Pole& pole : poles) {
      const Complex r = z - pole.at;
      p += 4.0 * (pole.dipole / (r * r)).real();
    }
    return p;
  }

  double vorticity(Complex z) const {
    double w = 0.0;
    for (const Pole& pole : poles) {
      const Complex r = z - pole.at;
      w -= 4.0 * (pole.dipole / (r * r)).imag();
    }
    return w;
  }

  /// Returns the rate of strain q = e_11 - e_22 + 2 i e_12 = 2 du/d(conj z).
  Complex strain(Complex z) const {
    Complex slope = extension;
    for (const Pole& pole : poles) {
      const Complex r = std::conj(z - pole.at);
      slope -= (2.0 * std::conj(r * pole.dipole) / r + pole.source) / (r * r);
    }
    return 2.0 * slope;
  }

  /// Returns the traction sigma n, computed with 2 e n = q conj(n).
  Complex traction(Complex z, Complex n) const {
    return -pressure(z) * n + strain(z) * std::conj(n);
  }
};

/// These two flows have poles inside a body and outside a container, respectively. The body and the
/// container have sizes of about 1.
inline const ExactFlow inner_poles{
    {{{0.1, 0.01}, {0.5, -0.3}, 0.4}, {{-0.2, -0.01}, {0.1, 0.8}, -0.1}}};
inline const ExactFlow outer_poles{
    {{{3.0, 1.0}, {0.5, -0.3}, 0.4}, {{-1.5, 2.5}, {0.1, 0.8}, -0.1}}, 0.7};

}  // namespace stokesbook::test
