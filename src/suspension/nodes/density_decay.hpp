#pragma once

#include "suspension/bodies/gaps.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// A mode number's rates of decay on the two curves of a gap; infinite where the gap asks for
/// nothing.
struct DensityDecay {
  double a,  ///< rate on the one curve, > 0
      b;     ///< rate on the other curve, > 0
};

/// Estimates how fast the density's Fourier modes decay on the two curves of a gap,
/// \f$ |\eta_k| \sim e^{-\alpha k} \f$.
///
/// Reflections between two circles of signed curvatures \f$ \kappa_1, \kappa_2 \f$ (positive where
/// the fluid lies outside) at gap g pile up at the limit points of bipolar coordinates, at c on
/// their axis:
/// \f[ c^2 = \frac{g\,(2+g\kappa_1)(2+g\kappa_2)(2\kappa_1+2\kappa_2+g\kappa_1\kappa_2)}
///              {4(\kappa_1+\kappa_2+g\kappa_1\kappa_2)^2}, \qquad
///     \alpha = \frac{\mathrm{asinh}(c\kappa)}{\kappa|x'|}. \f]
/// Exact for circles, local for other curves.
/// @param  a       one curve
/// @param  b       the other
/// @param  points  where they come closest, gap > 0
/// @return         a mode number's rates of decay, dimensionless
DensityDecay density_decay(const SmoothCurve& a, const SmoothCurve& b, const ClosestPoints& points);

/// Estimates the error of velocities, relative to their scale, that n nodes leave at a rate of
/// decay: functionals of the density, like rigid motions and loads, converge like the square of its
/// tail: \f$ 150\,\alpha\, e^{-\alpha n} \f$.
///
/// @param  decay    alpha, from density_decay()
/// @param  n_nodes  n, on the curve
/// @return          relative error, dimensionless; 0 where the gap asks for nothing
double resolution_error(double decay, Eigen::Index n_nodes);

/// Describes how fast densities decay at a gap, and how well the nodes of its curves resolve it.
struct GapResolution {
  DensityDecay decay;  ///< of the densities on gap.a and gap.b
  double error;        ///< estimate for the nodes they have, relative to the velocity scale
};

/// Estimates how well a gap is resolved, before any solve.
///
/// @param  gap             of two components, > 0
/// @param  configuration   poses of all components
/// @param  discretisation  of each component
/// @return                 rates of decay and estimated error
GapResolution gap_resolution(const Gap& gap, const Configuration& configuration,
                             const Discretisation& discretisation);

/// Recommends the number of nodes for which resolution_error() meets a tenth of a tolerance, so
/// that estimate_error() mostly meets the tolerance too.
///
/// @param  decay      alpha, from density_decay()
/// @param  tolerance  of velocities relative to their scale, > 0
/// @return            multiple of 16, from 0, where the gap asks for nothing, to 1e9
int recommended_nodes(double decay, double tolerance);

/// What the Fourier modes of a computed density say about its resolution.
struct TailEstimate {
  double error;  ///< of velocities, relative to their scale
  double decay;  ///< a mode number's rate of decay in the middle of the spectrum, >= 0
};

/// Estimates the error of velocities from the tail of a computed density on one component: sixty
/// times the square of the sum of the modes beyond its grid, over its largest value; at most ten
/// times the sum itself, which is all that a density of mere rounding errors can do.
///
/// The sum is extrapolated from the middle of the spectrum. The last modes enter without
/// extrapolation: near a close neighbour they are aliases, which harm velocities less. Measured on
/// 56 random scenes of two and three bodies: 0.5 to 4000 times the error, half of them within 20.
///
/// @param  density  at the component's N nodes, N even and >= 8, without its rigid part, length /
///                  time
/// @param  scale    of velocities, > 0, length / time
/// @return          estimated error and rate of decay; 0 and infinite for a density of zeros
/// @par Cost        O(N log N)
TailEstimate tail_estimate(const ComplexVector& density, double scale);

/// @}

}  // namespace stokesbook
