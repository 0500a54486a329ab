#pragma once

#include <Eigen/Core>

#include "trapezoid/plane.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// @addtogroup trapezoid
/// @{

/// The side of its curve on which the fluid lies; the value is the sign s of the formulas.
enum class Side : int {
  fluid_outside = -1,  ///< bodies and inner walls
  fluid_inside = +1    ///< the enclosing wall
};

/// Collocation nodes \f$ x(t_j), t_j = 2\pi j/N \f$ of a smooth closed curve, counter-clockwise.
struct Curve {
  ComplexVector x;                  ///< nodes, length
  ComplexVector dx;                 ///< \f$ x'(t_j) \f$, length
  ComplexVector ddx;                ///< \f$ x''(t_j) \f$, length
  Side side = Side::fluid_outside;  ///< where the fluid lies

  Eigen::Index size() const { return x.size(); }
  double sign() const { return static_cast<double>(side); }
};

/// Samples a shape at n equidistant parameters, in its own frame, with exact derivatives
/// (by Fourier interpolation for NodalCurve).
///
/// @param  shape  in its own frame
/// @param  n      number of nodes, even, >= 4
/// @param  side   where the fluid lies
/// @throws std::invalid_argument when n is odd or too small
Curve sample(const Shape& shape, Eigen::Index n, Side side);

/// Moves a curve from its own frame: \f$ x \to c + e^{i\theta} x \f$.
Curve place(const Curve& reference, Complex position, double orientation);

/// Returns the weights \f$ w_j = |x'(t_j)| 2\pi/N \f$ of the trapezoid rule in arclength, length.
Eigen::VectorXd weights(const Curve& curve);

/// Returns the unit normals \f$ n = -i s x'/|x'| \f$: out of the fluid (into bodies, outward on the
/// enclosing wall).
ComplexVector normals(const Curve& curve);

/// Returns the signed curvatures \f$ \kappa = (x' \times x'')/|x'|^3 \f$ (> 0 where convex), 1 /
/// length.
Eigen::VectorXd curvatures(const Curve& curve);

/// Returns the length of the curve.
double perimeter(const Curve& curve);

/// Returns the enclosed area \f$ \frac12 \oint x \times dx \f$.
double area(const Curve& curve);

/// Returns the centroid \f$ \langle x \rangle \f$ of the curve (not of the enclosed area).
Complex boundary_centroid(const Curve& curve);

/// Returns the largest distance of a node from a point.
double bounding_radius(const Curve& curve, Complex centre);

/// @}

}  // namespace stokesbook
