#pragma once

#include <span>
#include <vector>

#include "closure/closure.hpp"
#include "double_layer/flow_derivatives.hpp"

namespace stokesbook {

/// Computes the traction at the N nodes of one curve, as boundary_traction() does.
ComplexVector traction_on(const Curve& curve, std::span<const FlowDerivatives> at_nodes,
                          double viscosity);

/// Computes the traction \f$ \sigma n \f$ at the nodes of every component, with n out of the fluid:
/// the force per length that the body or wall exerts on the fluid.
///
/// @param  at_nodes  derivatives of the whole flow at all n nodes, limits from the fluid: those of
///                   SolvedFlow::derivatives() plus those of the background
/// @return           n tractions, force / length^2
/// @throws std::invalid_argument when the numbers of nodes differ
ComplexVector boundary_traction(const StokesProblem& problem,
                                const std::vector<FlowDerivatives>& at_nodes);

/// Integrates the traction of every component, \f$ F_k = \oint\sigma n\,ds \f$ and
/// \f$ L_k = \oint(x-c_k)\times\sigma n\,ds \f$.
///
/// @param  traction  from boundary_traction()
/// @return           force and torque of each component on the fluid, about its centre
/// @par Accuracy     agree with the loads of the same solution to 1e-14: @ref claim_07_14; these
/// loads converge geometrically in the nodes, @ref claim_07_17
std::vector<Load> integrated_loads(const StokesProblem& problem, const ComplexVector& traction);

}  // namespace stokesbook
