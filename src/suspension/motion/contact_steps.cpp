// Takes steps with contact: by Euler's method, or by Heun's with contact at both stages (chapter
// 12). A step is halved until its contact is resolved, and shortened until its error is allowed;
// contact.cpp lists the loops within.
#include "suspension/motion/contact_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "suspension/bodies/components.hpp"
#include "suspension/bodies/configuration.hpp"
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

// A step is far shorter than time.dt if it is at most this part of it.
constexpr double far_shorter = 0.1;

// Longest path of a component in a step, over the size of the scene.
constexpr double scenes_in_a_step = 10.0;

// The step of a scene without [time]: the displacement of the fastest boundary over the separation,
// and the least length over the planned one.
constexpr double separations_in_an_instant = 0.01, least_part_of_an_instant = 1e-6;

std::string unresolved_error(double t, const ContactOutcome& outcome) {
  return at_time(t) + "contact is not resolved: " + outcome.result.reason;
}

struct FastestComponent {
  std::size_t component = 0;
  double speed = 0.0;  // bound for the speed of its boundary
};

FastestComponent fastest_component(const Solution& solution) {
  FastestComponent found;
  for (std::size_t k = 0; k < solution.motions.size(); ++k) {
    const auto& [velocity, omega] = solution.motions[k];
    const double radius = outer_radius(solution.discretisation[k]->curve, 0.0);
    const double speed = std::abs(velocity) + std::abs(omega) * radius;
    if (speed > found.speed) found = {k, speed};
  }
  return found;
}

// The search for contact along a path takes the longer, the longer the path: no path is much longer
// than the scene.
double end_within_scene(const Scene& scene, const Solution& flow, double t, double t_end,
                        double dt_min) {
  const Configuration& configuration = flow.instant.configuration;
  double size = 0.0;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    size = std::max(size, std::abs(configuration[k].position - configuration[0].position) +
                              outer_radius(flow.discretisation[k]->curve, 0.0));
  }
  const auto [component, speed] = fastest_component(flow);
  const double longest = scenes_in_a_step * size / speed;
  if (!(t_end - t > longest)) return t_end;
  if (longest < dt_min) {
    throw SolverError(at_time(t) + component_of(scene, component).name() + " moves by " +
                      short_number(speed * dt_min) + " in a step of time.dt_min = " +
                      short_number(dt_min) + ", and all components lie within " +
                      short_number(size) + ": reduce time.dt_min, the loads or the flow");
  }
  return t + longest;
}

// Measures the largest distance between the positions of a node in two configurations.
double largest_distance(const Discretisation& discretisation, const Configuration& p,
                        const Configuration& q) {
  double largest = 0.0;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    // c + e^{i theta} X for the nodes X in the frame of the shape.
    const auto at = [&](const Pose& pose) {
      return (pose.position +
              std::polar(1.0, pose.orientation) * discretisation[k]->curve.x.array())
          .eval();
    };
    largest = std::max(largest, (at(p[k]) - at(q[k])).abs().maxCoeff());
  }
  return largest;
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
      settings_(stepping_settings(solver, statistics.errors.size())),
      contact_(solver),
      stages_(solver, contact_, instants, statistics) {}

std::optional<CloserGaps> ContactSteps::admit_start(const TimePoint& start) const {
  return contact_.admit_start(placement(start.t, configuration_of(solver_, start.state)));
}

Placement ContactSteps::placement(double t, const Configuration& paths) const {
  return {paths, lattice_at(solver_.scene(), t)};
}

StepStart ContactSteps::begin(const RunState& state, TimedSolution flow) {
  if (!solver_.scene().time) {
    const double speed = fastest_component(flow.solution).speed;
    settings_.dt = speed > 0.0 ? separations_in_an_instant * solver_.separation() / speed : 1.0;
    settings_.dt_min = least_part_of_an_instant * *settings_.dt;
  }
  return begin(state, std::move(flow), planned_end(state));
}

// The contact of the last frame is that of a step after the end of the run.
double ContactSteps::planned_end(const RunState& state) const {
  const double t = state.now.t, dt = state.steps.dt.value_or(*settings_.dt);
  return t < schedule_.t_final() ? choose_step_end(t, schedule_.next_event(t), dt) : t + dt;
}

// Halves the step until its first stage is resolved.
StepStart ContactSteps::begin(const RunState& state, TimedSolution flow, double t_end) {
  const double t = state.now.t;
  const Placement here = placement(t, configuration_of(solver_, state.now.state));
  t_end = end_within_scene(solver_.scene(), flow.solution, t, t_end, settings_.dt_min);
  if (time_.tolerance) {
    // Contact forces act where the bodies are at the beginning: bodies must not move far past each
    // other in a step.
    const double dt = t_end - t;
    const double reach = contact_.relative_displacement(here, to_rate(flow.solution), dt,
                                                        lattice_at(solver_.scene(), t_end));
    if (reach > 1.0) t_end = t + std::max(dt / reach, settings_.dt_min);
  }
  const VectorXd at_rest = VectorXd::Zero(3 * std::ssize(here.paths));
  StageSolution stage{std::move(flow)};
  while (true) {
    const ContactStage problem{.t = t,
                               .dt = t_end - t,
                               .start = here,
                               .acting = here,
                               .end_lattice = lattice_at(solver_.scene(), t_end),
                               .share = 1.0,
                               .known_velocity = at_rest,
                               .closer = *state.closer,
                               .most_iterations = most_iterations};
    stage = stages_.resolve(problem, std::move(stage));
    const ContactOutcome& outcome = stage.contact.outcome;
    if (outcome.is_resolved()) break;
    ++statistics_.totals.halved_by_contact;
    t_end = shorten(t, t_end, 0.5, unresolved_error(t, outcome));
  }
  statistics_.add_resolution(stage.contact.solution);
  return {std::move(stage.flow), t_end, std::move(stage.contact)};
}

double ContactSteps::shorten(double t, double t_end, double factor, const std::string& reason) {
  const double shorter = t + std::max(factor * (t_end - t), settings_.dt_min);
  if (shorter >= t_end) {
    throw SolverError(reason + "; steps down to time.dt_min = " + short_number(settings_.dt_min) +
                      " do not help");
  }
  ++statistics_.totals.rejected_steps;
  limit_ = reason;
  return shorter;
}

// Takes steps that become shorter until contact is resolved and the error allowed.
TakenStep ContactSteps::advance(const RunState& state, StepStart start) {
  StepInfo spent = begin_step(start.flow.solution, start.flow.seconds);
  spent.velocity_error = start.contact->solution.error_estimate;
  int rejected = 0, rejected_at_a_jump = 0;
  while (true) {
    const StageContact& first = *start.contact;
    StepInfo info = with_contact(spent, first.outcome, first.cost, first.seconds);
    double factor = 0.5;
    std::string reason;
    try {
      std::optional<SecondStage> second;
      if (settings_.method == SteppingMethod::heun) {
        second = second_stage(state, start, info);
        info = second->info;
        if (!second->outcome.is_resolved()) {
          ++statistics_.totals.halved_by_contact;
          throw ConfigurationError(unresolved_error(start.t_end, second->outcome));
        }
      }
      const bool too_long = time_.tolerance && second->scaled_error > 1.0;
      const bool jumps = too_long && pairs_in_contact(first.outcome.forces) !=
                                         pairs_in_contact(second->outcome.forces);
      if (!too_long || (jumps && rejected_at_a_jump == most_rejections_at_a_jump)) {
        return finish(state, start, second, info, rejected > 0);
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
    const double t_end = shorten(state.now.t, start.t_end, factor, reason);
    start = begin(state, std::move(start.flow), t_end);
  }
}

// Heun's method: in the second half of the step the forces act at the state that the first half
// leads to, and the velocity of the step is the mean of both halves.
ContactSteps::SecondStage ContactSteps::second_stage(const RunState& state, const StepStart& start,
                                                     const StepInfo& info) {
  const double dt = start.t_end - state.now.t;
  const ContactResult& first = start.contact->outcome.result;
  const VectorXd first_rate =
      with_tracers(solver_, first.velocity, start.contact->solution, state.now.state);
  const VectorXd predicted = state.now.state + dt * first_rate;
  const Placement acting =
      placement(start.t_end, admitted_configuration(solver_, start.t_end, predicted));
  const ContactStage problem{
      .t = start.t_end,
      .dt = dt,
      .start = placement(state.now.t, configuration_of(solver_, state.now.state)),
      .acting = acting,
      .end_lattice = acting.lattice,
      .share = 0.5,
      .known_velocity = 0.5 * first.velocity,
      .closer = *state.closer,
      .most_iterations = most_iterations - first.iterations};
  StageSolution stage = stages_.resolve(
      problem,
      {instants_.solve_stage({start.t_end, state.now.t}, acting.paths, start.flow.solution.tree)});
  auto& [outcome, solution, cost, seconds] = stage.contact;
  const VectorXd& velocity = outcome.result.velocity;  // the mean of both stages
  VectorXd rate = first_rate;
  if (outcome.is_resolved()) {
    rate = 0.5 * (first_rate + with_tracers(solver_, velocity, solution, predicted));
  }
  rate.head(velocity.size()) = velocity;
  const VectorXd end = state.now.state + dt * rate;
  const double distance = largest_distance(stage.flow.solution.discretisation, acting.paths,
                                           configuration_of(solver_, end));
  return {with_contact(with_solve(info, stage.flow.solution, stage.flow.seconds), outcome, cost,
                       seconds),
          std::move(outcome), std::move(rate), end - predicted,
          distance / (settings_.bound.tolerance * settings_.bound.scale[0])};
}

// Moves the components to the end of the step and solves for the flow there.
TakenStep ContactSteps::finish(const RunState& state, const StepStart& start,
                               const std::optional<SecondStage>& second, StepInfo info,
                               bool rejected) {
  const ContactOutcome& first = start.contact->outcome;
  const ContactOutcome& last = second ? second->outcome : first;
  info.t = start.t_end;
  info.dt = start.t_end - state.now.t;
  const VectorXd rate = second ? second->rate
                               : with_tracers(solver_, first.result.velocity,
                                              start.contact->solution, state.now.state);
  const VectorXd end = state.now.state + info.dt * rate;
  const Placement there = placement(start.t_end, admitted_configuration(solver_, start.t_end, end));
  const std::string pairs = contact_.too_close(there, *state.closer);
  if (!pairs.empty()) {
    throw ConfigurationError(at_time(start.t_end) +
                             "a step leads to gaps below contact.minimum_separation: " + pairs);
  }
  stages_.relax(info.contacts > 0);
  TimedSolution flow = instants_.solve({start.t_end, state.now.t}, there.paths);
  const double duration = second ? 0.5 * info.dt : info.dt;
  info = with_forces(info, first, duration);
  if (second) info = with_forces(info, last, duration);
  StepMemory memory = state.steps;
  if (!time_.effort) memory.dt = next_dt(state, start, second, rejected);
  // By Euler's method: the flow's velocity changes from the beginning to the end of the step; the
  // velocity that contact adds is assumed to stay.
  VectorXd error = second ? second->error
                          : VectorXd(0.5 * info.dt *
                                     (state_rate(solver_, flow.solution, end) -
                                      state_rate(solver_, start.flow.solution, state.now.state)));
  std::string warning = this->warning(memory);
  return {{state.now, {start.t_end, end, {}}},
          std::move(memory),
          std::move(flow),
          contact_.update_closer(*state.closer, there),
          info,
          std::move(error),
          std::move(warning)};
}

// Warns once, of steps that are far shorter than time.dt because longer ones have failed.
std::string ContactSteps::warning(const StepMemory& memory) {
  const bool is_far_shorter =
      !time_.tolerance && memory.dt.value_or(*settings_.dt) <= far_shorter * *settings_.dt;
  if (!is_far_shorter || limit_.empty() || std::exchange(has_warned_, true)) return {};
  return limit_ + "; steps of time.dt = " + short_number(*settings_.dt) + " are cut to " +
         short_number(*memory.dt);
}

// Without a tolerance, a step length for which contact failed is likely to fail again: the next
// step has the shortened length, and later ones recover the planned length.
double ContactSteps::next_dt(const RunState& state, const StepStart& start,
                             const std::optional<SecondStage>& second, bool rejected) const {
  const double dt = start.t_end - state.now.t, planned = state.steps.dt.value_or(*settings_.dt);
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

}  // namespace stokesbook
