// Exercise 14.2: rotation, viscosity and normal stress of an array of small free disks.
#include "chapters/exercise.hpp"

#include <complex>
#include <numbers>

using Complex = std::complex<double>;
using std::numbers::pi;
using stokesbook::exercise::not_done;

// Task 1: the limit of (omega + 1/2)/phi.
double rotation_slope(Complex S2, double area) {
  //@ starter
  not_done(S2, area);  // your code instead of this line
  //@ solution
  return area / pi * S2.real();
  //@ wrong vorticity: a disk rotates with half of the vorticity
  return 2.0 * area / pi * S2.real();
  //@ wrong imaginary_part: alpha is imaginary
  return area / pi * S2.imag();
  //@ wrong unit_cell: the radius is that of the area fraction
  (void)area;
  return S2.real() / pi;
  //@ end
}

// Task 2: the coefficient of phi^2 in the viscosity.
double second_coefficient(Complex T3, double area) {
  //@ starter
  not_done(T3, area);  // your code instead of this line
  //@ solution
  return 2.0 - 4.0 * area / pi * T3.real();
  //@ wrong not_periodic: the term with pi/V is missing
  return -4.0 * area / pi * T3.real();
  //@ wrong not_conjugated: the term with pi/V has the conjugate of alpha
  return -2.0 - 4.0 * area / pi * T3.real();
  //@ wrong half: the strain is twice
  return 1.0 - 2.0 * area / pi * T3.real();
  //@ end
}

// Task 3: the limit of N_1/phi^2.
double normal_stress_coefficient(Complex T3, double area) {
  //@ starter
  not_done(T3, area);  // your code instead of this line
  //@ solution
  return -8.0 * area / pi * T3.imag();
  //@ wrong sign: conj(T_3) has the other sign
  return 8.0 * area / pi * T3.imag();
  //@ wrong one_stress: N_1 is the difference of two stresses
  return -4.0 * area / pi * T3.imag();
  //@ end
}
