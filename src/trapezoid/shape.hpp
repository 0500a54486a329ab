#pragma once

#include <functional>
#include <string>
#include <variant>

#include "trapezoid/fourier.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook {

/// Circle about the origin.
struct Circle {
  double radius = 1.0;                             ///< length, > 0
  bool operator==(const Circle&) const = default;  ///< compares all members
};

/// Ellipse \f$ (a \cos t, b \sin t) \f$.
struct Ellipse {
  double a = 1.0;                                   ///< semi-axis along direction 1, length, > 0
  double b = 1.0;                                   ///< semi-axis along direction 2, length, > 0
  bool operator==(const Ellipse&) const = default;  ///< compares all members
};

/// Star \f$ r(t) = R (1 + A \cos(k t)) \f$.
struct Star {
  double radius = 1.0;                           ///< R, length, > 0
  double amplitude = 0.2;                        ///< A, |A| < 1
  int arms = 5;                                  ///< k >= 1
  bool operator==(const Star&) const = default;  ///< compares all members
};

/// Superellipse \f$ |x/a|^p + |y/b|^p = 1 \f$ with an even integer p, for which the curve is
/// analytic.
struct Superellipse {
  double a = 1.0;  ///< semi-axis along direction 1, length, > 0
  double b = 1.0;  ///< semi-axis along direction 2, length, > 0
  int power = 4;   ///< p, even, >= 2
  bool operator==(const Superellipse&) const = default;  ///< compares all members
};

/// Closed curve through given points by Fourier interpolation; the points are equidistant in the
/// parameter. The origin must lie inside the curve, because external forces act there.
struct NodalCurve {
  ComplexVector points;  ///< in order along the curve, in either direction; at least 4
  std::string file;      ///< file of the points, for messages; may be empty

  /// Compares the points, and ignores the names of the files.
  bool operator==(const NodalCurve& other) const {
    return points.size() == other.points.size() && points == other.points;
  }
};

/// A closed smooth curve in its own frame.
using Shape = std::variant<Circle, Ellipse, Star, Superellipse, NodalCurve>;

/// A closed curve as a function of its parameter t, of period \f$ 2\pi \f$. The function returns
/// x(t), x'(t) and x''(t), length.
using Parametrisation = std::function<TrigonometricPolynomial::Jet(double)>;

/// Parametrises a shape counter-clockwise, in the frame of the shape. The parametrisation of a
/// NodalCurve is its trigonometric interpolant.
///
/// @par Cost  O(1) per point; for a NodalCurve with p points O(p)
Parametrisation parametrisation(const Shape& shape);

/// Enlarges a shape about its origin by a factor > 0.
Shape scaled(Shape shape, double factor);

/// Returns the points of a NodalCurve in counter-clockwise order.
ComplexVector counter_clockwise(const NodalCurve& shape);

}  // namespace stokesbook
