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
std::shared_ptr<const CauchyCurve> cauchy_of(const Reference& reference) {
  return reference.cauchy ? reference.cauchy : std::make_shared<const CauchyCurve>(reference.curve);
}

}  // namespace

std::vector<PlacedCurve> SuspensionSolver::placed(const Configuration& configuration,
                                                  const References& references) const {
  std::vector<PlacedCurve> placed;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Reference& reference = *references[k];
    CloseScheme scheme = cauchy_of(reference);
    if (reference.interpolation) scheme = reference.interpolation;
    placed.push_back({scheme, configuration[k].position, configuration[k].orientation});
  }
  return placed;
}

std::vector<PlacedCurve> SuspensionSolver::near_curves(const Configuration& configuration,
                                                       const References& references) const {
  return plan_.near_correction ? placed(configuration, references) : std::vector<PlacedCurve>{};
}

ComplexVector SuspensionSolver::velocity(const Configuration& configuration,
                                         const Solution& solution, const ComplexVector& points,
                                         double drive) const {
  const StokesProblem problem = this->problem(configuration, solution.references, drive);
  const auto near_curves = scene_.solver.near_singular == NearSingular::off
                               ? std::vector<PlacedCurve>{}
                               : placed(configuration, solution.references);
  ComplexVector velocity =
      SolvedFlow(problem, near_curves, solution.density, {plan_.near_tolerance, planned_sum(plan_)})
          .velocity(points);
  if (is_bounded(problem)) return velocity.array() + frame_velocity(drive);
  return velocity + drive * background_velocity(scene_.flow, points);
}

SolvedFlow SuspensionSolver::disturbance(const Configuration& configuration,
                                         const Solution& solution, double drive) const {
  std::vector<PlacedCurve> curves;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    curves.push_back({cauchy_of(*solution.references[k]), position, orientation});
  }
  return {problem(configuration, solution.references, drive),
          std::move(curves),
          solution.density,
          {plan_.near_tolerance, planned_sum(plan_)}};
}

std::vector<FlowDerivatives> SuspensionSolver::derivatives(const Configuration& configuration,
                                                           const Solution& solution,
                                                           const ComplexVector& points,
                                                           double drive) const {
  const SolvedFlow flow = disturbance(configuration, solution, drive);
  std::vector<FlowDerivatives> derivatives = flow.derivatives(points);
  if (is_bounded(flow.problem())) return derivatives;
  const std::vector<FlowDerivatives> background = background_derivatives(scene_.flow, points);
  for (std::size_t i = 0; i < derivatives.size(); ++i) {
    const auto& [pressure, vorticity, strain] = background[i];
    derivatives[i] += {drive * pressure, drive * vorticity, drive * strain};
  }
  return derivatives;
}

}  // namespace stokesbook
