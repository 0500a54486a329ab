#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "suspension/bodies/gaps.hpp"

namespace stokesbook {

/// Largest number of nodes that is chosen for one component: the matrices of its shape take 0.4 GB.
inline constexpr int most_nodes_of_a_component = 2048;

/// Largest number of nodes that is tested for a shape alone.
inline constexpr int most_nodes_for_shape = 4096;

/// Recommends a number of nodes that resolve a shape and its own double layer to a tolerance.
///
/// @param  tolerance  of shape_residual()
/// @return            multiple of 16, >= at_least, or 0 if most_nodes_for_shape do not suffice
int nodes_for_shape(const Shape& shape, Side side, double tolerance, int at_least);

/// Recommends a number of nodes for which softest_mode_error() is at most a tenth.
///
/// @param  n_nodes  number with which the search starts, <= most_nodes_of_a_component
/// @return          n_nodes if it suffices, otherwise a multiple of 4; the last number tested if no
///                  number up to most_nodes_of_a_component suffices
/// @par Cost        softest_mode_error() for two or three numbers
int nodes_for_softest_mode(DiscretisationCache& cache, const Shape& shape, ComponentKind kind,
                           int n_nodes);

/// Explains that no number of nodes resolves a shape, and what to change, in a clause that follows
/// the name of the component.
std::string unresolved_shape(const Shape& shape, double tolerance);

/// Returns the given number of nodes of a component, or a number that resolves its shape if nodes
/// are automatic.
///
/// @throws SolverError when most_nodes_for_shape do not suffice
int own_nodes(const Shape& shape, int n_nodes, Side side, double tolerance,
              const std::string& name);

/// The rates, per mode number, at which a density's Fourier modes decay on the two curves of a gap;
/// infinite if the gap requires no nodes.
struct DensityDecay {
  double a,  ///< on the one curve, > 0
      b;     ///< on the other curve, > 0
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
/// points, whose gap must be positive.
DensityDecay density_decay(const SmoothCurve& a, const SmoothCurve& b, const ClosestPoints& points);

/// The rates at which densities decay at a gap, and how well the nodes of its curves resolve them.
struct GapResolution {
  DensityDecay decay;  ///< decay of the densities on gap.a and gap.b
  double error;        ///< estimate for the present nodes, relative to the velocity scale:
                       ///< \f$ 150\,\alpha\, e^{-\alpha n} \f$ for n nodes
};

/// Estimates how well a gap > 0 is resolved, before any solve.
GapResolution gap_resolution(const Gap& gap, const Configuration& configuration,
                             const Discretisation& discretisation);

/// Recommends the number of nodes for which the error in gap_resolution() is a tenth of a
/// tolerance, so that estimate_error() is below the tolerance in most cases.
///
/// @param  decay  alpha, from density_decay()
/// @return        multiple of 16, from 0 (the gap requires no nodes) to 1e9
int nodes_for_decay(double decay, double tolerance);

/// The requirement of one gap on the nodes of one of its curves.
struct GapRequirement {
  double parameter;  ///< parameter of the closest point, radians
  double depth;      ///< the density's rate of decay there, from density_decay(); may be infinite
};

/// Chooses a component's nodes for its shape and its gaps.
///
/// Nodes crowd at every gap that the nodes of the shape do not resolve, over a width equal to the
/// depth of the gap, unless a cluster nearby suffices. Nodes are equidistant if at most 1.3 times
/// as many equidistant nodes suffice.
///
/// The number of graded nodes is \f$ \ln(10^5/\varepsilon)/r \f$, where r is the least
/// graded_depth() of all gaps, and of a shape that requires `shape_nodes` nodes because of
/// singularities all around the curve. The strength is the one that requires the fewest nodes.
/// @param  shape_nodes  number of nodes that the shape requires without gaps, > 0
/// @param  tolerance    of velocities relative to their scale, > 0
/// @throws std::invalid_argument when shape_nodes, the tolerance or a depth is not positive
/// @par Accuracy        circles meet the tolerance at gaps down to 1e-5: @ref claim_03_38,
/// @ref claim_03_39, @ref claim_03_40
/// @par Not for         tolerances below the effect of rounding, about 1e-16 gap^(-3/2)
Resolution nodes_for_gaps(const std::vector<GapRequirement>& gaps, int shape_nodes,
                          double tolerance);

/// Rounds a number of nodes up to one of a few values, so that nearby configurations share
/// discretised shapes.
///
/// @return  multiple of 16, >= 16; from 256 on, a multiple of an eighth of the largest power of two
///          that does not exceed the number
int rounded_nodes(double nodes);

/// Recommends nodes for every component, so that shapes and gaps meet a tolerance.
///
/// @return  multiples of 16, one per component; 0 if most_nodes_for_shape do not suffice, and no
///          gap requires nodes
std::vector<int> recommended_nodes(const Discretisation& discretisation, double tolerance,
                                   const Configuration& configuration,
                                   const std::vector<Gap>& gaps);

/// Chooses the resolution with which a solve begins: given node numbers as they are, and automatic
/// ones from shapes and gaps, graded where a narrow gap requires it.
///
/// @param  discretisation  of each component alone
/// @param  gaps            from find_gaps()
Resolutions first_resolutions(const Scene& scene, const Discretisation& discretisation,
                              const Configuration& configuration, const std::vector<Gap>& gaps);

}  // namespace stokesbook
