// Adds up what steps and runs cost, how finely they are resolved and how wrong they may be, for
// steps.csv and run.json.
#include "suspension/motion/statistics.hpp"

#include <algorithm>
#include <limits>

namespace stokesbook {

namespace {

// Adds the work of a solve to the counts of a step or of a run.
void add_cost(auto& counts, const SolveCost& cost) {
  counts.gmres_iterations += cost.gmres_iterations;
  counts.matvecs += cost.matvecs;
}

}  // namespace

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void RunStatistics::add_solve(const Solution& solution) {
  ++totals.solves;
  add_cost(totals, solution.cost);
}

void RunStatistics::add_contact(const ContactOutcome& outcome, const ContactMobility& mobility,
                                double seconds) {
  totals.ncp_iterations += outcome.iterations;
  totals.contact_seconds += seconds;
  totals.contact_solves += mobility.solves();
  add_cost(totals, mobility.cost());
}

void RunStatistics::add_field(const EstimatedField& field) {
  totals.solves += field.solves;
  add_cost(totals, field.cost);
  for (const auto& [quantity, error] : field.errors) {
    double& largest = resolution.field_errors[quantity];
    largest = std::max(largest, error);
  }
}

void RunStatistics::add_resolution(const Solution& solution) {
  std::vector<int> nodes;
  for (const Resolution& component : resolutions_of(solution.discretisation)) {
    nodes.push_back(component.n_nodes);
  }
  if (resolution.first_nodes.empty()) resolution.first_nodes = resolution.most_nodes = nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    resolution.most_nodes[k] = std::max(resolution.most_nodes[k], nodes[k]);
  }
  resolution.velocity_error = std::max(resolution.velocity_error, solution.error_estimate);
}

StepInfo RunStatistics::add_step(StepInfo step, const Eigen::VectorXd& error) {
  step.step_error = bound.in_units_of_scale(error);
  errors += error;
  resolution.configuration_error = bound.in_units_of_scale(errors);
  ++totals.steps;
  totals.largest_force_imbalance = std::max(totals.largest_force_imbalance, step.force_imbalance);
  totals.largest_torque_imbalance =
      std::max(totals.largest_torque_imbalance, step.torque_imbalance);
  totals.energy_injected += step.energy_injected;
  return step;
}

StepInfo begin_step(const Solution& first, double seconds) {
  const StepInfo none{.min_gap = std::numeric_limits<double>::infinity(),
                      .velocity_error = first.error_estimate};
  return with_solve(none, first, seconds);
}

StepInfo with_solve(StepInfo step, const Solution& solution, double seconds) {
  const double gap = solution.gaps.empty() ? std::numeric_limits<double>::infinity()
                                           : solution.gaps.front().points.gap;
  step.min_gap = std::min(step.min_gap, gap);
  add_cost(step, solution.cost);
  step.residual = std::max(step.residual, solution.gmres.residual);
  step.seconds += seconds;
  return step;
}

StepInfo with_contact(StepInfo step, const ContactOutcome& outcome, const SolveCost& cost,
                      double seconds) {
  add_cost(step, cost);
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
  step.force_imbalance = std::max(step.force_imbalance, outcome.imbalance.force);
  step.torque_imbalance = std::max(step.torque_imbalance, outcome.imbalance.torque);
  step.contact_power = outcome.result.power;
  step.energy_injected += duration * std::max(0.0, outcome.result.power);
  return step;
}

std::set<std::tuple<ContactParty, ContactParty, LatticeIndex>> pairs_in_contact(
    const std::vector<ContactForce>& forces) {
  std::set<std::tuple<ContactParty, ContactParty, LatticeIndex>> pairs;
  for (const ContactForce& force : forces) pairs.emplace(force.a, force.b, force.image);
  return pairs;
}

}  // namespace stokesbook
