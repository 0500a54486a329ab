// Checks the reference: the Ewald sums do not depend on their splitting parameter, have the
// singular parts of the kernels, and repeat with the lattice.
#include "support/ewald.hpp"

#include <boost/test/unit_test.hpp>

#include "double_layer/kernels.hpp"
#include "support/lattices.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using test::ewald_functions;
using test::PeriodicFunctions;

namespace {

double difference(const PeriodicFunctions& a, const PeriodicFunctions& b, double size) {
  return std::max({std::abs(a.l - b.l), std::abs(a.h - b.h), size * std::abs(a.f - b.f),
                   size * std::abs(a.g - b.g), size * size * std::abs(a.p - b.p),
                   size * size * std::abs(a.g_slope - b.g_slope)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(splitting_and_periodicity) {
  for (const test::NamedLattice& named : test::lattices()) {
    if (named.name == "shear 1000.3") continue;  // rounding of the vector a_2
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const double size = std::abs(lattice.shortest()),
                   rounding = 5e-13 * lattice.area() / size / size;
      for (const Complex random : test::random_vector(5, 8)) {
        const Complex z = size * random;
        const PeriodicFunctions exact = ewald_functions(lattice, z);
        BOOST_TEST(difference(ewald_functions(lattice, z, 0.6), exact, size) < rounding);
        BOOST_TEST(difference(ewald_functions(lattice, z, 1.9), exact, size) < rounding);
        BOOST_TEST(difference(ewald_functions(lattice, z + named.a1), exact, size) < rounding);
        BOOST_TEST(difference(ewald_functions(lattice, z - named.a2), exact, size) < rounding);
      }
    }
  }
}

// In a wide cell, the images are too far away to be seen, apart from constants.
BOOST_AUTO_TEST_CASE(singular_parts) {
  const Lattice wide({2e7, 0.0}, {3e6, 1e7});
  const Complex other{0.2, 0.9};
  const PeriodicFunctions there = ewald_functions(wide, other);
  for (const Complex z : test::random_vector(5, 9)) {
    const PeriodicFunctions here = ewald_functions(wide, z);
    const auto check = [](Complex found, Complex exact) {
      BOOST_TEST(std::abs(found - exact) < 1e-13 * (1.0 + std::abs(exact)));
    };
    check(here.f, 1.0 / z);
    check(here.p, 1.0 / (z * z));
    check(here.g, std::conj(z) / (z * z));
    check(here.g_slope, -2.0 * std::conj(z) / (z * z * z));
    check(here.l - there.l, std::log(std::abs(other / z)));
    check(here.h - there.h, 0.5 * z / std::conj(z) - 0.5 * other / std::conj(other));
  }
}

// The mean over a cell, by the trapezoid rule on a shifted grid, of the bounded functions whose
// singular parts integrate fast enough: h is bounded, and l is integrable.
BOOST_AUTO_TEST_CASE(mean_zero) {
  const test::NamedLattice named{"", {1.0, 0.0}, {0.3, 1.0}};
  const Lattice lattice = named.lattice();
  const auto mean = [&](double n) {
    std::pair<double, Complex> sum;
    for (double j = 0.5; j < n; ++j) {
      for (double k = 0.5; k < n; ++k) {
        const PeriodicFunctions at = ewald_functions(lattice, (j * named.a1 + k * named.a2) / n);
        sum.first += at.l / (n * n);
        sum.second += at.h / (n * n);
      }
    }
    return sum;
  };
  // The error of the rule is c / n^2, which extrapolation removes.
  const auto [coarse_l, coarse_h] = mean(12.0);
  const auto [fine_l, fine_h] = mean(24.0);
  BOOST_TEST(std::abs((4.0 * fine_l - coarse_l) / 3.0) < 1e-4);
  BOOST_TEST(std::abs((4.0 * fine_h - coarse_h) / 3.0) < 1e-4);
}
