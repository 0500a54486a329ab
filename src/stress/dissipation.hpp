#pragma once

#include <functional>
#include <vector>

#include "stress/fluid_quadrature.hpp"
#include "stress/solved_flow.hpp"

namespace stokesbook {

/// Integrates the power that the surface of each component puts into the fluid,
/// \f$ \oint u\cdot\sigma n\,ds \f$.
///
/// The sum over all components is the dissipation of the fluid (07.11), if the fluid is enclosed.
/// In an unbounded fluid the sum is the dissipation if the fluid rests at infinity and the total
/// force vanishes.
/// @param  traction  of the whole flow, from boundary_traction()
/// @return           one entry per component, force length / time per unit of depth
/// @par Accuracy     geometric in the nodes: @ref claim_07_18; equal to power_of_loads() if all
/// motions are rigid, @ref claim_07_19
std::vector<double> boundary_power(const SolvedFlow& flow, const ComplexVector& traction);

/// Computes the power of boundary_power() from motions and loads.
///
/// With the rigid part \f$ U + \omega(x-c)^\perp \f$ of the velocity g of a component,
/// \f[ \oint g\cdot\sigma n\,ds = U\cdot F + \omega L + \oint (g - U - \omega (x-c)^\perp)\cdot
///     \sigma n\,ds. \f]
/// The last term requires the traction, but only on walls that do not move rigidly.
/// @param  flow  of a problem without background
/// @return       one entry per component, force length / time per unit of depth
/// @throws std::invalid_argument when a wall that does not move rigidly has no Cauchy scheme
/// @par Cost     O(n), and the derivatives at the nodes of walls that do not move rigidly
std::vector<double> power_of_loads(const SolvedFlow& flow);

/// Integrates the power that the slip of free bodies puts into the fluid, the sum of
/// \f$ \oint g\cdot\sigma n\,ds \f$ over all bodies with the slip g.
///
/// power_of_loads() does not include this power.
/// @param  derivatives  returns the derivatives of the whole flow at given nodes, limits from the
///                      fluid; called once, with the nodes of all bodies that have slip
/// @return              force length / time per unit of depth
double slip_power(
    const StokesProblem& problem,
    const std::function<std::vector<FlowDerivatives>(const ComplexVector&)>& derivatives);

/// Integrates the dissipation \f$ \int 2\mu\,e:e\,dA \f$ over the fluid.
///
/// @param  at_points  derivatives of the whole flow at the rule's points
/// @par Accuracy      that of the rule, once the flow is resolved: @ref claim_07_20
double volume_dissipation(const FluidQuadrature& rule,
                          const std::vector<FlowDerivatives>& at_points, double mu);

}  // namespace stokesbook
