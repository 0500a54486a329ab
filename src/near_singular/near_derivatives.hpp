#pragma once

#include <vector>

#include "near_singular/near_targets.hpp"

namespace stokesbook {

/// Evaluates pressure, vorticity and strain of the double layers of several curves at any distance
/// from the curves: by the trapezoid rule, or by the Cauchy scheme where this rule is too coarse.
///
/// On a node of a curve the values are the limits from the fluid.
/// @param  curves     placed curves, in the order of the densities, with the Cauchy scheme
/// @param  density    at all nodes, in the curves' order, length / time
/// @param  targets    m points of the fluid or its boundary, length
/// @param  tolerance  relative to the densities' derivatives, > 0; decides which targets are near
/// @return            m values, 1 / time
/// @throws std::invalid_argument when a curve has another scheme
/// @par Accuracy  1e-11 relative, once the densities are resolved: @ref claim_06_8
/// @par Cost      m n kernel evaluations, O(N^2) per curve with near targets, 50 N operations per
/// near target
std::vector<FlowDerivatives> double_layer_derivatives(const std::vector<PlacedCurve>& curves,
                                                      const ComplexVector& density,
                                                      const ComplexVector& targets,
                                                      double tolerance);

/// Evaluates the difference between double_layer_derivatives() and StressletSum::derivatives(), for
/// callers that evaluate the trapezoid sum by another method. Parameters and exceptions are the
/// same. The difference is zero at targets that are not near.
///
/// @par Cost      O(N^2) per curve with near targets, 50 N operations per near target
std::vector<FlowDerivatives> near_derivative_corrections(const std::vector<PlacedCurve>& curves,
                                                         const ComplexVector& density,
                                                         const ComplexVector& targets,
                                                         double tolerance);

}  // namespace stokesbook
