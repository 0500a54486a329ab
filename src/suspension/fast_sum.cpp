#include "suspension/fast_sum.hpp"

#include <cmath>
#include <numbers>

namespace stokesbook {

using Eigen::Index;

namespace {

// A free body without a load stays without one.
std::vector<std::size_t> loaded_components(const StokesProblem& problem) {
  std::vector<std::size_t> loaded;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    const bool has_load = component.force != Complex{} || component.torque != 0.0;
    if (component.kind == ComponentKind::prescribed || has_load) loaded.push_back(k);
  }
  return loaded;
}

ComplexVector centres(const StokesProblem& problem, const std::vector<std::size_t>& components) {
  ComplexVector points(static_cast<Index>(components.size()));
  for (std::size_t i = 0; i < components.size(); ++i) {
    points[static_cast<Index>(i)] = problem.components[components[i]].centre;
  }
  return points;
}

}  // namespace

FastSum::FastSum(const StokesProblem& problem, double tolerance)
    : loaded_(loaded_components(problem)),
      viscosity_(problem.viscosity),
      fmm_(curves_of(problem), centres(problem, loaded_), FmmSettings::for_tolerance(tolerance)),
      workspace_(fmm_.workspace()) {
  const std::vector<double> gauges = stokeslet_gauges(problem);
  for (const std::size_t k : loaded_) log_gauges_.push_back(std::log(gauges[k]));
}

ComplexVector FastSum::operator()(const ComplexVector& density,
                                  const std::vector<Load>& loads) const {
  const auto count = static_cast<Index>(loaded_.size());
  ComplexVector force(count);
  Eigen::VectorXd torque(count);
  Complex uniform{};  // what gauges other than 1 add
  for (Index i = 0; i < count; ++i) {
    const Load& load = loads[loaded_[static_cast<std::size_t>(i)]];
    force[i] = load.force / viscosity_;
    torque[i] = load.torque / viscosity_;
    uniform += log_gauges_[static_cast<std::size_t>(i)] * force[i];
  }
  uniform *= 0.25 * std::numbers::inv_pi;
  // A mobility problem's operator has no singularities.
  const bool has_loads = !force.isZero(0.0) || !torque.isZero(0.0);
  const ComplexVector velocity = has_loads ? fmm_.velocity({density, force, torque}, workspace_)
                                           : fmm_.velocity(density, workspace_);
  return velocity.array() + uniform;
}

}  // namespace stokesbook
