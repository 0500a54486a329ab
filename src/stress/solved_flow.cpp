#include "stress/solved_flow.hpp"

#include <stdexcept>
#include <utility>

#include "double_layer/stresslet_sum.hpp"
#include "near_singular/near_correction.hpp"
#include "near_singular/near_derivatives.hpp"

namespace stokesbook {

using Eigen::Index;

SolvedFlow::SolvedFlow(const StokesProblem& problem, std::vector<PlacedCurve> placed,
                       const ComplexVector& density, double tolerance)
    : problem_(problem),
      placed_(std::move(placed)),
      closure_(problem),
      density_(closure_.without_rigid_part(density)),
      completion_(closure_.complete(density)),
      tolerance_(tolerance) {}

ComplexVector SolvedFlow::velocity(const ComplexVector& targets) const {
  ComplexVector velocity = StressletSum(curves_of(problem_))(targets, density_) +
                           closure_.singular_velocity(completion_, targets);
  if (!placed_.empty()) {
    velocity += NearCorrection(placed_, targets, Targets::points,
                               {tolerance_, NearStorage::factored})(density_);
  }
  return velocity;
}

std::vector<FlowDerivatives> SolvedFlow::derivatives(const ComplexVector& targets) const {
  if (placed_.size() != problem_.components.size()) {
    throw std::invalid_argument("derivatives want the Cauchy scheme of every component");
  }
  std::vector<FlowDerivatives> flow =
      double_layer_derivatives(placed_, density_, targets, tolerance_);
  const double mu = problem_.viscosity;
  for (std::size_t k = 0; k < problem_.components.size(); ++k) {
    const Component& component = problem_.components[k];
    const Load& load = completion_.loads[k];
    const bool has_load = load.force != Complex{} || load.torque != 0.0;
    // The layer of an enclosing wall holds the wall's load.
    if (!has_load || component.kind == ComponentKind::enclosing_wall) continue;
    for (Index i = 0; i < targets.size(); ++i) {
      const Complex r = targets[i] - component.centre;
      FlowDerivatives& at = flow[static_cast<std::size_t>(i)];
      at += stokeslet_derivatives(r, load.force, mu);
      at += rotlet_derivatives(r, load.torque, mu);
    }
  }
  return flow;
}

ComplexVector SolvedFlow::nodes() const {
  return all_nodes(curves_of(problem_));
}

ComplexVector SolvedFlow::boundary_velocity() const {
  ComplexVector velocity(density_.size());
  Index first = 0;
  for (std::size_t k = 0; k < problem_.components.size(); ++k) {
    const Component& component = problem_.components[k];
    const Index n = component.curve.size();
    velocity.segment(first, n) =
        component.kind == ComponentKind::free_body
            ? RigidModes(component.curve, component.centre).at_nodes(completion_.motions[k])
            : component.velocity;
    first += n;
  }
  return velocity;
}

std::vector<PlacedCurve> cauchy_curves(const StokesProblem& problem) {
  std::vector<PlacedCurve> placed;
  for (const Component& component : problem.components) {
    // About its centre: reaches are measured from the frame's origin.
    Curve local = component.curve;
    local.x.array() -= component.centre;
    placed.push_back({std::make_shared<const CauchyCurve>(local), component.centre, 0.0});
  }
  return placed;
}

}  // namespace stokesbook
