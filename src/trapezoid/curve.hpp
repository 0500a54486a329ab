#pragma once

#include <vector>

#include <Eigen/Core>

#include "trapezoid/grading.hpp"
#include "trapezoid/plane.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// The side of a curve on which the fluid lies. The value is the sign s of (01.3).
enum class Side : int {
  fluid_outside = -1,  ///< bodies and inner walls
  fluid_inside = +1    ///< the enclosing wall
};

/// Collocation nodes \f$ x(t_j), t_j = 2\pi j/N \f$ of a smooth closed curve, counter-clockwise.
///
/// The parameter t is the one in which the nodes are equidistant: the parameter s of Grading for
/// graded nodes.
struct Curve {
  ComplexVector x;                  ///< nodes, length
  ComplexVector dx;                 ///< \f$ x'(t_j) \f$, length
  ComplexVector ddx;                ///< \f$ x''(t_j) \f$, length
  Side side = Side::fluid_outside;  ///< side on which the fluid lies

  Eigen::Index size() const { return x.size(); }             ///< returns the number N of nodes
  double sign() const { return static_cast<double>(side); }  ///< returns s of (01.3), +1 or -1
};

/// Samples a shape at n nodes, equidistant or graded, in the frame of the shape.
///
/// Derivatives are exact; the derivatives of a NodalCurve are those of its Fourier interpolant.
/// @param  n      number of nodes, even, >= 4
/// @throws std::invalid_argument when n is odd or too small, or when graded_parameters() throws
/// @par Accuracy  rounding; derivatives of a NodalCurve: geometric in its number of points,
/// @ref claim_01_8; the rule at graded nodes: geometric in n, @ref claim_01_15
/// @par Cost      O(n); for a NodalCurve with p points O(n log n + p log p); graded: that of
/// graded_parameters(), and n p more for a NodalCurve
/// @par Not for   fewer nodes than a NodalCurve has points: the highest modes are dropped
Curve sample(const Shape& shape, Eigen::Index n, Side side, const Grading& grading = {});

/// Samples a shape at graded nodes whose parameters are known from graded_parameters().
Curve sample(const Shape& shape, const std::vector<GradedParameter>& parameters, Side side);

/// Samples the trigonometric interpolants of a curve and its derivatives at m equidistant
/// parameters.
///
/// Accuracy, cost and exceptions are those of resample() for node values.
Curve resample(const Curve& curve, Eigen::Index m);

/// Moves a curve from its own frame into the plane: \f$ x \to c + e^{i\theta} x \f$.
///
/// @param  orientation  theta, radians, counter-clockwise
Curve place(const Curve& reference, Complex position, double orientation);

/// Collects the nodes of several curves, curve by curve.
ComplexVector all_nodes(const std::vector<Curve>& curves);

/// Returns the weights \f$ w_j = |x'(t_j)| 2\pi/N \f$ (01.2) of the trapezoid rule in arclength.
///
/// @par Accuracy  of the rule: geometric in N for analytic curves and integrands, with the distance
/// of the nearest pole as the rate: @ref claim_01_4; order 2 across a jump: @ref claim_01_3
/// @par Not for   integrands that are singular, or nearly so, on the curve: use near_singular
Eigen::VectorXd weights(const Curve& curve);

/// Returns the unit normals \f$ n = -i s x'/|x'| \f$ (01.3).
///
/// Normals point out of the fluid: into bodies, and outward on the enclosing wall.
ComplexVector normals(const Curve& curve);

/// Returns the signed curvatures \f$ \kappa = (x' \times x'')/|x'|^3 \f$ (01.4).
///
/// Curvatures are positive where the curve is convex, on whichever side the fluid lies.
Eigen::VectorXd curvatures(const Curve& curve);

/// Returns the length \f$ |\Gamma| \f$ of the curve.
///
/// @par Accuracy  geometric in N for analytic curves: @ref claim_01_9
double perimeter(const Curve& curve);

/// Returns the enclosed area \f$ \frac12 \oint x \times dx > 0 \f$.
///
/// @par Accuracy  geometric in N for analytic curves: @ref claim_01_9
double area(const Curve& curve);

/// Returns the centroid \f$ \langle x \rangle \f$ of the curve, the mean of x over the arclength.
///
/// @par Accuracy  geometric in N for analytic curves: @ref claim_01_9
/// @par Not for   the centroid of the enclosed area, which is another point
Complex boundary_centroid(const Curve& curve);

/// Returns the largest distance of a node from a point; between nodes the curve may lie a little
/// farther away, see outer_radius().
double bounding_radius(const Curve& curve, Complex centre);

/// Returns an upper bound of the distance of a curve from a point, between nodes too.
///
/// Within half a spacing \f$ h = 2\pi/N \f$ of node j, \f$ g = |x-c|^2 \f$ is at most
/// \f$ g_j + |g'_j|\tau + \frac12 M\tau^2,\ 0\le\tau\le\frac12h \f$, where M is the largest
/// second derivative of g at the node and its two neighbours.
/// @return  the distance of the farthest node if no point of the curve is farther, otherwise a
///          little more than necessary
double outer_radius(const Curve& curve, Complex centre);

}  // namespace stokesbook
