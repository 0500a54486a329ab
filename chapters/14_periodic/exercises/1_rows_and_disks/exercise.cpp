// Exercise 14.1: sums over a lattice by rows and by disks, and a periodic kernel.
#include "chapters/exercise.hpp"

#include <complex>
#include <numbers>

using Complex = std::complex<double>;
using std::numbers::pi;
using stokesbook::exercise::not_done;

// Task 1: the sum of 1/w^2 over w = j + k tau, row after row.
Complex sum_by_rows(Complex tau) {
  //@ starter
  not_done(tau);  // your code instead of this line
  //@ solution
  Complex sum = pi * pi / 3.0;
  for (int k = 1; k <= 8; ++k) {
    const Complex sine = std::sin(pi * static_cast<double>(k) * tau);
    sum += 2.0 * pi * pi / (sine * sine);
  }
  return sum;
  //@ wrong rows_above: the rows below contribute as much as the rows above
  Complex sum = pi * pi / 3.0;
  for (int k = 1; k <= 8; ++k) {
    const Complex sine = std::sin(pi * static_cast<double>(k) * tau);
    sum += pi * pi / (sine * sine);
  }
  return sum;
  //@ wrong no_middle: the row of the origin is missing
  Complex sum;
  for (int k = 1; k <= 8; ++k) {
    const Complex sine = std::sin(pi * static_cast<double>(k) * tau);
    sum += 2.0 * pi * pi / (sine * sine);
  }
  return sum;
  //@ end
}

// Task 2: the sum S_2 over growing disks.
Complex sum_by_disks(Complex b1, Complex b2) {
  //@ starter
  not_done(b1, b2);  // your code instead of this line
  //@ solution
  const double area = std::abs((std::conj(b1) * b2).imag());
  return sum_by_rows(b2 / b1) / (b1 * b1) - pi / area * std::conj(b1) / b1;
  //@ wrong rows: this is the sum by rows
  return sum_by_rows(b2 / b1) / (b1 * b1);
  //@ wrong plus: the term with the area has a minus
  const double area = std::abs((std::conj(b1) * b2).imag());
  return sum_by_rows(b2 / b1) / (b1 * b1) + pi / area * std::conj(b1) / b1;
  //@ wrong no_direction: the rows have a direction
  const double area = std::abs((std::conj(b1) * b2).imag());
  return sum_by_rows(b2 / b1) / (b1 * b1) - pi / area;
  //@ end
}

// Task 3: the periodic function F with the pole 1/z.
Complex periodic_kernel(Complex z, Complex tau) {
  //@ starter
  not_done(z, tau);  // your code instead of this line
  //@ solution
  Complex sum = Complex(0.0, 2.0 * pi * z.imag() / tau.imag());
  for (int k = -8; k <= 8; ++k) sum += pi / std::tan(pi * (z - static_cast<double>(k) * tau));
  return sum;
  //@ wrong rows_alone: without the linear term
  Complex sum;
  for (int k = -8; k <= 8; ++k) sum += pi / std::tan(pi * (z - static_cast<double>(k) * tau));
  return sum;
  //@ wrong analytic: an analytic term is not periodic along the rows
  Complex sum = pi / tau.imag() * z;
  for (int k = -8; k <= 8; ++k) sum += pi / std::tan(pi * (z - static_cast<double>(k) * tau));
  return sum;
  //@ wrong half: the sum changes by 2 pi i
  Complex sum = Complex(0.0, pi * z.imag() / tau.imag());
  for (int k = -8; k <= 8; ++k) sum += pi / std::tan(pi * (z - static_cast<double>(k) * tau));
  return sum;
  //@ end
}
