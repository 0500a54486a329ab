// Exercise 13.1: the spectrum of two circles that nearly touch.
#include "chapters/exercise.hpp"

#include <array>
#include <cmath>

using stokesbook::exercise::not_done;

// Task 1: preconditioned eigenvalues of two unit circles, ascending.
std::array<double, 4> pair_eigenvalues(double gap, int mode) {
  //@ starter
  not_done(gap, mode);  // your code instead of this line
  //@ solution
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  const double turn = std::asinh(mode * std::sinh(2.0 * alpha));
  const double far = std::exp(-2.0 * mode * alpha + turn);
  const double near = std::exp(-2.0 * mode * alpha - turn);
  return {1.0 - far, 1.0 - near, 1.0 + near, 1.0 + far};
  //@ wrong whole_gap: half the distance of the centres is 1 + g/2
  const double alpha = std::acosh(1.0 + gap);
  const double turn = std::asinh(mode * std::sinh(2.0 * alpha));
  const double far = std::exp(-2.0 * mode * alpha + turn);
  const double near = std::exp(-2.0 * mode * alpha - turn);
  return {1.0 - far, 1.0 - near, 1.0 + near, 1.0 + far};
  //@ end
}

// Task 2: the least of these eigenvalues for a small gap, to leading order.
double least_eigenvalue(double gap) {
  //@ starter
  not_done(gap);  // your code instead of this line
  //@ solution
  return 8.0 * std::pow(gap, 1.5);
  //@ wrong cubed: alpha is the root of the gap
  return 8.0 * std::pow(gap, 3.0);
  //@ wrong half_expanded: asinh has a term of third order too
  return -8.0 / 3.0 * std::pow(gap, 1.5);
  //@ end
}
