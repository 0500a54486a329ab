#pragma once

#include "trapezoid/plane.hpp"

namespace stokesbook::test {

/// The step of the differences is 0.01. If a field varies over lengths of order 1, truncation and
/// rounding errors are then both near 1e-12.
inline constexpr double difference_step = 0.01;

/// Returns the derivative of a field along a direction of the plane, by central differences of
/// order 8.
template <class Field>
auto derivative(const Field& f, Complex z, Complex direction) {
  const Complex h = difference_step * direction;
  const auto odd = [&](double k) { return f(z + k * h) - f(z - k * h); };
  return (4.0 / 5.0 * odd(1.0) - 1.0 / 5.0 * odd(2.0) + 4.0 / 105.0 * odd(3.0) -
          1.0 / 280.0 * odd(4.0)) /
         difference_step;
}

/// Returns the Laplacian of a field, by central differences of order 8.
template <class Field>
auto laplacian(const Field& f, Complex z) {
  const auto ring = [&](double k) {
    const double h = k * difference_step;
    return f(z + h) + f(z - h) + f(z + imaginary * h) + f(z - imaginary * h);
  };
  return (8.0 / 5.0 * ring(1.0) - 1.0 / 5.0 * ring(2.0) + 8.0 / 315.0 * ring(3.0) -
          1.0 / 560.0 * ring(4.0) - 205.0 / 36.0 * f(z)) /
         (difference_step * difference_step);
}

/// Returns the divergence of a velocity field.
template <class Velocity>
double divergence(const Velocity& u, Complex z) {
  return derivative(u, z, 1.0).real() + derivative(u, z, imaginary).imag();
}

/// Returns the residual of the Stokes equation, mu Lap u - grad p.
template <class Velocity, class Pressure>
Complex momentum_residual(const Velocity& u, const Pressure& p, double mu, Complex z) {
  return mu * laplacian(u, z) - Complex{derivative(p, z, 1.0), derivative(p, z, imaginary)};
}

/// Returns the traction sigma n with sigma = -p I + mu (grad u + grad u^T).
template <class Velocity, class Pressure>
Complex traction(const Velocity& u, const Pressure& p, double mu, Complex z, Complex n) {
  const Complex along_1 = derivative(u, z, 1.0), along_2 = derivative(u, z, imaginary);
  const double shear = along_1.imag() + along_2.real();
  const Complex stretched{2.0 * along_1.real() * n.real() + shear * n.imag(),
                          shear * n.real() + 2.0 * along_2.imag() * n.imag()};
  return mu * stretched - p(z) * n;
}

}  // namespace stokesbook::test
