// Evaluates points and derivatives of the shapes: from the formula of an analytic shape, and from
// the trigonometric interpolant of a NodalCurve.
#include "trapezoid/shape.hpp"

#include <cmath>

namespace stokesbook {

using Eigen::Index;

namespace {

using Jet = TrigonometricPolynomial::Jet;

// Evaluates the curve r(t) e^{it} and its derivatives from those of the radius.
Jet polar_curve(double t, double r, double dr, double ddr) {
  const Complex direction = std::polar(1.0, t);
  return {r * direction, (dr + imaginary * r) * direction,
          (ddr - r + 2.0 * imaginary * dr) * direction};
}

Jet point(const Circle& circle, double t) {
  return polar_curve(t, circle.radius, 0.0, 0.0);
}

Jet point(const Ellipse& ellipse, double t) {
  const Complex x{ellipse.a * std::cos(t), ellipse.b * std::sin(t)};
  return {x, {-ellipse.a * std::sin(t), ellipse.b * std::cos(t)}, -x};
}

Jet point(const Star& star, double t) {
  const double k = star.arms;
  const double wave = star.radius * star.amplitude;
  return polar_curve(t, star.radius + wave * std::cos(k * t), -wave * k * std::sin(k * t),
                     -wave * k * k * std::cos(k * t));
}

// x = rho(t) (a cos t, b sin t) with rho = g^{-1/p}, g = cos^p t + sin^p t, hence
// rho' = -rho g' / (p g).
Jet point(const Superellipse& shape, double t) {
  const int p = shape.power;
  const double c = std::cos(t), s = std::sin(t);
  const double cp = std::pow(c, p - 2), sp = std::pow(s, p - 2);
  const double g = cp * c * c + sp * s * s;
  const double dg = p * s * c * (sp - cp);
  const double ddg = p * ((p - 1) * (sp * c * c + cp * s * s) - g);
  const double rho = std::pow(g, -1.0 / p);
  const double log_slope = -dg / (p * g);
  const double drho = rho * log_slope;
  const double ddrho = rho * (log_slope * log_slope - (ddg * g - dg * dg) / (p * g * g));
  const Jet unit = polar_curve(t, rho, drho, ddrho);
  const auto scale = [&](Complex z) { return Complex{shape.a * z.real(), shape.b * z.imag()}; };
  return {scale(unit.value), scale(unit.first), scale(unit.second)};
}

template <class AnalyticShape>
Parametrisation parametrise(const AnalyticShape& shape) {
  return [shape](double t) { return point(shape, t); };
}

Parametrisation parametrise(const NodalCurve& shape) {
  return TrigonometricPolynomial(counter_clockwise(shape));
}

// Returns the area (1 / 2) sum_j x_{j-1} cross x_j of a polygon, > 0 if counter-clockwise.
double shoelace_area(const ComplexVector& polygon) {
  double twice_area = cross(polygon[polygon.size() - 1], polygon[0]);
  for (Index j = 1; j < polygon.size(); ++j) {
    twice_area += cross(polygon[j - 1], polygon[j]);
  }
  return 0.5 * twice_area;
}

}  // namespace

Parametrisation parametrisation(const Shape& shape) {
  return std::visit([](const auto& s) { return parametrise(s); }, shape);
}

Shape scaled(Shape shape, double factor) {
  const auto enlarge = [factor](auto& s) {
    if constexpr (requires { s.radius; }) s.radius *= factor;
    if constexpr (requires { s.a, s.b; }) s.a *= factor, s.b *= factor;
    if constexpr (requires { s.points; }) s.points *= factor;
  };
  std::visit(enlarge, shape);
  return shape;
}

ComplexVector counter_clockwise(const NodalCurve& shape) {
  ComplexVector points = shape.points;
  if (shoelace_area(points) < 0.0) points.reverseInPlace();
  return points;
}

}  // namespace stokesbook
