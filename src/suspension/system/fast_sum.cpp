// Evaluates the double layer of a problem and the Stokeslets and rotlets of its loads (03.4) by the
// fast multipole method (chapter 08).
#include "suspension/system/fast_sum.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace stokesbook {

using Eigen::Index;

namespace {

// Returns the components that may have a load: prescribed ones, and free bodies with a given load.
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
    : FastSum(problem, Fmm(curves_of(problem), centres(problem, loaded_components(problem)),
                           FmmSettings::for_tolerance(tolerance))) {}

FastSum::FastSum(const StokesProblem& problem, const ComplexVector& targets, double tolerance)
    : FastSum(problem, Fmm(curves_of(problem), centres(problem, loaded_components(problem)),
                           targets, FmmSettings::for_tolerance(tolerance))) {}

FastSum::FastSum(const StokesProblem& problem, Fmm fmm)
    : loaded_(loaded_components(problem)),
      viscosity_(problem.viscosity),
      fmm_(std::move(fmm)),
      workspace_(fmm_.workspace()) {
  const std::vector<double> gauges = stokeslet_gauges(problem);
  for (const std::size_t k : loaded_) log_gauges_.push_back(std::log(gauges[k]));
}

FastSum::Singularities FastSum::singularities(const std::vector<Load>& loads) const {
  const auto count = static_cast<Index>(loaded_.size());
  Singularities all{ComplexVector(count), Eigen::VectorXd(count), {}};
  // Stokeslets of gauge length l add the uniform velocity log(l) F / (4 pi mu).
  for (Index i = 0; i < count; ++i) {
    const Load& load = loads[loaded_[static_cast<std::size_t>(i)]];
    all.force[i] = load.force / viscosity_;
    all.torque[i] = load.torque / viscosity_;
    all.uniform += log_gauges_[static_cast<std::size_t>(i)] * all.force[i];
  }
  all.uniform *= 0.25 * std::numbers::inv_pi;
  // In the operator of a mobility problem all loads are zero: the vectors stay empty, and the
  // multipole method has no singularities to sum.
  if (all.force.isZero(0.0) && all.torque.isZero(0.0)) return {};
  return all;
}

ComplexVector FastSum::velocity(const ComplexVector& density,
                                const std::vector<Load>& loads) const {
  const Singularities points = singularities(loads);
  return fmm_.velocity({density, points.force, points.torque}, workspace_).col(0).array() +
         points.uniform;
}

std::vector<FlowDerivatives> FastSum::derivatives(const ComplexVector& density,
                                                  const std::vector<Load>& loads) const {
  const Singularities points = singularities(loads);
  return fmm_.derivatives({density, points.force, points.torque}, workspace_);
}

FlowSum planned_sum(const Plan& plan) {
  const auto is_fast = [=](const SolvedFlow& flow, const ComplexVector& targets) {
    return plan.is_fast(flow.density().size(), targets.size());
  };
  const double tolerance = plan.sum_tolerance;
  return {[=](const SolvedFlow& flow, const ComplexVector& targets) {
            if (!is_fast(flow, targets)) return direct_sum().velocity(flow, targets);
            return FastSum(flow.problem(), targets, tolerance)
                .velocity(flow.density(), flow.completion().loads);
          },
          [=](const SolvedFlow& flow, const ComplexVector& targets) {
            if (!is_fast(flow, targets)) return direct_sum().derivatives(flow, targets);
            return FastSum(flow.problem(), targets, tolerance)
                .derivatives(flow.density(), flow.completion().loads);
          }};
}

}  // namespace stokesbook
