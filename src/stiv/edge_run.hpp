#pragma once

#include <array>

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// A straight piece of a path, or of a polygon.
struct Chord {
  Complex from;  ///< start, length
  Complex to;    ///< end, length
};

/// Eight edges of a polygon, looked at side by side.
class EdgeRun {
 public:
  /// How many edges there are.
  static constexpr Eigen::Index size = 8;

  /// Where the edges are closest to a point.
  struct Closest {
    double squared_distance;  ///< length squared
    Eigen::Index edge;        ///< number, the least of equally close ones
    double fraction;          ///< of the edge that is before the closest place, 0 to 1
  };

  /// Takes edges.
  /// @param  edges  of positive length each
  explicit EdgeRun(const std::array<Chord, size>& edges);

  /// Finds the edge that is closest to a point.
  /// @param  z  point, length
  /// @return    edge and place
  Closest closest(Complex z) const;

  /// Tells whether a straight piece of a path keeps away from all edges.
  /// @param  chord     start and end, length
  /// @param  distance  to keep, >= 0, length
  /// @return           true when all its points are farther than that
  bool is_clear_of(const Chord& chord, double distance) const;

 private:
  using Lanes = Eigen::Array<double, size, 1>;  // a number for each edge

  Lanes x_, y_, dx_, dy_;  // starts, and from there to the ends
  Lanes inverse_;          // of squared lengths
};

/// @}

}  // namespace stokesbook
