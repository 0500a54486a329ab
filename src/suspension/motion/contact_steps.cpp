// Takes steps with contact: by Euler's method, or by Heun's with contact at both stages (chapter
// 12). The loops around the complementarity problem of one stage stand in contact.cpp; here a stage
// is resolved again until its nodes suffice for the contact forces, and a step is halved until its
// contact is resolved and its error allowed.
#include "suspension/motion/contact_steps.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "suspension/bodies/components.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/motion/statistics.hpp"
#include "suspension/motion/stepping.hpp"
#include "suspension/system/error_estimate.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

// The error of a step grows with the square of its length, except where contact begins or ends and
// velocities jump: such a step is taken after two shorter attempts, whatever its error.
constexpr int most_rejections_at_a_jump = 2;

// Ratio of a step to the step before it, if that was halved.
constexpr double recovery = 1.5;

// A step whose contact requires more linear complementarity problems is halved.
constexpr int most_iterations = 9;

// How often a stage is resolved again, with more nodes or a tighter GMRES tolerance.
constexpr int most_raised = 8;

// After so many steps with the nodes that contact forces required, fewer nodes are tried: contact
// that lasts may not require them any more, and they make each step slower.
constexpr int most_steps_kept = 8;

// Longest path of a component in a step, over the size of the scene.
constexpr double scenes_in_a_step = 10.0;

// Displacement of the fastest boundary in step_for_an_instant(), over the separation.
constexpr double separations_in_an_instant = 0.01;

// Least length of that step, over the planned one.
constexpr double least_step_of_an_instant = 1e-6;

std::string unresolved_error(double t, const ContactOutcome& outcome) {
  return at_time(t) + "contact is not resolved: " + outcome.result.reason;
}

bool is_resolved(const ContactOutcome& outcome) {
  return outcome.result.status == ContactStatus::resolved;
}

struct FastestComponent {
  std::size_t component = 0;
  double speed = 0.0;  // bound for the speed of its boundary
};

FastestComponent fastest(const Solution& solution) {
  FastestComponent found;
  for (std::size_t k = 0; k < solution.motions.size(); ++k) {
    const auto& [velocity, omega] = solution.motions[k];
    const double radius = outer_radius(solution.discretisation[k]->curve, 0.0);
    const double speed = std::abs(velocity) + std::abs(omega) * radius;
    if (speed > found.speed) found = {k, speed};
  }
  return found;
}

// Ratio of the next step to this one, by chapter 09's step control. The error, which is given over
// what is allowed, grows with the square of the step. The error of the step before is left out:
// where contact begins or ends, the errors of two steps have nothing to do with each other.
double contact_step_factor(double scaled_error) {
  return step_factor(scaled_error, 1.0, 2);
}

}  // namespace

ContactSteps::ContactSteps(const SuspensionSolver& solver, const OutputSchedule& schedule,
                           InstantSolver& instants, RunStatistics& statistics)
    : solver_(solver),
      schedule_(schedule),
      instants_(instants),
      statistics_(statistics),
      time_(solver.scene().time.value_or(TimeSettings{})),
      settings_(stepping_settings(solver)),
      contact_(solver) {}

CloserPairs ContactSteps::admit_start(const Configuration& start) const {
  return contact_.admit_start(start);
}

void ContactSteps::step_for_an_instant(const Solution& flow) {
  const double speed = fastest(flow).speed;
  settings_.dt = speed > 0.0 ? separations_in_an_instant * contact_.separation() / speed : 1.0;
  settings_.dt_min = least_step_of_an_instant * *settings_.dt;
}

double ContactSteps::planned_dt(const StepMemory& memory) const {
  return memory.dt.value_or(*settings_.dt);
}

// The contact of the last frame is that of a step after the end of the run.
double ContactSteps::planned_end(const RunState& state) const {
  const double t = state.now.t, dt = planned_dt(state.steps);
  return t < schedule_.t_final() ? choose_step_end(t, schedule_.next_event(t), dt) : t + dt;
}

// The search for contact along a path takes the longer, the longer the path: no path is much longer
// than the scene.
double ContactSteps::end_within_scene(const RunState& state, const Solution& flow,
                                      double t_end) const {
  const Configuration& configuration = flow.instant.configuration;
  double size = 0.0;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    size = std::max(size, std::abs(configuration[k].position - configuration[0].position) +
                              outer_radius(flow.discretisation[k]->curve, 0.0));
  }
  const auto [component, speed] = fastest(flow);
  const double t = state.now.t, longest = scenes_in_a_step * size / speed;
  if (!(t_end - t > longest)) return t_end;
  if (longest < settings_.dt_min) {
    throw SolverError(at_time(t) + component_of(solver_.scene(), component).name() + " moves by " +
                      short_number(speed * settings_.dt_min) + " in a step of time.dt_min = " +
                      short_number(settings_.dt_min) + ", and all components lie within " +
                      short_number(size) + ": reduce time.dt_min, the loads or the flow");
  }
  return t + longest;
}

// Contact forces act where the bodies are at the beginning: bodies must not move far past each
// other in a step.
double ContactSteps::end_within_reach(const RunState& state, const Solution& flow,
                                      double t_end) const {
  const double t = state.now.t, dt = t_end - t;
  const double way = contact_.relative_displacement(flow.instant.configuration, to_rate(flow), dt);
  return way > 1.0 ? t + std::max(dt / way, settings_.dt_min) : t_end;
}

double ContactSteps::shortened(double t, double t_end, double factor, const std::string& reason) {
  const double shorter = t + std::max(factor * (t_end - t), settings_.dt_min);
  if (shorter >= t_end) {
    throw SolverError(reason + "; steps down to time.dt_min = " + short_number(settings_.dt_min) +
                      " do not help");
  }
  ++statistics_.totals.rejected_steps;
  return shorter;
}

StepStart ContactSteps::begin(const RunState& state, TimedSolution flow) {
  return begin(state, std::move(flow), planned_end(state));
}

// Halves the step until its first stage is resolved. The cost is that of all attempts.
StepStart ContactSteps::begin(const RunState& state, TimedSolution flow, double t_end) {
  const double t = state.now.t;
  const Configuration here = to_configuration(state.now.state);
  const VectorXd at_rest = VectorXd::Zero(state.now.state.size());
  t_end = end_within_scene(state, flow.solution, t_end);
  if (time_.tolerance) t_end = end_within_reach(state, flow.solution, t_end);
  SolveCost cost;
  double seconds = 0.0;
  while (true) {
    ResolvedStage stage = resolve({t, t_end - t, here, here, 1.0, at_rest, 0, most_iterations},
                                  std::move(flow), *state.closer);
    cost += stage.contact.cost;
    seconds += stage.contact.seconds;
    if (is_resolved(stage.contact.outcome)) {
      stage.contact.cost = cost;
      stage.contact.seconds = seconds;
      statistics_.add_resolution(stage.contact.solution);
      return {std::move(stage.flow), t_end, std::move(stage.contact)};
    }
    flow = std::move(stage.flow);
    ++statistics_.totals.halved_by_contact;
    t_end = shortened(t, t_end, 0.5, unresolved_error(t, stage.contact.outcome));
  }
}

// Resolves the contact of a stage, again and again until nodes and GMRES tolerance suffice for the
// contact forces. Later solves begin with the nodes and the tolerance found here.
ContactSteps::ResolvedStage ContactSteps::resolve(const Stage& stage, TimedSolution flow,
                                                  const CloserPairs& closer) {
  SolveMemory& memory = instants_.memory();
  StageContact found;
  while (true) {
    ContactMobility mobility(solver_, flow.solution, memory.columns, memory.gmres_tolerance);
    const VectorXd free_velocity = stage.known + stage.share * to_rate(flow.solution);
    found.outcome = with_time_in_errors(stage.t, [&] {
      return contact_.resolve({stage.start, free_velocity, stage.dt, stage.acting, stage.share,
                               memory.added[stage.index], stage.most_iterations},
                              mobility, closer);
    });
    statistics_.totals.ncp_iterations += found.outcome.iterations;
    statistics_.totals.contact_seconds += found.outcome.seconds;
    statistics_.add_solves(mobility);
    memory.columns = mobility.columns();
    found.cost += mobility.cost();
    found.seconds += found.outcome.seconds;
    found.solution = {};
    if (is_resolved(found.outcome)) {
      memory.added[stage.index] = (found.outcome.result.velocity - free_velocity) / stage.share;
      found.solution = contact_.with_forces(flow.solution, found.outcome, mobility);
    }
    const LoadedCheck check = this->check(flow, found);
    found.cost.matvecs += check.estimate.matvecs;
    statistics_.totals.matvecs += check.estimate.matvecs;
    found.solution.error_estimate =
        std::max({flow.solution.error_estimate, check.estimate.error, found.outcome.corrected});
    const bool nodes_suffice = check.needed == resolutions_of(flow.solution.discretisation);
    const bool suffices = nodes_suffice && check.gmres_tolerance == memory.gmres_tolerance;
    if (suffices || flow.raised == most_raised) return {std::move(flow), std::move(found)};
    memory.contact_resolutions = check.needed;
    memory.steps_kept = 0;
    memory.gmres_tolerance = check.gmres_tolerance;
    if (!nodes_suffice) {
      const auto begun = std::chrono::steady_clock::now();
      Solution finer = instants_.solve_again(stage.t, flow.solution);
      found.cost += finer.cost;
      finer.cost = flow.solution.cost;
      flow.solution = std::move(finer);
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
      found.seconds += passed.count();
    }
    ++flow.raised;
  }
}

// More nodes are needed where the contact forces are not resolved, or where the error estimate of
// the solution that includes them exceeds the tolerance.
LoadedCheck ContactSteps::check(const TimedSolution& flow, const StageContact& contact) const {
  const double gmres_tolerance = instants_.memory().gmres_tolerance;
  const Resolutions resolutions = resolutions_of(flow.solution.discretisation);
  const auto& unseen = contact.outcome.unseen;
  if (!unseen.empty()) {
    return {{}, refine_pairs(solver_.scene(), resolutions, unseen), gmres_tolerance};
  }
  if (!is_resolved(contact.outcome) || !flow.estimated || contact.outcome.forces.empty()) {
    return {{}, resolutions, gmres_tolerance};
  }
  return solver_.check_loaded(contact.solution, gmres_tolerance);
}

// Heun's method: in the second half of the step the forces act at the state that the first half
// leads to, and the velocity of the step is the mean of both halves.
ContactSteps::SecondStage ContactSteps::second_stage(const RunState& state, const StepStart& start,
                                                     StepInfo& info) {
  const double dt = start.t_end - state.now.t;
  const VectorXd& first = start.contact->outcome.result.velocity;
  const VectorXd predicted = state.now.state + dt * first;
  const Configuration acting = to_configuration(predicted);
  TimedSolution flow = instants_.solve(start.t_end, {acting, state.amplitude}, EstimateWhen::never);
  const int left = most_iterations - start.contact->outcome.result.iterations;
  ResolvedStage stage = resolve(
      {start.t_end, dt, to_configuration(state.now.state), acting, 0.5, 0.5 * first, 1, left},
      std::move(flow), *state.closer);
  info = with_solve(info, stage.flow.solution, stage.flow.seconds);
  info = with_contact(info, stage.contact.outcome, stage.contact.cost, stage.contact.seconds);
  if (!is_resolved(stage.contact.outcome)) {
    ++statistics_.totals.halved_by_contact;
    throw ConfigurationError(unresolved_error(start.t_end, stage.contact.outcome));
  }
  const Configuration end =
      to_configuration(state.now.state + dt * stage.contact.outcome.result.velocity);
  const double distance = largest_distance(stage.flow.solution.discretisation, acting, end);
  return {std::move(stage.contact.outcome), to_state(end) - predicted,
          distance / (settings_.bound.tolerance * settings_.bound.scale[0])};
}

TakenStep ContactSteps::advance(const RunState& state, StepStart start) {
  StepInfo spent = begun_step(start.flow.solution, start.flow.seconds);
  spent.velocity_error = start.contact->solution.error_estimate;
  int rejected = 0, rejected_at_a_jump = 0;
  while (true) {
    const StageContact& first = *start.contact;
    StepInfo info = with_contact(spent, first.outcome, first.cost, first.seconds);
    double factor = 0.5;
    std::string reason;
    try {
      std::optional<SecondStage> second;
      if (time_.method == SteppingMethod::heun) second = second_stage(state, start, info);
      const bool too_long = time_.tolerance && second->scaled_error > 1.0;
      const bool jumps = too_long && pairs_in_contact(first.outcome.forces) !=
                                         pairs_in_contact(second->outcome.forces);
      if (!too_long || (jumps && rejected_at_a_jump == most_rejections_at_a_jump)) {
        return finish(state, start, second ? &*second : nullptr, info, rejected > 0);
      }
      rejected_at_a_jump += jumps ? 1 : 0;
      factor = contact_step_factor(second->scaled_error);
      reason = at_time(state.now.t) + "the error of a step is " +
               short_number(second->scaled_error) + " times that which time.tolerance allows";
    } catch (const ConfigurationError& error) {
      reason = error.what();
    }
    ++rejected;
    spent = with_costs_of(spent, info);
    const double t_end = shortened(state.now.t, start.t_end, factor, reason);
    start = begin(state, std::move(start.flow), t_end);
  }
}

// Moves the components to the end of the step and solves for the flow there.
TakenStep ContactSteps::finish(const RunState& state, const StepStart& start,
                               const SecondStage* second, StepInfo info, bool rejected) {
  const ContactOutcome& outcome = second != nullptr ? second->outcome : start.contact->outcome;
  info.t = start.t_end;
  info.dt = start.t_end - state.now.t;
  const VectorXd end = state.now.state + info.dt * outcome.result.velocity;
  const Configuration configuration = to_configuration(end);
  const std::string pairs = contact_.too_close(configuration, *state.closer);
  if (!pairs.empty()) {
    throw ConfigurationError(at_time(start.t_end) +
                             "a step leads to gaps below contact.minimum_separation: " + pairs);
  }
  relax_contact(info.contacts > 0);
  const EstimateWhen estimate =
      schedule_.is_written(start.t_end) ? EstimateWhen::always : EstimateWhen::when_due;
  TimedSolution last = instants_.solve(start.t_end, {configuration, state.amplitude}, estimate);
  const double duration = second != nullptr ? 0.5 * info.dt : info.dt;
  info = with_forces(info, start.contact->outcome, duration);
  if (second != nullptr) info = with_forces(info, outcome, duration);
  StepMemory memory = state.steps;
  if (!time_.effort) memory.dt = next_dt(state, start, second, rejected);
  // By Euler's method: the flow's velocity changes from the beginning to the end of the step; the
  // velocity that contact adds is assumed to stay.
  VectorXd error =
      second != nullptr
          ? second->error
          : VectorXd(0.5 * info.dt * (to_rate(last.solution) - to_rate(start.flow.solution)));
  return {{state.now, {start.t_end, end, {}}},
          std::move(memory),
          std::move(last),
          contact_.widened(*state.closer, configuration),
          info,
          std::move(error)};
}

// Without a tolerance, a step length for which contact failed is likely to fail again: the next
// step has the shortened length, and later ones recover the planned length.
double ContactSteps::next_dt(const RunState& state, const StepStart& start,
                             const SecondStage* second, bool rejected) const {
  const double dt = start.t_end - state.now.t, planned = planned_dt(state.steps);
  if (!time_.tolerance) {
    const bool was_shortened = start.t_end < planned_end(state);
    const double next = was_shortened ? dt : std::min(recovery * planned, *settings_.dt);
    return std::max(next, settings_.dt_min);
  }
  const double factor = contact_step_factor(second->scaled_error);
  double next = dt * (rejected ? std::min(1.0, factor) : factor);
  // A step that an event has cut short does not make the next ones shorter.
  if (factor >= 1.0 && !rejected) next = std::max(next, planned);
  return std::clamp(next, settings_.dt_min, settings_.dt_max);
}

// Gives back the nodes, columns and GMRES tolerance that contact required, when contact is over or
// has lasted. This precedes the solve at the end of a step, since a resumed run begins with it.
void ContactSteps::relax_contact(bool in_contact) {
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
