#pragma once

#include <vector>

#include "stress/solved_flow.hpp"
#include "suspension/solver/solution.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Evaluates the fluid's velocity, see SuspensionSolver::velocity().
///
/// @param  scene     that was solved
/// @param  plan      of the scene
/// @param  solution  of any instant
/// @param  points    m points in the fluid or on its boundary, length
/// @return           m velocities, length / time
ComplexVector flow_velocity(const Scene& scene, const Plan& plan, const Solution& solution,
                            const ComplexVector& points);

/// Prepares the evaluation of stresses and powers, see SuspensionSolver::disturbance().
///
/// @param  scene     that was solved
/// @param  plan      of the scene
/// @param  solution  of any instant
/// @return           the flow without the background, near the boundary by the Cauchy scheme
SolvedFlow disturbance(const Scene& scene, const Plan& plan, const Solution& solution);

/// Evaluates pressure over viscosity, vorticity and strain, see SuspensionSolver::derivatives().
///
/// @param  scene     that was solved
/// @param  plan      of the scene
/// @param  solution  of any instant
/// @param  points    m points in the fluid, or nodes of its boundary, length
/// @return           m values, 1 / time
std::vector<FlowDerivatives> flow_derivatives(const Scene& scene, const Plan& plan,
                                              const Solution& solution,
                                              const ComplexVector& points);

/// @}

}  // namespace stokesbook
