// Evaluates the double layer of a problem and the Stokeslets and rotlets of its loads (03.4) by the
// fast multipole method (chapter 08).
#include "suspension/system/fast_sum.hpp"

#include <cmath>
#include <numbers>

#include "periodic/far_operator.hpp"
#include "suspension/bodies/cell.hpp"
#include "trapezoid/rectangle_index.hpp"

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

ComplexVector centres_of(const StokesProblem& problem, const std::vector<std::size_t>& loaded) {
  ComplexVector centres(static_cast<Index>(loaded.size()));
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    centres[static_cast<Index>(i)] = problem.components[loaded[i]].centre;
  }
  return centres;
}

// Returns the near images of a disk that contains the nodes of a flow and its targets.
std::vector<Complex> images_near(const SolvedFlow& flow, const ComplexVector& targets) {
  if (!flow.problem().cell || targets.size() == 0) return {};
  ComplexVector points(flow.density().size() + targets.size());
  points << flow.nodes(), targets;
  const Rectangle rectangle = bounding_rectangle(points);
  return near_images(lattice_of(*flow.problem().cell),
                     0.5 * std::abs(rectangle.upper - rectangle.lower));
}

Fmm make_fmm(const StokesProblem& problem, const ComplexVector& centres,
             const ComplexVector& targets, double tolerance) {
  const FmmSettings settings = FmmSettings::for_tolerance(tolerance);
  FmmImagePlan images;
  if (problem.cell) images = images_in(lattice_of(*problem.cell));
  if (targets.size() == 0) return {curves_of(problem), centres, settings, images};
  return {curves_of(problem), centres, targets, settings, images};
}

}  // namespace

FastSum::FastSum(const StokesProblem& problem, double tolerance, const ComplexVector& targets)
    : loaded_(loaded_components(problem)),
      viscosity_(problem.viscosity),
      centres_(centres_of(problem, loaded_)),
      cell_(problem.cell),
      fmm_(make_fmm(problem, centres_, targets, tolerance)),
      workspace_(fmm_.workspace()) {
  const std::vector<double> gauges = stokeslet_gauges(problem);
  for (const std::size_t k : loaded_) log_gauges_.push_back(std::log(gauges[k]));
}

std::pair<ComplexVector, Eigen::VectorXd> FastSum::strengths(const std::vector<Load>& loads) const {
  const auto count = static_cast<Index>(loaded_.size());
  ComplexVector force(count);
  Eigen::VectorXd torque(count);
  for (Index i = 0; i < count; ++i) {
    const Load& load = loads[loaded_[static_cast<std::size_t>(i)]];
    force[i] = load.force / viscosity_;
    torque[i] = load.torque / viscosity_;
  }
  // In the operator of a mobility problem all loads are zero: the vectors stay empty, and the
  // multipole method has no singularities to sum.
  if (force.isZero(0.0) && torque.isZero(0.0)) return {};
  return {force, torque};
}

ComplexVector FastSum::velocity(const ComplexVector& density,
                                const std::vector<Load>& loads) const {
  const auto [force, torque] = strengths(loads);
  // Stokeslets of gauge length l add the uniform velocity log(l) F / (4 pi mu).
  Complex uniform;
  for (Index i = 0; i < force.size(); ++i) {
    uniform += log_gauges_[static_cast<std::size_t>(i)] * force[i];
  }
  uniform *= 0.25 * std::numbers::inv_pi;
  return fmm_.velocity({density, force, torque}, workspace_).col(0).array() + uniform;
}

std::vector<Complex> FastSum::near_images() const {
  std::vector<Complex> images;
  for (const Interactions& image : fmm_.all_interactions()) images.push_back(image.shift);
  images.erase(images.begin());  // the sources themselves
  return images;
}

std::vector<FlowDerivatives> FastSum::derivatives(const ComplexVector& density,
                                                  const std::vector<Load>& loads) const {
  const auto [force, torque] = strengths(loads);
  std::vector<FlowDerivatives> flow = fmm_.derivatives({density, force, torque}, workspace_);
  if (!cell_) return flow;
  // images_in(): from the pressure that is linear about the centre c of the cell, and its constant,
  // to F.z / V for every force
  double constant = 0.0;
  for (Index i = 0; i < force.size(); ++i) {
    constant += 0.5 / cell_->area() * dot(force[i], centres_[i] + fmm_.cell().centre);
  }
  for (FlowDerivatives& at : flow) at.pressure += constant;
  return flow;
}

FlowSum planned_sum(const Plan& plan) {
  const auto is_fast = [=](const SolvedFlow& flow, const ComplexVector& targets) {
    return (flow.problem().cell && targets.size() > 0) ||
           plan.is_fast(flow.density().size(), targets.size());
  };
  const double tolerance = plan.sum_tolerance;
  return {[=](const SolvedFlow& flow, const ComplexVector& targets) {
            if (!is_fast(flow, targets)) return direct_sum().velocity(flow, targets);
            return FastSum(flow.problem(), tolerance, targets)
                .velocity(flow.density(), flow.completion().loads);
          },
          [=](const SolvedFlow& flow, const ComplexVector& targets) {
            if (!is_fast(flow, targets)) return direct_sum().derivatives(flow, targets);
            return FastSum(flow.problem(), tolerance, targets)
                .derivatives(flow.density(), flow.completion().loads);
          },
          images_near};
}

}  // namespace stokesbook
