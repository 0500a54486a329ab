#pragma once

#include <random>

#include "trapezoid/plane.hpp"

namespace stokesbook::test {

/// Returns the largest modulus of a vector's entries.
inline double largest(const ComplexVector& v) {
  return v.cwiseAbs().maxCoeff();
}

/// Returns complex numbers with real and imaginary parts uniform in [-1, 1]. The numbers are the
/// same in every run.
inline ComplexVector random_vector(Eigen::Index n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  ComplexVector v(n);
  for (Complex& entry : v) {
    const double re = uniform(generator);
    entry = {re, uniform(generator)};
  }
  return v;
}

}  // namespace stokesbook::test
