#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// Integer coefficients j, k of the lattice vector \f$ j a_1 + k a_2 \f$.
struct LatticeIndex {
  std::int64_t first = 0;   ///< j
  std::int64_t second = 0;  ///< k

  auto operator<=>(const LatticeIndex&) const = default;  ///< compares j, then k
};

/// A lattice of the plane: all vectors \f$ w = j a_1 + k a_2 \f$ with integers j and k.
///
/// The computations use a reduced basis \f$ b_1, b_2 \f$ of the same lattice: \f$ b_1 \f$ is a
/// shortest vector, and \f$ \tau = b_2/b_1 \f$ satisfies \f$ |\mathrm{Re}\,\tau| \le \frac12 \f$
/// and \f$ \mathrm{Im}\,\tau > 0 \f$. A cell that is sheared by any amount is therefore as easy as
/// the same cell after a shear of at most one half.
class Lattice {
 public:
  /// Reduces the basis.
  ///
  /// @param  a1, a2  any basis, length
  /// @throws std::invalid_argument when a vector is zero or not finite, or when the vectors are
  ///         parallel to rounding: the sine of their angle is below 1e-12
  Lattice(Complex a1, Complex a2);

  /// Returns the shortest vector \f$ b_1 \f$ of the reduced basis, length.
  Complex shortest() const { return b1_; }

  /// Returns the second vector \f$ b_2 \f$ of the reduced basis, length.
  Complex second() const { return b2_; }

  /// Returns the area V of a cell, \f$ |a_1 \times a_2| \f$, length^2.
  double area() const { return area_; }

  /// Returns \f$ j a_1 + k a_2 \f$, in the basis that was given, length.
  Complex vector(LatticeIndex index) const;

  /// Returns the coefficients of a lattice vector in the basis that was given.
  LatticeIndex index(Complex vector) const;

  /// Returns the lattice vector that is nearest to a vector z, length.
  ///
  /// The point \f$ z \f$ minus this vector lies in the Voronoi cell of the origin. If several
  /// vectors are equally near, the choice depends on rounding.
  Complex nearest(Complex z) const;

  /// Moves a point by a lattice vector, so that no image of the point is nearer to the centre.
  Complex wrap(Complex z, Complex centre) const { return z - nearest(z - centre); }

  /// Returns the six corners of the Voronoi cell of the origin, counter-clockwise, length.
  ///
  /// All corners have the same distance from the origin: no point of the cell is farther away. In a
  /// rectangular lattice, two pairs of corners coincide.
  std::array<Complex, 6> voronoi_corners() const;

  /// Returns the distance of the corners of a Voronoi cell from its centre, length.
  double circumradius() const { return std::abs(voronoi_corners()[0]); }

  /// Returns the vectors w for which a point z + w lies in a disk, length.
  std::vector<Complex> vectors_into_disk(Complex z, Complex centre, double radius) const;

  /// Returns one of every pair w, -w of the vectors with \f$ 0 < |w| < r \f$, length.
  ///
  /// Sums over such a half are symmetric by construction: rounding cannot separate w from -w.
  std::vector<Complex> half_disk(double radius) const;

 private:
  Complex a1_, a2_, b1_, b2_;
  double area_;
};

}  // namespace stokesbook
