// Checks the sums over a lattice against 17 digits of reference values, the recursions of modular
// forms, direct sums, and changes of the unit of length.
#include "periodic/far_sums.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "support/lattices.hpp"

using namespace stokesbook;
using Eigen::Index;
using std::numbers::pi;

namespace {

constexpr int order = 20;

// Returns sums without near images: those over all vectors but zero, scaled by powers of b_1.
FarSums full_sums(const Lattice& lattice) {
  FarSums sums = far_sums(lattice, 0.3 * std::abs(lattice.shortest()), order);
  for (Index m = 0; m < sums.s.size(); ++m) {
    sums.s[m] *= std::pow(0.3, static_cast<double>(-m));
    sums.t[m] *= std::pow(0.3, static_cast<double>(1 - m));
  }
  return sums;
}

}  // namespace

BOOST_AUTO_TEST_CASE(reference_values) {
  for (const test::LatticeSums& exact : test::lattice_sums()) {
    const Lattice lattice(exact.a1, exact.a2);
    const FarSums sums = full_sums(lattice);
    const double size = std::abs(lattice.shortest());
    for (std::size_t i = 0; i < 5; ++i) {
      const int m = test::s_powers[i], n = test::t_powers[i];
      const double s_scale = std::pow(size, m), t_scale = std::pow(size, n - 1);
      BOOST_TEST(std::abs(sums.s[m] - s_scale * exact.s[i]) <
                 3e-14 * (1.0 + s_scale * std::abs(exact.s[i])));
      BOOST_TEST(std::abs(sums.t[n] - t_scale * exact.t[i]) <
                 3e-14 * (1.0 + t_scale * std::abs(exact.t[i])));
    }
    BOOST_TEST(std::abs(logarithm_constant(lattice) - exact.logarithm) < 2e-15);
  }
}

// All sums follow from S_2, S_4 and S_6.
BOOST_AUTO_TEST_CASE(recursions) {
  for (const test::NamedLattice& named : test::lattices()) {
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const FarSums sums = full_sums(lattice);
      const double size = std::abs(lattice.shortest()), area = lattice.area() / size / size;
      const auto check = [&](Complex found, Complex exact, double scale) {
        BOOST_TEST(std::abs(found - exact) < 1e-13 * scale);
      };
      check(sums.t[1], area / pi * sums.s[2], 1.0 + area);
      for (Index m = 4; m <= 2 * order; m += 2) {
        Complex products{}, weighted{};
        for (Index j = 2; j <= m - 2; j += 2) {
          products += sums.s[j] * sums.s[m - j];
          if (j >= 4 && j <= m - 4) {
            weighted += static_cast<double>((j - 1) * (m - j - 1)) * sums.s[j] * sums.s[m - j];
          }
        }
        const auto d = static_cast<double>(m);
        check(sums.t[m - 1], area / (2.0 * pi) * ((d + 1.0) * sums.s[m] - products),
              area * (d + 1.0));
        if (m >= 8) {
          check(sums.s[m], 6.0 / ((d + 1.0) * (d - 1.0) * (d - 6.0)) * weighted,
                1.0 + std::abs(sums.s[m]));
        }
      }
    }
  }
}

// Near images are left out one by one. Powers of at least 20 converge fast enough for direct sums.
BOOST_AUTO_TEST_CASE(near_images_left_out) {
  for (const test::NamedLattice& named : test::lattices()) {
    const Lattice lattice = named.lattice();
    for (const double share : {0.3, 0.7, 1.1, 2.5}) {
      BOOST_TEST_CONTEXT(named.name << ", radius " << share << " of the shortest vector") {
        const double radius = share * std::abs(lattice.shortest());
        const FarSums sums = far_sums(lattice, radius, order);
        const FarSums full = full_sums(lattice);
        const std::vector<Complex> near = near_images(lattice, radius);
        for (const Index m : {1, 2, 3, 4, 5, 8, 9}) {
          const auto d = static_cast<double>(m);
          Complex s = full.s[m] * std::pow(share, d), t = full.t[m] * std::pow(share, d - 1.0);
          double s_size = std::abs(s), t_size = std::abs(t);
          for (const Complex w : near) {
            const Complex power = std::pow(radius / w, d);
            s -= power;
            t -= std::conj(w) / radius * power;
            s_size += std::abs(power);
            t_size += std::abs(w / radius * power);
          }
          if (m % 2 == 0) BOOST_TEST(std::abs(sums.s[m] - s) < 2e-14 * s_size);
          if (m % 2 == 1) BOOST_TEST(std::abs(sums.t[m] - t) < 2e-14 * t_size);
        }
        for (const Index m : {20, 21, 40, 41}) {
          const auto d = static_cast<double>(m);
          Complex s{}, t{};
          for (const Complex w : lattice.half_disk(25.0 * radius)) {
            if (std::abs(w) < 3.0 * radius) continue;
            s += 2.0 * std::pow(radius / w, d);
            t += 2.0 * std::conj(w) / radius * std::pow(radius / w, d);
          }
          const double scale = std::pow(3.0, -d);
          if (m % 2 == 0) BOOST_TEST(std::abs(sums.s[m] - s) < 1e-13 * scale);
          if (m % 2 == 1) BOOST_TEST(std::abs(sums.t[m] - t) < 1e-13 * 3.0 * scale);
        }
      }
    }
  }
}

// An image and its opposite are both near, or both far, also where |w| = 3R up to rounding.
BOOST_AUTO_TEST_CASE(near_images_are_symmetric) {
  const Complex turn = std::polar(1.0, 0.6);
  const Lattice lattice(turn, imaginary * turn);
  for (const Complex w : lattice.half_disk(5.5)) {
    const double radius = std::abs(w) / 3.0;
    for (const double around : {radius, std::nextafter(radius, 0.0), std::nextafter(radius, 9.0)}) {
      const std::vector<Complex> near = near_images(lattice, around);
      for (const Complex image : near) {
        BOOST_TEST(std::ranges::count(near, -image) == 1);
        BOOST_TEST(std::abs(image) < 3.0 * around);
      }
      const FarSums sums = far_sums(lattice, around, order), full = full_sums(lattice);
      Complex s = std::pow(around, 4.0) * full.s[4];
      for (const Complex image : near) s -= std::pow(around / image, 4.0);
      BOOST_TEST(std::abs(sums.s[4] - s) < 1e-13 * (1.0 + std::pow(around, 4.0)));
    }
  }
}

// Bits change with the unit, because powers of ten are rounded; powers of two leave all bits.
BOOST_AUTO_TEST_CASE(unit_of_length) {
  const Complex a1{2.2, 0.1}, a2{0.5, 1.9};
  const FarSums sums = far_sums(Lattice(a1, a2), 0.9, 60);
  for (const int exponent : {-400, -30, 30, 400}) {
    const double unit = std::ldexp(1.0, exponent);
    const FarSums other = far_sums(Lattice(unit * a1, unit * a2), unit * 0.9, 60);
    BOOST_TEST((other.s == sums.s && other.t == sums.t));
    BOOST_TEST(std::abs(logarithm_constant(Lattice(unit * a1, unit * a2)) -
                        logarithm_constant(Lattice(a1, a2)) - std::log(unit)) <
               1e-15 * std::abs(exponent));
  }
}

// A small body in a wide cell and a disk that holds many cells give finite sums of every order.
BOOST_AUTO_TEST_CASE(extreme_radii) {
  const Lattice lattice({1.0, 0.0}, {0.3, 1.0});
  for (const double radius : {1e-100, 1e-3, 9.0}) {
    const FarSums sums = far_sums(lattice, radius, 60);
    BOOST_TEST((sums.s.allFinite() && sums.t.allFinite()));
  }
}
