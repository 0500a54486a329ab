#pragma once

#include "suspension/bodies/gaps.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The rates, per mode number, at which a density's Fourier modes decay on the two curves of a gap;
/// infinite if the gap requires no nodes.
struct DensityDecay {
  double a,  ///< rate on the one curve, > 0
      b;     ///< rate on the other curve, > 0
};

/// Estimates how fast the density's Fourier modes decay on the two curves of a gap,
/// \f$ |\eta_k| \sim e^{-\alpha k} \f$.
///
/// Reflections between two circles of signed curvatures \f$ \kappa_1, \kappa_2 \f$ (positive where
/// the fluid lies outside) at a gap g accumulate at the two limit points of bipolar coordinates,
/// which lie at \f$ \pm c \f$ on the axis of these coordinates:
/// \f[ c^2 = \frac{g\,(2+g\kappa_1)(2+g\kappa_2)(2\kappa_1+2\kappa_2+g\kappa_1\kappa_2)}
///              {4(\kappa_1+\kappa_2+g\kappa_1\kappa_2)^2}, \qquad
///     \alpha = \frac{\mathrm{asinh}(c\kappa)}{\kappa|x'|}. \f]
/// These formulas are exact for circles. For other curves they use the curvatures at the closest
/// points.
/// @param  a       one curve
/// @param  b       the other curve
/// @param  points  where the curves are closest to each other, gap > 0
/// @return         rates of decay per mode number, dimensionless
DensityDecay density_decay(const SmoothCurve& a, const SmoothCurve& b, const ClosestPoints& points);

/// Estimates the error of velocities, relative to their scale, for n nodes and a rate of decay:
/// \f$ 150\,\alpha\, e^{-\alpha n} \f$.
///
/// Functionals of the density, such as rigid motions and loads, converge as the square of the tail
/// of the density.
/// @param  decay    alpha, from density_decay()
/// @param  n_nodes  n, on the curve
/// @return          relative error, dimensionless; 0 if the rate is infinite
double resolution_error(double decay, Eigen::Index n_nodes);

/// The rates at which densities decay at a gap, and how well the nodes of its curves resolve them.
struct GapResolution {
  DensityDecay decay;  ///< of the densities on gap.a and gap.b
  double error;        ///< estimate for the present nodes, relative to the velocity scale
};

/// Estimates how well a gap is resolved, before any solve.
///
/// @param  gap             of two components, > 0
/// @param  configuration   poses of all components
/// @param  discretisation  of each component
/// @return                 rates of decay and estimated error
GapResolution gap_resolution(const Gap& gap, const Configuration& configuration,
                             const Discretisation& discretisation);

/// Recommends the number of nodes for which resolution_error() is a tenth of a tolerance, so that
/// estimate_error() is below the tolerance in most cases.
///
/// @param  decay      alpha, from density_decay()
/// @param  tolerance  of velocities relative to their scale, > 0
/// @return            multiple of 16, from 0 (the gap requires no nodes) to 1e9
int recommended_nodes(double decay, double tolerance);

/// An error estimate from the Fourier modes of a computed density.
struct TailEstimate {
  double error;  ///< of velocities, relative to their scale
  double decay;  ///< rate of decay per mode number in the middle of the spectrum, >= 0
};

/// Estimates the error of velocities from the tail of a computed density on one component.
///
/// Let S be the sum of the modes beyond the grid, and M the largest value of the density. The
/// estimate is \f$ 60\,S^2/M \f$ over the scale, but at most 10 S over the scale: a density that
/// consists of rounding errors cannot cause more. S is extrapolated from the middle of the
/// spectrum. The last modes enter S without extrapolation: near a close neighbour they are aliases,
/// which harm velocities less.
///
/// On 56 random scenes of two and three bodies, the estimate was 0.5 to 4000 times the error, and
/// at most 20 times the error in half of the scenes.
/// @param  density  at the component's N nodes, N even and >= 8, without its rigid part, length /
///                  time
/// @param  scale    of velocities, > 0, length / time
/// @return          estimated error and rate of decay; 0 and infinite for a density of zeros
/// @par Cost        O(N log N)
TailEstimate tail_estimate(const ComplexVector& density, double scale);

/// @}

}  // namespace stokesbook
