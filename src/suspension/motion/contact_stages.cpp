// Resolves the contact of the stages of a step until the nodes suffice for the contact forces
// (chapter 12). The loops around and within stand in contact.cpp.
#include "suspension/motion/contact_stages.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "suspension/motion/stepping.hpp"
#include "suspension/nodes/node_choice.hpp"

namespace stokesbook {

namespace {

// How often a stage is resolved again, with more nodes or a tighter GMRES tolerance.
constexpr int most_refinements = 8;

// After so many steps with the nodes that contact forces required, fewer nodes are tried: contact
// that lasts may not require them any more, and they make each step slower.
constexpr int most_steps_kept = 8;

}  // namespace

StageSolution ContactStages::resolve(const ContactStage& problem, StageSolution stage) {
  SolveMemory& memory = instants_.memory();
  const double tolerance = solver_.scene().solver.tolerance;
  auto& [flow, contact] = stage;
  while (true) {
    StageContact found = find_forces(problem, flow.solution);
    found.cost += contact.cost;
    found.seconds += contact.seconds;
    contact = std::move(found);
    const bool is_estimated = is_estimate_due(stage);
    const LoadedCheck check =
        is_estimated ? solver_.check_loaded(contact.solution, memory.gmres_tolerance)
                     : LoadedCheck{{}, needed_resolutions(stage), memory.gmres_tolerance};
    const auto& [error, matvecs, density] = check.estimate;
    contact.cost.matvecs += matvecs;
    statistics_.totals.matvecs += matvecs;
    const bool is_only_estimate = is_estimated && flow.estimate == EstimateOf::solution_in_contact;
    if (is_only_estimate) memory.error_estimate = flow.solution.error_estimate = error;
    contact.solution.error_estimate =
        std::max({flow.solution.error_estimate, error, contact.outcome.correction});
    const bool nodes_suffice = check.needed == resolutions_of(flow.solution.discretisation);
    const bool suffices = nodes_suffice && check.gmres_tolerance == memory.gmres_tolerance;
    const bool is_inaccurate = is_only_estimate && suffices && !(error <= tolerance);
    if ((suffices && !is_inaccurate) || flow.refinements == most_refinements) return stage;
    ++flow.refinements;
    memory.contact_resolutions = check.needed;
    memory.steps_kept = 0;
    memory.gmres_tolerance = check.gmres_tolerance;
    if (nodes_suffice && !is_inaccurate) continue;
    // No effort makes the contact forces accurate. The flow without them must be accurate.
    if (is_inaccurate) flow.estimate = EstimateOf::solution;
    const auto begin = std::chrono::steady_clock::now();
    Solution finer = instants_.solve_again(problem.t, flow);
    contact.cost += std::exchange(finer.cost, flow.solution.cost);
    flow.solution = std::move(finer);
    contact.seconds += seconds_since(begin);
  }
}

// Resolves the contact of a stage once, from the columns and the velocities of the step before.
StageContact ContactStages::find_forces(ContactStage problem, const Solution& flow) {
  const auto begin = std::chrono::steady_clock::now();
  SolveMemory& memory = instants_.memory();
  ContactMobility mobility(solver_, flow, memory.columns, memory.gmres_tolerance, problem.t);
  problem.free_velocity = problem.known_velocity + problem.share * to_rate(flow);
  Eigen::VectorXd& latest = memory.contact_velocities[problem.share < 1.0 ? 1 : 0];  // by stage
  problem.guess = latest;
  StageContact found;
  found.outcome =
      with_time_in_errors(problem.t, [&] { return contact_.resolve(problem, mobility); });
  found.cost = mobility.cost();
  memory.columns = mobility.columns();
  if (found.outcome.is_resolved()) {
    latest = (found.outcome.result.velocity - problem.free_velocity) / problem.share;
    found.solution = mobility.loaded_solution(found.outcome.result.multipliers);
  }
  found.seconds = seconds_since(begin);
  statistics_.add_contact(found.outcome, mobility, found.seconds);
  return found;
}

// The error of the solution with contact forces is estimated where that of the flow alone is, or
// where it replaces that of the flow.
bool ContactStages::is_estimate_due(const StageSolution& stage) {
  const auto& [flow, contact] = stage;
  const ContactOutcome& outcome = contact.outcome;
  if (!outcome.is_resolved() || !outcome.unresolved.empty()) return false;
  return flow.estimate == EstimateOf::solution_in_contact ||
         (flow.estimate == EstimateOf::solution && !outcome.forces.empty());
}

// More nodes are needed where they do not resolve the contact forces.
Resolutions ContactStages::needed_resolutions(const StageSolution& stage) const {
  const Resolutions resolutions = resolutions_of(stage.flow.solution.discretisation);
  const auto& unresolved = stage.contact.outcome.unresolved;
  return unresolved.empty() ? resolutions : refine_pairs(solver_.scene(), resolutions, unresolved);
}

void ContactStages::relax(bool in_contact) {
  SolveMemory& memory = instants_.memory();
  if (!in_contact) {
    memory.contact_resolutions.clear();
    memory.columns = {};
    memory.gmres_tolerance = solver_.plan().gmres_tolerance;
  } else if (++memory.steps_kept == most_steps_kept) {
    memory.contact_resolutions = coarsen(std::move(memory.contact_resolutions));
    memory.steps_kept = 0;
  }
}

}  // namespace stokesbook
