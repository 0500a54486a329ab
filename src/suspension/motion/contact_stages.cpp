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
  auto& [flow, contact] = stage;
  while (true) {
    StageContact found = find_forces(problem, flow.solution);
    found.cost += contact.cost;
    found.seconds += contact.seconds;
    contact = std::move(found);
    const LoadedCheck check = check_effort(stage);
    contact.cost.matvecs += check.estimate.matvecs;
    statistics_.totals.matvecs += check.estimate.matvecs;
    contact.solution.error_estimate =
        std::max({flow.solution.error_estimate, check.estimate.error, contact.outcome.correction});
    const bool nodes_suffice = check.needed == resolutions_of(flow.solution.discretisation);
    const bool suffices = nodes_suffice && check.gmres_tolerance == memory.gmres_tolerance;
    if (suffices || flow.refinements == most_refinements) return stage;
    ++flow.refinements;
    memory.contact_resolutions = check.needed;
    memory.steps_kept = 0;
    memory.gmres_tolerance = check.gmres_tolerance;
    if (nodes_suffice) continue;
    const auto begin = std::chrono::steady_clock::now();
    Solution finer = instants_.solve_again(problem.t, flow.solution);
    contact.cost += std::exchange(finer.cost, flow.solution.cost);
    flow.solution = std::move(finer);
    contact.seconds += seconds_since(begin);
  }
}

// Resolves the contact of a stage once, from the columns and the velocities of the step before.
StageContact ContactStages::find_forces(ContactStage problem, const Solution& flow) {
  const auto begin = std::chrono::steady_clock::now();
  SolveMemory& memory = instants_.memory();
  ContactMobility mobility(solver_, flow, memory.columns, memory.gmres_tolerance);
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

// More nodes are needed where the contact forces are not resolved, or where the error estimate of
// the solution that includes them exceeds the tolerance.
LoadedCheck ContactStages::check_effort(const StageSolution& stage) const {
  const auto& [flow, contact] = stage;
  const double gmres_tolerance = instants_.memory().gmres_tolerance;
  const Resolutions resolutions = resolutions_of(flow.solution.discretisation);
  const auto& unresolved = contact.outcome.unresolved;
  if (!unresolved.empty()) {
    return {{}, refine_pairs(solver_.scene(), resolutions, unresolved), gmres_tolerance};
  }
  if (!contact.outcome.is_resolved() || !flow.estimated || contact.outcome.forces.empty()) {
    return {{}, resolutions, gmres_tolerance};
  }
  return solver_.check_loaded(contact.solution, gmres_tolerance);
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
