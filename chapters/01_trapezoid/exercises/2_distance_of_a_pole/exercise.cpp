// Exercise 01.2: how fast the trapezoid rule converges for a target near the curve.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: 1/(2 pi i) integral of dx/(x - z) along the curve, by the trapezoid rule.
Complex winding_number(const Curve& curve, Complex z) {
  //@ starter
  not_done(curve, z);  // your code instead of this line
  //@ solution
  Complex sum = 0.0;
  for (Eigen::Index j = 0; j < curve.size(); ++j) sum += curve.dx[j] / (curve.x[j] - z);
  return sum / (imaginary * static_cast<double>(curve.size()));
  //@ wrong arclength: this integrates over the arclength
  const Eigen::VectorXd w = weights(curve);
  Complex sum = 0.0;
  for (Eigen::Index j = 0; j < curve.size(); ++j) sum += w[j] / (curve.x[j] - z);
  return sum / (2.0 * pi * imaginary);
  //@ end
}

// Task 2: distance from the real axis of the nearest complex t with x(t) = z.
double predicted_rate(const Ellipse& ellipse, Complex z) {
  //@ starter
  not_done(ellipse, z);  // your code instead of this line
  //@ solution
  const double a = ellipse.a, b = ellipse.b;
  const Complex root = std::sqrt(z * z - (a * a - b * b));
  return std::min(std::abs(std::log(std::abs((z + root) / (a + b)))),
                  std::abs(std::log(std::abs((z - root) / (a + b)))));
  //@ wrong distance_in_the_plane: this is the distance of z from the curve
  return (sample(ellipse, 2000, Side::fluid_inside).x.array() - z).abs().minCoeff();
  //@ end
}

// Task 3: rho of errors C exp(-rho n), without those below 1e-13.
double measured_rate(const Eigen::VectorXd& n, const Eigen::VectorXd& errors) {
  //@ starter
  not_done(n, errors);  // your code instead of this line
  //@ solution
  double count = 0.0, n_sum = 0.0, y_sum = 0.0, nn_sum = 0.0, ny_sum = 0.0;
  for (Eigen::Index i = 0; i < n.size(); ++i) {
    if (errors[i] < 1e-13) continue;
    const double y = std::log(errors[i]);
    count += 1.0;
    n_sum += n[i];
    y_sum += y;
    nn_sum += n[i] * n[i];
    ny_sum += n[i] * y;
  }
  return -(count * ny_sum - n_sum * y_sum) / (count * nn_sum - n_sum * n_sum);
  //@ wrong rounding: this fits the rounding errors too
  const Eigen::VectorXd centred = n.array() - n.mean();
  return -centred.dot(errors.array().log().matrix()) / centred.squaredNorm();
  //@ wrong decades: this counts in decades
  Eigen::Index last = 0;
  while (last + 1 < n.size() && errors[last + 1] >= 1e-13) ++last;
  return std::log10(errors[0] / errors[last]) / (n[last] - n[0]);
  //@ end
}

// Task 4 is an experiment with these functions. You find it in the book's check.cpp.

// Task 5: distance from the curve in spacings h of its nodes, at which the error is the tolerance.
double safe_distance(double tolerance) {
  //@ starter
  not_done(tolerance);  // your code instead of this line
  //@ solution
  return -std::log(tolerance) / (2.0 * pi);
  //@ wrong radians: this is the distance in units of |x'|/N
  return -std::log(tolerance);
  //@ end
}
