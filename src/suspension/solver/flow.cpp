// Evaluates the flow of a solution, near curves and far from them (chapters 06 to 08 and 12).
#include "suspension/solver/flow.hpp"

#include "suspension/bodies/background_flow.hpp"
#include "suspension/solver/instant_problem.hpp"
#include "suspension/system/near_curves.hpp"

namespace stokesbook {

namespace {

// Sums by the fast multipole method or directly, whichever is faster for the number of targets.
FlowSum planned_sum(const Plan& plan) {
  const auto choice = [=](const SolvedFlow& flow, const ComplexVector& targets) {
    const bool fast = plan.is_fast_at(targets.size(), flow.density().size());
    return fast ? fast_sum(plan.sum_tolerance) : direct_sum();
  };
  return {[=](const SolvedFlow& flow, const ComplexVector& targets) {
            return choice(flow, targets).velocity(flow, targets);
          },
          [=](const SolvedFlow& flow, const ComplexVector& targets) {
            return choice(flow, targets).derivatives(flow, targets);
          }};
}

}  // namespace

ComplexVector flow_velocity(const Scene& scene, const Plan& plan, const Solution& solution,
                            const ComplexVector& points) {
  const auto& [configuration, amplitude] = solution.instant;
  const StokesProblem problem = instant_problem(scene, solution.instant, solution.discretisation);
  const auto near_curves = scene.solver.near_singular == NearSingular::off
                               ? std::vector<PlacedCurve>{}
                               : placed_schemes(configuration, solution.discretisation);
  ComplexVector velocity =
      SolvedFlow(problem, near_curves, solution.density, {plan.near_tolerance, planned_sum(plan)})
          .velocity(points);
  if (is_bounded(problem)) return velocity.array() + frame_velocity(scene, amplitude);
  return velocity + amplitude * background_velocity(scene.flow, points);
}

SolvedFlow disturbance(const Scene& scene, const Plan& plan, const Solution& solution) {
  return {instant_problem(scene, solution.instant, solution.discretisation),
          placed_cauchy_schemes(solution.instant.configuration, solution.discretisation),
          solution.density,
          {plan.near_tolerance, planned_sum(plan)}};
}

std::vector<FlowDerivatives> flow_derivatives(const Scene& scene, const Plan& plan,
                                              const Solution& solution,
                                              const ComplexVector& points) {
  const SolvedFlow flow = disturbance(scene, plan, solution);
  std::vector<FlowDerivatives> derivatives = flow.derivatives(points);
  if (is_bounded(flow.problem())) return derivatives;
  const double amplitude = solution.instant.amplitude;
  const std::vector<FlowDerivatives> background = background_derivatives(scene.flow, points);
  for (std::size_t i = 0; i < derivatives.size(); ++i) {
    const auto& [pressure, vorticity, strain] = background[i];
    derivatives[i] += {amplitude * pressure, amplitude * vorticity, amplitude * strain};
  }
  return derivatives;
}

}  // namespace stokesbook
