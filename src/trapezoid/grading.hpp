#pragma once

#include <vector>

#include <Eigen/Core>

namespace stokesbook {

/// A place on a curve where nodes crowd.
struct Cluster {
  double parameter = 0.0;  ///< t_c, radians
  double width = 1.0;      ///< delta, radians, > 0: nodes are dense where \f$ |t-t_c| < \delta \f$

  bool operator==(const Cluster&) const = default;  ///< compares all members
};

/// Describes how the nodes of a curve crowd: the node density over the parameter t is proportional
/// to (06.18)
/// \f[ m(t) = 1 + b\sum_c \frac{1}{\sqrt{4\sin^2\frac{t-t_c}{2} + \delta_c^2}}. \f]
/// Chapter 06 calls m, delta, s and C of this comment \f$ \nu, \lambda, \theta \f$ and M.
///
/// Nodes are equidistant in \f$ s(t) = \frac1C\int_0^t m,\ C = \frac{1}{2\pi}\int_0^{2\pi} m \f$.
/// The map s is analytic and grows by \f$ 2\pi \f$ with t, so that the trapezoid rule in s
/// converges geometrically. To resolve a function that varies over the width \f$ \delta \f$, the
/// number of graded nodes grows as \f$ \ln(1/\delta) \f$, whereas the number of equidistant nodes
/// grows as \f$ 1/\delta \f$.
struct Grading {
  std::vector<Cluster> clusters;  ///< if empty, nodes are equidistant in t
  double strength = 2.0;          ///< b, > 0; a larger b leaves fewer nodes elsewhere on the curve

  bool operator==(const Grading&) const = default;  ///< compares all members
};

/// A node's parameter, and its derivatives with respect to s.
struct GradedParameter {
  double t,  ///< radians, modulo 2 pi; accurate relative to |t| on both sides of a cluster at 0
      dt,    ///< dt/ds, > 0
      ddt;   ///< d2t/ds2
};

/// Finds the parameters of graded nodes.
///
/// @return  t(s_j) at \f$ s_j = 2\pi j/n \f$, with t(0) = 0
/// @throws std::invalid_argument when a width or the strength is not positive, or a number is not
///          finite
/// @par Accuracy  rounding; near a cluster, the error of t - t_c is relative to the width of the
/// cluster, not to t_c: @ref claim_01_17
/// @par Cost      about six evaluations of s per node, each with an elliptic integral per cluster
std::vector<GradedParameter> graded_parameters(const Grading& grading, Eigen::Index n);

/// Computes s of given parameters t: the inverse of graded_parameters().
///
/// The map multiplies the rounding error of t by ds/dt, which is large near a cluster.
/// @param  parameters  t, radians; the derivatives dt and ddt are not used
/// @return             s(t), radians; t itself without clusters
/// @throws std::invalid_argument as graded_parameters()
/// @par Cost  one elliptic integral per parameter and cluster
std::vector<double> graded_positions(const Grading& grading,
                                     const std::vector<GradedParameter>& parameters);

/// Computes the distance from the real s axis of a singularity at \f$ t = p + id \f$ (06.19):
/// \f[ |\mathrm{Im}\,s| = \frac1C\Bigl(d + b\sum_c \mathrm{Im}\int_0^{p+id-t_c}
///     \frac{d\tau}{\sqrt{4\sin^2\frac\tau2+\delta_c^2}}\Bigr). \f]
///
/// The Fourier coefficients of a function with this singularity decay at this rate, and so does the
/// error of the rule with the number of nodes; interpolants converge at half of the rate (chapter
/// 01).
/// @param  parameter  p, radians
/// @param  depth      d, radians, > 0; may be infinite
/// @return            radians; d itself without clusters
/// @throws std::invalid_argument as graded_parameters()
/// @par Accuracy  1e-14 relative; rates of convergence: @ref claim_01_16, @ref claim_01_18
double graded_depth(const Grading& grading, double parameter, double depth);

/// Computes graded_depth() for gradings that differ only in their strength, at the cost of one: two
/// elliptic integrals per cluster.
std::vector<double> graded_depths(const std::vector<Cluster>& clusters,
                                  const std::vector<double>& strengths, double parameter,
                                  double depth);

}  // namespace stokesbook
