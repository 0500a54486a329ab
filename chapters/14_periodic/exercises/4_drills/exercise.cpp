// Exercise 14.4: five drills on lattices, images and bulk stress.
#include "chapters/exercise.hpp"

#include <cmath>
#include <complex>
#include <vector>

using Complex = std::complex<double>;
using stokesbook::exercise::not_done;

// Task 1: the first component of a_2 - n a_1 that is smallest in modulus.
double reduced_shear(double shear, double L1, double L2) {
  //@ starter
  not_done(shear, L1, L2);  // your code instead of this line
  //@ solution
  return shear * L2 - L1 * std::round(shear * L2 / L1);
  //@ wrong floor: may be nearly a whole L1
  return shear * L2 - L1 * std::floor(shear * L2 / L1);
  //@ wrong square: sides of the cell
  (void)L1;
  return L2 * (shear - std::round(shear));
  //@ end
}

// Task 2: the number of near images in a square cell of side 1.
int near_images(double R) {
  //@ starter
  not_done(R);  // your code instead of this line
  //@ solution
  const int most = static_cast<int>(3.0 * R);
  int count = -1;  // without the vector 0
  for (int j = -most; j <= most; ++j) {
    for (int k = -most; k <= most; ++k) count += std::hypot(j, k) < 3.0 * R ? 1 : 0;
  }
  return count;
  //@ wrong with_zero: the vector 0 is no image
  const int most = static_cast<int>(3.0 * R);
  int count = 0;
  for (int j = -most; j <= most; ++j) {
    for (int k = -most; k <= most; ++k) count += std::hypot(j, k) < 3.0 * R ? 1 : 0;
  }
  return count;
  //@ wrong a_square: a disk of vectors
  const int most = static_cast<int>(3.0 * R);
  return (2 * most + 1) * (2 * most + 1) - 1;
  //@ end
}

// Task 3: the mean gradient of the pressure.
Complex pressure_gradient(const std::vector<Complex>& free, const std::vector<Complex>& held,
                          double area) {
  //@ starter
  not_done(free, held, area);  // your code instead of this line
  //@ solution
  Complex sum;
  for (const Complex force : free) sum += force;
  for (const Complex force : held) sum += force;
  return sum / area;
  //@ wrong free_alone: held bodies count
  (void)held;
  Complex sum;
  for (const Complex force : free) sum += force;
  return sum / area;
  //@ wrong falls: rises along the force
  Complex sum;
  for (const Complex force : free) sum -= force;
  for (const Complex force : held) sum -= force;
  return sum / area;
  //@ end
}

// Task 4: the velocity of the image that is moved by w.
Complex image_velocity(Complex U, double shear_rate, Complex w) {
  //@ starter
  not_done(U, shear_rate, w);  // your code instead of this line
  //@ solution
  return U + shear_rate * w.imag();
  //@ wrong same: the mean flow differs
  (void)shear_rate;
  (void)w;
  return U;
  //@ wrong minus: in the direction of w
  return U - shear_rate * w.imag();
  //@ end
}

// Task 5: the component 12 of the stress of a contact.
double contact_stress(Complex F, Complex c_A, Complex c_B, Complex w, double area) {
  //@ starter
  not_done(F, c_A, c_B, w, area);  // your code instead of this line
  //@ solution
  return -F.real() * (c_A - c_B - w).imag() / area;
  //@ wrong no_image: the image is at
  (void)w;
  return -F.real() * (c_A - c_B).imag() / area;
  //@ wrong sign: pushes the bodies apart
  return F.real() * (c_A - c_B - w).imag() / area;
  //@ end
}
