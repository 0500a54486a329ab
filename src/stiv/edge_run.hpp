#pragma once

#include <array>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// A straight piece of a path, or of a polygon.
struct Chord {
  Complex from;  ///< start, length
  Complex to;    ///< end, length
};

/// Eight edges of a polygon, for which distances are computed side by side.
class EdgeRun {
 public:
  /// Number of edges.
  static constexpr Eigen::Index size = 8;

  /// The place of the edges that is closest to a point.
  struct Closest {
    double squared_distance;  ///< length squared
    Eigen::Index edge;        ///< number of the closest edge, the least number if several are
    double fraction;          ///< part of the edge before the closest place, 0 to 1
  };

  /// Stores eight edges of positive length.
  explicit EdgeRun(const std::array<Chord, size>& edges);

  /// Finds the edge that is closest to a point, and the closest place on it.
  Closest closest(Complex z) const;

  /// Returns whether all points of a chord are farther than a distance >= 0 from all edges.
  bool is_clear_of(const Chord& chord, double distance) const;

 private:
  using Lanes = Eigen::Array<double, size, 1>;  // one number for each edge

  Lanes x_, y_, dx_, dy_;  // starts, and vectors from starts to ends
  Lanes inverse_;          // inverse squared lengths
};

}  // namespace stokesbook
