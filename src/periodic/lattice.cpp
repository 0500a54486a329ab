// Reduces the basis of a lattice by the algorithm of Lagrange and Gauss, and finds the lattice
// vectors in a disk or near a point with the reduced basis.
#include "periodic/lattice.hpp"

#include <cmath>
#include <utility>

#include "trapezoid/require.hpp"

namespace stokesbook {

Lattice::Lattice(Complex a1, Complex a2) : a1_(a1), a2_(a2), b1_(a1), b2_(a2) {
  const double sizes = std::abs(a1) * std::abs(a2);
  require(std::isfinite(sizes) && sizes > 0.0, "lattice vectors must be finite and not zero, got ",
          a1, " and ", a2);
  require(std::abs(cross(a1, a2)) >= 1e-12 * sizes, "the lattice vectors ", a1, " and ", a2,
          " are parallel: they span no cell");
  // Each pass makes the longer vector as short as possible. The passes end when this vector stays
  // the longer one, because the lengths decrease otherwise.
  for (bool reduced = false; !reduced;) {
    b2_ -= std::round(dot(b1_, b2_) / std::norm(b1_)) * b1_;
    reduced = std::norm(b2_) >= std::norm(b1_);
    if (!reduced) std::swap(b1_, b2_);
  }
  if (cross(b1_, b2_) < 0.0) b2_ = -b2_;
  area_ = cross(b1_, b2_);
}

Complex Lattice::vector(LatticeIndex index) const {
  return static_cast<double>(index.first) * a1_ + static_cast<double>(index.second) * a2_;
}

LatticeIndex Lattice::index(Complex vector) const {
  const double area = cross(a1_, a2_);
  return {std::llround(cross(vector, a2_) / area), std::llround(cross(a1_, vector) / area)};
}

Complex Lattice::nearest(Complex z) const {
  // With a reduced basis, the nearest vector is a corner of the parallelogram that contains z.
  const double s = std::floor(cross(z, b2_) / area_), t = std::floor(cross(b1_, z) / area_);
  Complex nearest = s * b1_ + t * b2_;
  for (const auto& [i, j] : {std::pair{1.0, 0.0}, std::pair{0.0, 1.0}, std::pair{1.0, 1.0}}) {
    const Complex corner = (s + i) * b1_ + (t + j) * b2_;
    if (std::norm(z - corner) < std::norm(z - nearest)) nearest = corner;
  }
  return nearest;
}

std::array<Complex, 6> Lattice::voronoi_corners() const {
  // The sides lie halfway to these vectors and their negatives, here in the order of their
  // directions. A corner is equally far from the origin and from two of the vectors.
  const bool is_acute = dot(b1_, b2_) >= 0.0;
  const std::array<Complex, 4> nearest{b1_, is_acute ? b2_ : b1_ + b2_, is_acute ? b2_ - b1_ : b2_,
                                       -b1_};
  std::array<Complex, 6> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Complex u = nearest[k], v = nearest[k + 1];
    corners[k] = imaginary * (std::norm(v) * u - std::norm(u) * v) / (2.0 * cross(u, v));
    corners[k + 3] = -corners[k];
  }
  return corners;
}

std::vector<Complex> Lattice::vectors_into_disk(Complex z, Complex centre, double radius) const {
  const Complex first = nearest(centre - z), from_centre = z + first - centre;
  std::vector<Complex> vectors;
  const auto add = [&](Complex w) {
    if (std::abs(from_centre + w) < radius) vectors.push_back(first + w);
  };
  add(0.0);
  for (const Complex w : half_disk(radius + std::abs(from_centre))) {
    add(w);
    add(-w);
  }
  return vectors;
}

std::vector<Complex> Lattice::half_disk(double radius) const {
  const double length = std::abs(b1_), height = area_ / length;
  const double offset = dot(b1_, b2_) / length;  // of the next row, along b1
  std::vector<Complex> vectors;
  for (double k = 0.0; k * height < radius; ++k) {
    const double reach = std::sqrt(radius * radius - k * k * height * height);
    const double last = std::floor((reach - k * offset) / length) + 1.0;
    double j = k == 0.0 ? 1.0 : std::ceil((-reach - k * offset) / length) - 1.0;
    for (; j <= last; ++j) {
      const Complex w = j * b1_ + k * b2_;
      if (std::abs(w) < radius) vectors.push_back(w);
    }
  }
  return vectors;
}

}  // namespace stokesbook
