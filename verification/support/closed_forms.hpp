#pragma once

#include <cmath>
#include <numbers>

#include "closure/closure.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook::test {

/// Returns the motion of a loaded ellipse in an unbounded quiescent fluid, in closed form (03.13).
/// The velocity in the ellipse's frame is
/// U_1 = F_1 / (4 pi mu) [-log((a + b) / (2 ell)) + a / (a + b)]; U_2 has b / (a + b) in place of
/// a / (a + b). The angular velocity is omega = L / (2 pi mu (a^2 + b^2)).
inline RigidMotion loaded_ellipse(const Ellipse& ellipse, double orientation, const Load& load,
                                  double mu, double ell) {
  const auto [a, b] = ellipse;
  const Complex turn = std::polar(1.0, orientation);
  const Complex force = load.force / turn;
  const double mean = -std::log((a + b) / (2.0 * ell));
  const Complex velocity{(mean + a / (a + b)) * force.real(), (mean + b / (a + b)) * force.imag()};
  using std::numbers::pi;
  return {turn * velocity / (4.0 * pi * mu), load.torque / (2.0 * pi * mu * (a * a + b * b))};
}

/// Returns the angular velocity of a free ellipse in a linear flow (Jeffery). The strain rates are
/// e11 = -e22 and e12.
inline double free_ellipse_omega(const Ellipse& ellipse, double orientation, double vorticity,
                                 double e11, double e12) {
  const double a2 = ellipse.a * ellipse.a, b2 = ellipse.b * ellipse.b;
  const double strain = e12 * std::cos(2 * orientation) - e11 * std::sin(2 * orientation);
  return 0.5 * vorticity + (a2 - b2) / (a2 + b2) * strain;
}

/// Returns the velocity around a circle of radius a about the origin on which a force F acts:
/// [-log(rho / ell) F + r (r.F) / rho^2 + a^2 / (2 rho^2) (F - 2 r (r.F) / rho^2)] / (4 pi mu).
inline Complex velocity_around_circle(Complex r, double a, Complex force, double mu, double ell) {
  const double rho2 = std::norm(r);
  const Complex along = r * (dot(r, force) / rho2);
  const Complex sum = -0.5 * std::log(rho2 / (ell * ell)) * force + along +
                      a * a / (2 * rho2) * (force - 2.0 * along);
  return sum / (4.0 * std::numbers::pi * mu);
}

/// Describes two equal circles of radius a whose centres are 2 a cosh(alpha) apart.
struct CirclePair {
  double a, gap;

  double alpha() const { return 2.0 * std::asinh(std::sqrt(gap / (4.0 * a))); }

  /// Returns the speed of either circle in the flow u = e (x, -y), whose x axis is the line of
  /// centres. The speed is along this line, and positive if the circles separate.
  double speed_in_extension(double e) const {
    return 2 * a * e * std::pow(std::sinh(alpha()), 3) / std::cosh(2 * alpha());
  }
  /// Returns the speed of either circle if opposite forces F pull the two circles apart.
  double speed_of_pull(double force, double mu) const {
    return force / (4 * std::numbers::pi * mu) * (alpha() - std::tanh(2 * alpha()) / 2);
  }
  /// Returns the angular velocity of either circle if a force F perpendicular to the line of
  /// centres acts on each circle.
  double turn_of_settling(double force, double mu) const {
    return force * std::sinh(alpha()) / (4 * std::numbers::pi * mu * a * std::cosh(2 * alpha()));
  }
};

}  // namespace stokesbook::test
