// The flow of a solution, near curves and far from them.
#include "suspension/bodies/background_flow.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

namespace {

// Sums fast or directly, whichever takes less for the targets that come.
PlainSum planned_sum(const Plan& plan) {
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

// A component that is alone has none: only the flow near it asks for one.
std::shared_ptr<const CauchyCurve> cauchy_of(const DiscretisedShape& discretised) {
  return discretised.cauchy ? discretised.cauchy
                            : std::make_shared<const CauchyCurve>(discretised.curve);
}

}  // namespace

std::vector<PlacedCurve> SuspensionSolver::placed(const Configuration& configuration,
                                                  const Discretisation& discretisation) const {
  std::vector<PlacedCurve> placed;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const DiscretisedShape& discretised = *discretisation[k];
    CloseScheme scheme = cauchy_of(discretised);
    if (discretised.interpolation) scheme = discretised.interpolation;
    placed.push_back({scheme, configuration[k].position, configuration[k].orientation});
  }
  return placed;
}

std::vector<PlacedCurve> SuspensionSolver::near_curves(const Configuration& configuration,
                                                       const Discretisation& discretisation) const {
  return plan_.near_correction ? placed(configuration, discretisation) : std::vector<PlacedCurve>{};
}

ComplexVector SuspensionSolver::velocity(const Solution& solution,
                                         const ComplexVector& points) const {
  const auto& [configuration, amplitude] = solution.instant;
  const StokesProblem problem = this->problem(solution.instant, solution.discretisation);
  const auto near_curves = scene_.solver.near_singular == NearSingular::off
                               ? std::vector<PlacedCurve>{}
                               : placed(configuration, solution.discretisation);
  ComplexVector velocity =
      SolvedFlow(problem, near_curves, solution.density, {plan_.near_tolerance, planned_sum(plan_)})
          .velocity(points);
  if (is_bounded(problem)) return velocity.array() + frame_velocity(amplitude);
  return velocity + amplitude * background_velocity(scene_.flow, points);
}

SolvedFlow SuspensionSolver::disturbance(const Solution& solution) const {
  const Configuration& configuration = solution.instant.configuration;
  std::vector<PlacedCurve> curves;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    curves.push_back({cauchy_of(*solution.discretisation[k]), position, orientation});
  }
  return {problem(solution.instant, solution.discretisation),
          std::move(curves),
          solution.density,
          {plan_.near_tolerance, planned_sum(plan_)}};
}

std::vector<FlowDerivatives> SuspensionSolver::derivatives(const Solution& solution,
                                                           const ComplexVector& points) const {
  const SolvedFlow flow = disturbance(solution);
  std::vector<FlowDerivatives> derivatives = flow.derivatives(points);
  if (is_bounded(flow.problem())) return derivatives;
  const double amplitude = solution.instant.amplitude;
  const std::vector<FlowDerivatives> background = background_derivatives(scene_.flow, points);
  for (std::size_t i = 0; i < derivatives.size(); ++i) {
    const auto& [pressure, vorticity, strain] = background[i];
    derivatives[i] += {amplitude * pressure, amplitude * vorticity, amplitude * strain};
  }
  return derivatives;
}

}  // namespace stokesbook
