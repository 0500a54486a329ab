// Exercise 03.1: the velocity of a settling ellipse, exact and with N nodes.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "double_layer/kernels.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: velocity along direction 1 under a unit force along direction 1, times 4 pi mu.
double exact_velocity(const Ellipse& ellipse, double gauge) {
  //@ starter
  not_done(ellipse, gauge);  // your code instead of this line
  //@ solution
  const double a = ellipse.a, b = ellipse.b;
  return -std::log((a + b) / (2.0 * gauge)) + a / (a + b);
  //@ wrong across: this is the velocity across the ellipse
  const double a = ellipse.a, b = ellipse.b;
  return -std::log((a + b) / (2.0 * gauge)) + b / (a + b);
  //@ wrong circle: this is a circle of radius a
  return -std::log(ellipse.a / gauge) + 0.5;
  //@ end
}

// Task 2: mean over the nodes of the Stokeslet at the origin, times 4 pi mu, along direction 1.
double mean_of_stokeslet(const Curve& curve, double gauge) {
  //@ starter
  not_done(curve, gauge);  // your code instead of this line
  //@ solution
  double sum = 0.0;
  for (const Complex r : curve.x) sum += stokeslet(r, 1.0, 0.25 / pi, gauge).real();
  return sum / static_cast<double>(curve.size());
  //@ wrong arclength: this is the mean over the arclength
  const Eigen::VectorXd w = weights(curve);
  double sum = 0.0;
  for (Eigen::Index j = 0; j < curve.size(); ++j) {
    sum += w[j] * stokeslet(curve.x[j], 1.0, 0.25 / pi, gauge).real();
  }
  return sum / w.sum();
  //@ end
}

// Task 3: the same for an ellipse with n nodes, n even, in closed form.
double discrete_velocity(const Ellipse& ellipse, double gauge, int n) {
  //@ starter
  not_done(ellipse, gauge, n);  // your code instead of this line
  //@ solution
  const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
  const double folded = std::pow(-m, n / 2);
  return exact_velocity(ellipse, gauge) - 2.0 / n * std::log(1.0 - folded) -
         0.5 * (1.0 - m * m) / m * folded / (1.0 - folded);
  //@ wrong first_alias: this is the first alias only
  const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
  const double folded = std::pow(-m, n / 2);
  return exact_velocity(ellipse, gauge) + 2.0 / n * folded - 0.5 * (1.0 - m * m) / m * folded;
  //@ wrong without_logarithm: the aliases of the logarithm are missing
  const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
  const double folded = std::pow(-m, n / 2);
  return exact_velocity(ellipse, gauge) - 0.5 * (1.0 - m * m) / m * folded / (1.0 - folded);
  //@ end
}

// Task 4: least even number of nodes, at least 4, with an error of at most the tolerance.
int nodes_needed(const Ellipse& ellipse, double tolerance) {
  //@ starter
  not_done(ellipse, tolerance);  // your code instead of this line
  //@ solution
  int n = 4;
  const double exact = exact_velocity(ellipse, 1.0);
  while (std::abs(discrete_velocity(ellipse, 1.0, n) - exact) > tolerance) n += 2;
  return n;
  //@ wrong kernel_rate: this takes m^N for the error
  const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
  return 2 * static_cast<int>(std::ceil(0.5 * std::log(tolerance) / std::log(m)));
  //@ end
}
