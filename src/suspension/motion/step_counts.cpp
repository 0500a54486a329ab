// Counts what a step has done, for its row in steps.csv.
#include "suspension/motion/step_counts.hpp"

#include <algorithm>
#include <limits>

namespace stokesbook {

StepInfo begun_step(const Solution& first, double seconds) {
  const StepInfo none{.min_gap = std::numeric_limits<double>::infinity(),
                      .velocity_error = first.error_estimate};
  return with_solve(none, first, seconds);
}

StepInfo with_solve(StepInfo step, const Solution& solution, double seconds) {
  const double gap = solution.gaps.empty() ? std::numeric_limits<double>::infinity()
                                           : solution.gaps.front().points.gap;
  step.min_gap = std::min(step.min_gap, gap);
  step.gmres_iterations += solution.cost.gmres_iterations;
  step.matvecs += solution.cost.matvecs;
  step.residual = std::max(step.residual, solution.gmres.residual);
  step.seconds += seconds;
  return step;
}

StepInfo with_contact(StepInfo step, const ContactOutcome& outcome, const SolveCost& cost,
                      double seconds) {
  step.gmres_iterations += cost.gmres_iterations;
  step.matvecs += cost.matvecs;
  step.ncp_iterations += outcome.result.iterations;
  step.contacts =
      std::max(step.contacts, static_cast<int>(pairs_in_contact(outcome.forces).size()));
  step.seconds += seconds;
  return step;
}

StepInfo with_costs_of(StepInfo step, const StepInfo& rejected) {
  step.gmres_iterations = rejected.gmres_iterations;
  step.matvecs = rejected.matvecs;
  step.residual = rejected.residual;
  step.seconds = rejected.seconds;
  return step;
}

StepInfo with_forces(StepInfo step, const ContactOutcome& outcome, double duration) {
  step.kkt_residual = std::max(step.kkt_residual, outcome.kkt_residual);
  step.force_imbalance = std::max(step.force_imbalance, outcome.force_imbalance);
  step.torque_imbalance = std::max(step.torque_imbalance, outcome.torque_imbalance);
  step.contact_power = outcome.result.power;
  step.energy_injected += duration * std::max(0.0, outcome.result.power);
  return step;
}

std::set<std::pair<ContactParty, ContactParty>> pairs_in_contact(
    const std::vector<ContactForce>& forces) {
  std::set<std::pair<ContactParty, ContactParty>> pairs;
  for (const ContactForce& force : forces) pairs.emplace(force.a, force.b);
  return pairs;
}

}  // namespace stokesbook
