// Checks reduced bases, lattice vectors in disks and near points, and wrapping.
#include "periodic/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "support/lattices.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using test::random_vector;

namespace {

// Returns all vectors of a reduced basis with coefficients of modulus at most n.
std::vector<Complex> brute_vectors(const Lattice& lattice, int n) {
  std::vector<Complex> vectors;
  for (int j = -n; j <= n; ++j) {
    for (int k = -n; k <= n; ++k) {
      vectors.push_back(static_cast<double>(j) * lattice.shortest() +
                        static_cast<double>(k) * lattice.second());
    }
  }
  return vectors;
}

// Checks that a vector has integer coefficients with respect to a basis.
void check_member(Complex vector, Complex a1, Complex a2) {
  const double area = cross(a1, a2);
  const double rounding = 1e-14 * (1.0 + std::abs(a1) * std::abs(a2) / std::abs(area)) *
                          (1.0 + std::abs(vector) * (std::abs(a1) + std::abs(a2)) / std::abs(area));
  for (const double coefficient : {cross(vector, a2) / area, cross(a1, vector) / area}) {
    BOOST_TEST(std::abs(coefficient - std::round(coefficient)) < rounding);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(reduced_basis) {
  for (const auto& [name, a1, a2] : test::lattices()) {
    BOOST_TEST_CONTEXT(name) {
      const Lattice lattice(a1, a2);
      const Complex b1 = lattice.shortest(), b2 = lattice.second(), tau = b2 / b1;
      BOOST_TEST(std::abs(tau.real()) <= 0.5 + 1e-15);
      BOOST_TEST(tau.imag() >= std::sqrt(0.75) - 1e-15);
      BOOST_TEST(std::abs(lattice.area() / std::abs(cross(a1, a2)) - 1.0) < 1e-12);
      // Each basis consists of vectors of the other one, so that the lattices are the same.
      check_member(b1, a1, a2);
      check_member(b2, a1, a2);
      check_member(a1, b1, b2);
      check_member(a2, b1, b2);
    }
  }
}

BOOST_AUTO_TEST_CASE(vectors_in_a_disk) {
  for (const test::NamedLattice& named : test::lattices()) {
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const std::vector<Complex> all = brute_vectors(lattice, 12);
      const double size = std::abs(lattice.shortest());
      for (const double radius : {0.5 * size, 1.0001 * size, 3.7 * size, 9.0 * size}) {
        const std::vector<Complex> half = lattice.half_disk(radius);
        const auto inside =
            std::count_if(all.begin(), all.end(), [&](Complex w) { return std::abs(w) < radius; });
        BOOST_TEST(2 * std::ssize(half) + 1 == inside);
        for (std::size_t i = 0; i < half.size(); ++i) {
          BOOST_TEST(std::abs(half[i]) < radius);
          BOOST_TEST(std::abs(half[i]) > 0.0);
          for (std::size_t j = 0; j < i; ++j) {
            BOOST_TEST(std::abs(half[i] - half[j]) > 0.5 * size);
            BOOST_TEST(std::abs(half[i] + half[j]) > 0.5 * size);
          }
        }
      }
    }
  }
}

// The vectors that lead a point into a disk are those of all that do so.
BOOST_AUTO_TEST_CASE(vectors_into_a_disk) {
  for (const test::NamedLattice& named : test::lattices()) {
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const std::vector<Complex> all = brute_vectors(lattice, 14);
      const double size = std::abs(lattice.shortest());
      const ComplexVector points = size * random_vector(20, 5);
      for (Eigen::Index i = 0; i < points.size(); i += 2) {
        const Complex z = 2.0 * points[i], centre = points[i + 1];
        for (const double radius : {0.4 * size, 1.3 * size, 4.1 * size}) {
          std::vector<Complex> found = lattice.vectors_into_disk(z, centre, radius);
          const auto inside = std::count_if(
              all.begin(), all.end(), [&](Complex w) { return std::abs(z + w - centre) < radius; });
          BOOST_TEST(std::ssize(found) == inside);
          for (std::size_t k = 0; k < found.size(); ++k) {
            BOOST_TEST(std::abs(z + found[k] - centre) < radius);
            check_member(found[k], lattice.shortest(), lattice.second());
            for (std::size_t j = 0; j < k; ++j) {
              BOOST_TEST(std::abs(found[k] - found[j]) > 0.5 * size);
            }
          }
        }
      }
    }
  }
}

// Each corner of the Voronoi cell is equally far from the origin and from two other vectors, and no
// vector is nearer. The corners enclose the area of the lattice.
BOOST_AUTO_TEST_CASE(corners_of_the_voronoi_cell) {
  for (const test::NamedLattice& named : test::lattices()) {
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const std::vector<Complex> all = brute_vectors(lattice, 4);
      const auto corners = lattice.voronoi_corners();
      double area = 0.0;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Complex corner = corners[k], next = corners[(k + 1) % corners.size()];
        const double radius = std::abs(corner), rounding = 1e-12 * radius;
        BOOST_TEST(std::abs(radius - std::abs(corners[0])) < rounding);
        BOOST_TEST(cross(corner, next) > -rounding * radius);
        area += 0.5 * cross(corner, next);
        int as_far = 0;
        for (const Complex w : all) {
          BOOST_TEST(std::abs(w - corner) > radius - rounding);
          as_far += std::abs(w - corner) < radius + rounding ? 1 : 0;
        }
        BOOST_TEST(as_far >= 3);
      }
      BOOST_TEST(std::abs(area / lattice.area() - 1.0) < 1e-12);
    }
  }
}

// Many vectors of the square lattice have the same length. Both signs of each one are inside a disk
// with exactly this radius, or both are outside.
BOOST_AUTO_TEST_CASE(vectors_on_the_circle) {
  const Lattice square({0.1, 0.0}, {0.0, 0.1});
  for (const double radius : {0.1, 0.5, 1.3}) {
    const double above = std::nextafter(std::nextafter(radius, 2.0), 2.0);
    BOOST_TEST(square.half_disk(0.999 * radius).size() < square.half_disk(above).size());
    BOOST_TEST((square.half_disk(above).size() - square.half_disk(0.999 * radius).size()) % 2 == 0);
  }
}

BOOST_AUTO_TEST_CASE(nearest_vector) {
  for (const test::NamedLattice& named : test::lattices()) {
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const std::vector<Complex> all = brute_vectors(lattice, 5);
      const double size = std::abs(lattice.second());
      for (const Complex random : random_vector(300, 3)) {
        const Complex z = 2.0 * size * random;
        double distance = std::numeric_limits<double>::infinity();
        for (const Complex w : all) distance = std::min(distance, std::abs(z - w));
        BOOST_TEST(std::abs(z - lattice.nearest(z)) <= distance * (1.0 + 1e-14));
        check_member(lattice.nearest(z), lattice.shortest(), lattice.second());
      }
    }
  }
}

// A point, however far away, returns to the cell of the centre; the coefficients of the vector that
// moved it lead back.
BOOST_AUTO_TEST_CASE(wrapping_and_unwrapping) {
  for (const test::NamedLattice& named : test::lattices()) {
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const double size = std::abs(lattice.second());
      const Complex centre = Complex{-40.0, 1e4} * size;
      for (const Complex random : random_vector(100, 4)) {
        const Complex z = centre + 50.0 * size * random, wrapped = lattice.wrap(z, centre);
        BOOST_TEST(std::abs(wrapped - centre) <= 0.7072 * size);
        BOOST_TEST(lattice.nearest(wrapped - centre) == Complex{});
        const LatticeIndex moved = lattice.index(z - wrapped);
        const double rounding =
            1e-15 * (std::abs(z) + std::abs(static_cast<double>(moved.first) * named.a1) +
                     std::abs(static_cast<double>(moved.second) * named.a2));
        BOOST_TEST(std::abs(wrapped + lattice.vector(moved) - z) < 10.0 * rounding);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(bad_vectors_are_refused) {
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_CHECK_THROW(Lattice({1.0, 0.0}, {0.0, 0.0}), std::invalid_argument);
  BOOST_CHECK_THROW(Lattice({1.0, 2.0}, {-3.0, -6.0}), std::invalid_argument);
  BOOST_CHECK_THROW(Lattice({1.0, 2.0}, {-3.0, -6.0 + 1e-14}), std::invalid_argument);
  BOOST_CHECK_THROW(Lattice({infinity, 0.0}, {0.0, 1.0}), std::invalid_argument);
  BOOST_CHECK_THROW(Lattice({0.0, std::nan("")}, {1.0, 0.0}), std::invalid_argument);
  BOOST_CHECK_NO_THROW(Lattice({1.0, 2.0}, {-3.0, -6.0 + 1e-9}));
}
