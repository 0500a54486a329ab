// Exercise 06.3: barycentric sums, right and broken.
#include "chapters/exercise.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

/// A function's value at a point of the fluid, from its values at the nodes of a body.
using Evaluation = std::function<Complex(const Curve& body, const ComplexVector& f, Complex z)>;

// Task 1: f(z), where z is in the fluid outside, or a node.
Complex right(const Curve& body, const ComplexVector& f, Complex z) {
  //@ starter
  not_done(body, f, z);  // your code instead of this line
  //@ solution
  const Complex factor = -1.0 / (imaginary * static_cast<double>(body.size()));
  Complex sum{}, delta = 1.0;
  for (Eigen::Index j = 0; j < body.size(); ++j) {
    if (body.x[j] == z) return f[j];
    const Complex w = factor * body.dx[j] / (body.x[j] - z);
    sum += w * f[j];
    delta += w;
  }
  return sum / delta;
  //@ wrong not_a_number: a node is divided by zero
  const Complex factor = -1.0 / (imaginary * static_cast<double>(body.size()));
  Complex sum{}, delta = 1.0;
  for (Eigen::Index j = 0; j < body.size(); ++j) {
    const Complex w = factor * body.dx[j] / (body.x[j] - z);
    sum += w * f[j];
    delta += w;
  }
  return sum / delta;
  //@ wrong wall: the 1 of a body is missing
  const Complex factor = -1.0 / (imaginary * static_cast<double>(body.size()));
  Complex sum{}, delta{};
  for (Eigen::Index j = 0; j < body.size(); ++j) {
    if (body.x[j] == z) return f[j];
    const Complex w = factor * body.dx[j] / (body.x[j] - z);
    sum += w * f[j];
    delta += w;
  }
  return sum / delta;
  //@ end
}

// Task 2: what a broken formula returns, over f(z). Mistakes: "without_one", "undivided",
// "reversed".
Complex factor(const std::string& mistake, Complex q) {
  //@ starter
  not_done(mistake, q);  // your code instead of this line
  //@ solution
  if (mistake == "without_one") return 1.0 / q;
  if (mistake == "undivided") return 1.0 / (1.0 - q);
  return -1.0 / (1.0 - 2.0 * q);
  //@ wrong sign_only: the divisor changes with the weights
  if (mistake == "without_one") return 1.0 / q;
  if (mistake == "undivided") return 1.0 / (1.0 - q);
  return -1.0;
  //@ wrong inverse: the factor is inverted
  if (mistake == "without_one") return q;
  if (mistake == "undivided") return 1.0 - q;
  return -1.0 / (1.0 - 2.0 * q);
  //@ end
}

// Task 3: "right", "without_one", "undivided" or "reversed".
std::string diagnose(const Evaluation& evaluation) {
  //@ starter
  not_done(evaluation);  // your code instead of this line
  //@ solution
  const Curve circle = sample(Circle{1.0}, 32, Side::fluid_outside);
  const ComplexVector f = circle.x.cwiseInverse();
  const Complex z = std::polar(1.05, 0.3);  // x(t) = exp(i t): q = z^-N
  const Complex q = std::pow(z, -32), ratio = evaluation(circle, f, z) * z;
  for (const char* mistake : {"without_one", "undivided", "reversed"}) {
    if (std::abs(ratio / factor(mistake, q) - 1.0) < 1e-6) return mistake;
  }
  return "right";
  //@ wrong from_afar: found right, but the mistake is undivided
  const Curve circle = sample(Circle{1.0}, 32, Side::fluid_outside);
  const ComplexVector f = circle.x.cwiseInverse();
  const Complex z = std::polar(4.0, 0.3), ratio = evaluation(circle, f, z) * z;
  return std::abs(ratio - 1.0) < 1e-6 ? "right"
         : std::abs(ratio) > 2.0      ? "without_one"
                                      : "reversed";
  //@ end
}
