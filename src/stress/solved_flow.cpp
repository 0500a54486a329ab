// Evaluates the flow of a solved problem: the double layer, Stokeslets and rotlets by a plain sum,
// with near corrections (06.17); pressure, vorticity and strain as in (07.4).
#include "stress/solved_flow.hpp"

#include <utility>

#include "double_layer/stresslet_sum.hpp"
#include "near_singular/near_correction.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

ComplexVector direct_velocity(const SolvedFlow& flow, const ComplexVector& targets) {
  return StressletSum(curves_of(flow.problem()))(targets, flow.density()) +
         flow.closure().singular_velocity(flow.completion().loads, targets);
}

std::vector<FlowDerivatives> direct_derivatives(const SolvedFlow& flow,
                                                const ComplexVector& targets) {
  const StokesProblem& problem = flow.problem();
  require(!problem.cell, "a direct sum has no images of a periodic cell");
  std::vector<FlowDerivatives> sum =
      StressletSum(curves_of(problem)).derivatives(targets, flow.density());
  const double mu = problem.viscosity;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    const Load& load = flow.completion().loads[k];
    const bool has_load = load.force != Complex{} || load.torque != 0.0;
    // The load of an enclosing wall has no singularity: it is due to the wall's double layer.
    if (!has_load || !is_inner(component)) continue;
    for (Index i = 0; i < targets.size(); ++i) {
      const Complex r = targets[i] - component.centre;
      FlowDerivatives& at = sum[static_cast<std::size_t>(i)];
      at += stokeslet_derivatives(r, load.force, mu);
      at += rotlet_derivatives(r, load.torque, mu);
    }
  }
  return sum;
}

}  // namespace

FlowSum direct_sum() {
  return {direct_velocity, direct_derivatives};
}

SolvedFlow::SolvedFlow(const StokesProblem& problem, std::vector<PlacedCurve> placed,
                       const ComplexVector& density, FlowSettings settings)
    : problem_(problem),
      placed_(std::move(placed)),
      closure_(problem),
      density_(closure_.without_rigid_part(density)),
      completion_(closure_.complete(density)),
      settings_(std::move(settings)) {}

ComplexVector SolvedFlow::velocity(const ComplexVector& targets) const {
  ComplexVector velocity =
      settings_.sum.velocity(*this, targets).array() + closure_.uniform_velocity(completion_);
  if (!placed_.empty()) {
    velocity +=
        NearCorrection(placed_, targets, Targets::points,
                       {settings_.tolerance, NearStorage::factored}, images(targets))(density_);
  }
  return velocity;
}

std::vector<FlowDerivatives> SolvedFlow::derivatives(const ComplexVector& targets) const {
  require(placed_.size() == problem_.components.size(),
          "derivatives require a Cauchy scheme for every component: got ", placed_.size(),
          " schemes for ", problem_.components.size(), " components");
  std::vector<FlowDerivatives> flow = settings_.sum.derivatives(*this, targets);
  const std::vector<FlowDerivatives> corrections =
      near_derivative_corrections(placed_, density_, targets, settings_.tolerance, images(targets));
  for (std::size_t i = 0; i < flow.size(); ++i) flow[i] += corrections[i];
  return flow;
}

std::vector<Complex> SolvedFlow::images(const ComplexVector& targets) const {
  return settings_.sum.images ? settings_.sum.images(*this, targets) : std::vector<Complex>{};
}

ComplexVector SolvedFlow::nodes() const {
  return all_nodes(curves_of(problem_));
}

std::vector<PlacedCurve> cauchy_curves(const StokesProblem& problem) {
  std::vector<PlacedCurve> placed;
  for (const Component& component : problem.components) {
    // The frame's origin is the component's centre, because find_near_targets() searches in a
    // circle about this origin.
    Curve local = component.curve;
    local.x.array() -= component.centre;
    placed.push_back({std::make_shared<const CauchyCurve>(local), component.centre, 0.0});
  }
  return placed;
}

}  // namespace stokesbook
