// Exercise 05.1: residuals and counts of GMRES from the spectrum alone.
#include "chapters/exercise.hpp"

#include <cmath>

using stokesbook::exercise::not_done;

// Task 1: relative residual after k iterations, eigenvalues on the circle |z - centre| = radius.
double residual_on_circle(double centre, double radius, int k) {
  //@ starter
  not_done(centre, radius, k);  // your code instead of this line
  //@ solution
  double sum = 0.0;
  for (int j = 0; j <= k; ++j) sum += std::pow(centre / radius, 2.0 * j);
  return 1.0 / std::sqrt(sum);
  //@ wrong bound: this is the bound (r/c)^k
  return std::pow(radius / centre, k);
  //@ wrong about_one: this is the circle about 1
  static_cast<void>(centre);
  double sum = 0.0;
  for (int j = 0; j <= k; ++j) sum += std::pow(radius, -2.0 * j);
  return 1.0 / std::sqrt(sum);
  //@ end
}

// Task 2: least k with 1/T_k <= tolerance, eigenvalues from 1 to kappa.
int iterations_on_interval(double kappa, double tolerance) {
  //@ starter
  not_done(kappa, tolerance);  // your code instead of this line
  //@ solution
  const double rate = std::acosh((kappa + 1.0) / (kappa - 1.0));
  return static_cast<int>(std::ceil(std::acosh(1.0 / tolerance) / rate));
  //@ wrong without_root: this is the rate of the condition number
  const double rate = std::log((kappa + 1.0) / (kappa - 1.0));
  return static_cast<int>(std::ceil(std::acosh(1.0 / tolerance) / rate));
  //@ wrong without_two: the factor 2 is missing
  const double rate = std::acosh((kappa + 1.0) / (kappa - 1.0));
  return static_cast<int>(std::ceil(std::log(1.0 / tolerance) / rate));
  //@ end
}
