#pragma once

#include <vector>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup trapezoid
/// @{

/// A place on a curve where nodes crowd.
struct Cluster {
  double parameter = 0.0;  ///< t_c, radians
  double width = 1.0;      ///< delta, radians, > 0: nodes are dense where \f$ |t-t_c| < \delta \f$

  /// @return true when all members are equal
  bool operator==(const Cluster&) const = default;
};

/// How the nodes of a curve crowd: their density over the parameter t is proportional to
/// \f[ m(t) = 1 + b\sum_c \frac{1}{\sqrt{4\sin^2\frac{t-t_c}{2} + \delta_c^2}}. \f]
///
/// Nodes are equidistant in \f$ s(t) = \frac1C\int_0^t m,\ C = \frac{1}{2\pi}\int_0^{2\pi} m \f$,
/// which is analytic and of period \f$ 2\pi \f$: the trapezoid rule in s keeps its geometric rate.
/// Close to a cluster \f$ t - t_c = \delta\sinh(C(s-s_c)/b) \f$, and
/// \f$ C \approx 1 + \sum_c \frac{b}{\pi}\ln\frac{8}{\delta_c} \f$: nodes in numbers that grow as
/// the logarithm of the width resolve what equidistant ones resolve in numbers that grow as its
/// inverse.
struct Grading {
  std::vector<Cluster> clusters;  ///< none: equidistant in t
  double strength = 2.0;          ///< b, > 0: more leaves fewer nodes to the rest of the curve

  /// @return true when all members are equal
  bool operator==(const Grading&) const = default;
};

/// A node's parameter, and its derivatives with respect to s.
struct GradedParameter {
  double t,  ///< radians, modulo 2 pi: near a cluster at 0 it keeps its digits on both sides
      dt,    ///< dt/ds, > 0
      ddt;   ///< d2t/ds2
};

/// Finds the parameters of graded nodes.
///
/// @param  grading  where nodes crowd
/// @param  n        number of nodes, >= 1
/// @return          t(s_j) at \f$ s_j = 2\pi j/n \f$; t(0) = 0
/// @throws std::invalid_argument when a width or the strength is not positive, or a number is not
///                  finite
/// @par Accuracy    rounding; near a cluster t - t_c errs by rounding of its width, not of t_c:
/// @ref claim_01_17
/// @par Cost        about six evaluations of m a node, each an elliptic integral a cluster
std::vector<GradedParameter> graded_parameters(const Grading& grading, Eigen::Index n);

/// Samples a shape at graded nodes, in its own frame; dx and ddx of the curve are derivatives with
/// respect to s.
///
/// @param  shape    in its own frame
/// @param  n        number of nodes, even, >= 4
/// @param  side     where the fluid lies
/// @param  grading  where nodes crowd; without clusters the result is that of sample() without it
/// @return          n nodes, counter-clockwise
/// @throws std::invalid_argument when n is odd or too small, or as graded_parameters()
/// @par Accuracy    rounding; of the rule: geometric in n, @ref claim_01_15
/// @par Cost        as graded_parameters(); for a NodalCurve with p points n p more
Curve sample(const Shape& shape, Eigen::Index n, Side side, const Grading& grading);

/// Samples a shape as above where the parameters of its nodes are known.
///
/// @param  shape       closed curve
/// @param  parameters  of the nodes, from graded_parameters()
/// @param  side        where the fluid is
/// @return             nodes
Curve sample(const Shape& shape, const std::vector<GradedParameter>& parameters, Side side);

/// Computes where parameters lie among graded nodes: the inverse of graded_parameters(), with the
/// rounding of t stretched by dt/ds.
///
/// @param  grading     where nodes crowd
/// @param  parameters  t, radians; their derivatives do not count
/// @return             s(t), radians; t itself without clusters
/// @throws std::invalid_argument as graded_parameters()
/// @par Cost           an integral a parameter and cluster
std::vector<double> graded_positions(const Grading& grading,
                                     const std::vector<GradedParameter>& parameters);

/// Computes where one parameter lies, as graded_positions() does.
///
/// @param  grading    where nodes crowd
/// @param  parameter  t, radians
/// @return            s(t), radians
/// @throws std::invalid_argument as graded_parameters()
double graded_position(const Grading& grading, double parameter);

/// Computes how far from the real s axis a singularity at \f$ t = p + id \f$ comes to lie:
/// \f[ |\mathrm{Im}\,s| = \frac1C\Bigl(d + b\sum_c \mathrm{Im}\int_0^{p+id-t_c}
///     \frac{d\tau}{\sqrt{4\sin^2\frac\tau2+\delta_c^2}}\Bigr). \f]
///
/// This is the rate at which the modes of such a function decay, and half of it where the rule
/// integrates products of two. Over a cluster the integral is \f$ \arcsin(d/\delta) \f$, and stays
/// at \f$ \pi/2 \f$ for all deeper ones: a width equal to the depth loses nothing. Singularities of
/// t(s) itself lie about twice as deep as its clusters' widths.
/// @param  grading    where nodes crowd
/// @param  parameter  p, radians
/// @param  depth      d, radians, > 0; may be infinite
/// @return            rate, radians; d itself without clusters
/// @throws std::invalid_argument as graded_parameters()
/// @par Accuracy      1e-14 relative; rates of convergence: @ref claim_01_16, @ref claim_01_18
double graded_depth(const Grading& grading, double parameter, double depth);

/// Computes graded_depth() for gradings that differ in their strength only, for the cost of one.
///
/// @param  clusters   of all gradings
/// @param  strengths  of the gradings
/// @param  parameter  p, radians
/// @param  depth      d, radians, > 0; may be infinite
/// @return            rate for each strength, radians
/// @throws std::invalid_argument as graded_parameters()
/// @par Cost          two elliptic integrals a cluster
std::vector<double> graded_depths(const std::vector<Cluster>& clusters,
                                  const std::vector<double>& strengths, double parameter,
                                  double depth);

/// @}

}  // namespace stokesbook
