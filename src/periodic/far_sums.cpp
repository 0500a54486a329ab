// Sums powers over the lattice vectors outside a disk, by Poisson's formula for the smooth parts
// of the sums.
#include "periodic/far_sums.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stokesbook {

using Eigen::Index;
using std::numbers::pi;

namespace {

// Returns Q(m, x) / r^m for m = 0 ... top.
Eigen::ArrayXd outside(double x, double r, Index top) {
  Eigen::ArrayXd result = Eigen::ArrayXd::Zero(top + 1);
  double term = std::exp(-x), sum = 0.0, power = 1.0;  // x^m / m! e^-x, Q(m, x), r^-m
  for (Index m = 0; m <= top; ++m) {
    result[m] = power * sum;
    sum += term;
    term *= x / static_cast<double>(m + 1);
    power /= r;
  }
  return result;
}

// Returns P(m, x) / r^m for m = 0 ... top and x = alpha r^2. The factor of x^m / m! e^-x satisfies
// M_m = 1 + x M_(m+1) / (m+1), which has positive terms only. The product of x^m and r^-m is
// (alpha r)^m, which stays within the range of numbers where its factors do not.
Eigen::ArrayXd inside(double x, double r, double alpha, Index top) {
  constexpr Index beyond = 80;  // terms beyond the highest sum, for x <= 18
  Eigen::ArrayXd result(top + 1);
  double factor = 1.0;
  for (Index m = top + beyond; m >= 0; --m) {
    factor = 1.0 + x * factor / static_cast<double>(m + 1);
    if (m <= top) result[m] = factor;
  }
  double power = std::exp(-x);  // (alpha r)^m / m! e^-x
  for (Index m = 0; m <= top; ++m) {
    result[m] *= power;
    power *= alpha * r / static_cast<double>(m + 1);
  }
  return result;
}

// Returns (pi r / V)^(m-1) e^-c / (r (m-1)!) for m = 1 ... top.
Eigen::ArrayXd dual(double g, double c, double r, Index top) {
  Eigen::ArrayXd result = Eigen::ArrayXd::Zero(top + 1);
  double term = std::exp(-c) / r;
  for (Index m = 1; m <= top; ++m) {
    result[m] = term;
    term *= g / static_cast<double>(m);
  }
  return result;
}

}  // namespace

std::vector<Complex> near_images(const Lattice& lattice, double radius) {
  std::vector<Complex> images;
  for (const Complex w : lattice.half_disk(3.0 * radius)) {
    images.push_back(w);
    images.push_back(-w);
  }
  return images;
}

FarSums far_sums(const Lattice& lattice, double radius, int order) {
  const Index top = 2 * order + 2;
  const double area = lattice.area() / radius / radius, alpha = std::min(pi / area, 2.0);
  const auto highest = static_cast<double>(top);
  const double bound = highest + 9.0 * std::sqrt(highest) + 37.0;  // of x and c, for rounding
  FarSums sums{Eigen::VectorXcd::Zero(top + 1), Eigen::VectorXcd::Zero(top + 1)};
  for (const Complex w : lattice.half_disk(radius * std::sqrt(bound / alpha))) {
    const double length = std::abs(w), r = length / radius, g = pi * r / area;
    const double x = alpha * r * r, c = g * g / alpha;
    const bool is_near = length < 3.0 * radius;
    const Eigen::ArrayXd direct = is_near ? -inside(x, r, alpha, top) : outside(x, r, top);
    const Eigen::ArrayXd smooth = dual(g, c, r, top);
    const Complex direction = std::conj(w) / length;
    Complex power = direction;
    for (Index m = 1; m <= top; ++m, power *= direction) {
      // The vector -w contributes as much.
      if (m % 2 == 0) {
        sums.s[m] += 2.0 * power * (direct[m] + smooth[m]);
      } else {
        sums.t[m] += 2.0 * power * direction * (r * direct[m] + (1.0 + c) / g * smooth[m]);
      }
    }
  }
  return sums;
}

double logarithm_constant(const Lattice& lattice) {
  const Complex tau = lattice.second() / lattice.shortest();
  const Complex q = std::exp(2.0 * pi * imaginary * tau);
  double sum =
      std::log(0.5 * std::numbers::inv_pi * std::abs(lattice.shortest())) + pi / 6.0 * tau.imag();
  Complex power = q;  // |q| < 0.005: eight factors suffice
  for (int n = 1; n <= 8; ++n, power *= q) sum -= 2.0 * std::log(std::abs(1.0 - power));
  return sum;
}

}  // namespace stokesbook
