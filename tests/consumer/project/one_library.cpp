// Computes the perimeter of the unit circle and the derivative of e^{it} by the trapezoid library
// (chapter 01).

#include <cmath>
#include <iostream>
#include <numbers>

#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"

int main() {
  using namespace stokesbook;
  const Curve circle = sample(Circle{.radius = 1.0}, 32, Side::fluid_outside);
  const double perimeter_error = std::abs(perimeter(circle) - 2.0 * std::numbers::pi);
  const ComplexVector tangent = differentiate(circle.x);
  const double derivative_error = (tangent - imaginary * circle.x).norm();
  std::cout << "errors " << perimeter_error << ' ' << derivative_error << '\n';
  return perimeter_error < 1e-13 && derivative_error < 1e-13 ? 0 : 1;
}
