// Steps of a simulation with contact: by Euler's method, or by Heun's with contact at both stages
// and, where a tolerance is given, steps adapted to the error.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "record/number_text.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/state.hpp"
#include "suspension/motion/simulation.hpp"
#include "suspension/motion/step_counts.hpp"
#include "suspension/nodes/node_choice.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

// The error of a step grows with the square of its length, but not where contact begins or ends and
// velocities jump: such steps are taken after two shorter tries, whatever their error.
constexpr int most_rejections_at_a_jump = 2;

// By how much a step may be longer than one that was halved before it.
constexpr double recovery = 1.5;

// Linear problems of contact that a step may take: one that needs more is halved.
constexpr int most_iterations = 9;

// How often a stage is solved again on more nodes for the forces of contact.
constexpr int most_raised = 8;

// After so many steps on the nodes that contact asked for, fewer are tried: what lasts need not ask
// for them any more, and each step on them takes its time.
constexpr int most_kept = 8;

// The longest path in a step, in units of the distance that holds all components.
constexpr double scenes_in_a_step = 10.0;

// What a solve without a step of its own moves the fastest boundary by.
constexpr double separations_in_an_instant = 0.01;

std::string refusal_of(double t, const ContactOutcome& outcome) {
  return at_time(t) + "contact is not resolved: " + outcome.result.reason;
}

struct FastestComponent {
  std::size_t component = 0;
  double speed = 0.0;  // of its boundary, at most
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

// By how much a step is to be longer, for an error in units of what is allowed.
double contact_step_factor(double error) {
  return std::clamp(0.9 / std::sqrt(std::max(error, 1e-12)), 0.3, 1.5);
}

}  // namespace

// So short that only gaps as narrow as the separation close: all others stay open.
double Simulation::instant(const Solution& solution) const {
  const double speed = fastest(solution).speed;
  return speed > 0.0 ? separations_in_an_instant * contact_->separation() / speed : 1.0;
}

double Simulation::planned_dt() const {
  return memory_.dt.value_or(*time_.dt);
}

double Simulation::planned_end() const {
  // At the end there is no step to come: what would hold then.
  if (now_.t >= time_.t_final) return now_.t + planned_dt();
  return evened_end(now_.t, next_event(), planned_dt());
}

void Simulation::note_response(const LoadResponse& response) {
  totals_.contact_solves += response.solves();
  totals_.gmres_iterations += response.cost().gmres_iterations;
  totals_.matvecs += response.cost().matvecs;
  latest_.contacts = response.answered();
}

ContactOutcome Simulation::resolve(const ContactStage& stage, LoadResponse& response) {
  ContactOutcome outcome = contact_->resolve(stage, response, closer_);
  totals_.ncp_iterations += outcome.iterations;
  totals_.contact_seconds += outcome.seconds;
  return outcome;
}

// Contact of a stage, on as many nodes as its forces ask for.
Simulation::InContact Simulation::in_contact(const Stage& stage, Solved free) {
  InContact found{std::move(free), {}, {}, {}};
  while (true) {
    const Solution& flow = found.free.solution;
    LoadResponse response(solver_, flow, latest_.contacts, latest_.gmres_tolerance);
    const VectorXd free_velocity = stage.known + stage.share * to_rate(flow);
    found.outcome = dated(stage.t, [&] {
      return resolve({stage.start, free_velocity, stage.dt, stage.acting, stage.share,
                      latest_.added[stage.index], stage.most_iterations},
                     response);
    });
    note_response(response);
    found.cost += response.cost();
    found.seconds += found.outcome.seconds;
    found.solution = {};
    if (found.outcome.result.status == ContactStatus::resolved) {
      latest_.added[stage.index] = (found.outcome.result.velocity - free_velocity) / stage.share;
      found.solution = contact_->with_forces(flow, found.outcome, response);
    }
    const LoadedCheck check = this->check(found);
    found.cost.matvecs += check.estimate.matvecs;
    totals_.matvecs += check.estimate.matvecs;
    found.solution.error_estimate =
        std::max({flow.error_estimate, check.estimate.error, found.outcome.corrected});
    const bool nodes_do = check.needed == resolutions_of(flow.discretisation);
    const bool enough = nodes_do && check.gmres_tolerance == latest_.gmres_tolerance;
    if (enough || found.free.raised == most_raised) return found;
    latest_.in_contact = check.needed;
    latest_.kept = 0;
    latest_.gmres_tolerance = check.gmres_tolerance;
    if (!nodes_do) put_on_more_nodes(stage, found);
    ++found.free.raised;
  }
}

// Nodes do not where forces of contact are not seen, nor where the estimate of a solution with them
// exceeds the tolerance.
LoadedCheck Simulation::check(const InContact& found) const {
  const double gmres_tolerance = latest_.gmres_tolerance;
  const Resolutions resolutions = resolutions_of(found.free.solution.discretisation);
  const auto& unseen = found.outcome.unseen;
  if (!unseen.empty()) {
    return {{}, finer_in_pairs(solver_.scene(), resolutions, unseen), gmres_tolerance};
  }
  const bool resolved = found.outcome.result.status == ContactStatus::resolved;
  if (!resolved || !found.free.estimated || found.outcome.forces.empty()) {
    return {{}, resolutions, gmres_tolerance};
  }
  return solver_.check_loaded(found.solution, gmres_tolerance);
}

// Solves for the flow of a stage again, on as many nodes as contact asks for.
void Simulation::put_on_more_nodes(const Stage& stage, InContact& found) {
  const auto start = std::chrono::steady_clock::now();
  const auto solve_again = [&] {
    return solver_.solve_nearby(found.free.solution.instant, latest_.in_contact,
                                guess(stage.t, stage.acting));
  };
  const Solution before = std::exchange(found.free.solution, dated(stage.t, solve_again));
  Solution& flow = found.free.solution;
  note_solve(flow);
  found.cost += flow.cost;
  flow.cost = before.cost;
  flow.error_estimate = before.error_estimate;
  latest_.densities.add(stage.t, stage.acting, flow.discretisation, flow.density);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  found.seconds += passed.count();
}

// Contact depends on the step that is to be taken: one that cannot be resolved is halved.
Simulation::Begun Simulation::begin_in_contact(Solved first, double t_end) {
  const Configuration configuration = to_configuration(now_.state);
  const VectorXd at_rest = VectorXd::Zero(now_.state.size());
  t_end = end_within_scene(first.solution, t_end);
  if (time_.tolerance) t_end = end_within_reach(configuration, to_rate(first.solution), t_end);
  SolveCost cost;
  double seconds = 0.0;
  while (true) {
    InContact stage = in_contact(
        {now_.t, t_end - now_.t, configuration, configuration, 1.0, at_rest, 0, most_iterations},
        std::move(first));
    cost += stage.cost;
    seconds += stage.seconds;
    if (stage.outcome.result.status == ContactStatus::resolved) {
      stage.cost = cost;
      stage.seconds = seconds;
      note_resolution(stage.solution);
      return {t_end, std::move(stage)};
    }
    first = std::move(stage.free);
    ++totals_.halved_by_contact;
    t_end = shortened(t_end, 0.5, refusal_of(now_.t, stage.outcome));
  }
}

// Paths are searched for contact bit by bit: none is to be longer than the scene by far.
double Simulation::end_within_scene(const Solution& solution, double t_end) const {
  const Configuration configuration = to_configuration(now_.state);
  double size = 0.0;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    size = std::max(size, std::abs(configuration[k].position - configuration[0].position) +
                              outer_radius(solution.discretisation[k]->curve, 0.0));
  }
  const auto [component, speed] = fastest(solution);
  const double dt = t_end - now_.t, longest = scenes_in_a_step * size / speed;
  if (!(dt > longest)) return t_end;
  if (longest < stepping_.dt_min) {
    throw NumericsRefused(at_time(now_.t) + component_of(solver_.scene(), component).name() +
                          " moves by " + short_number(speed * stepping_.dt_min) +
                          " in a step of time.dt_min = " + short_number(stepping_.dt_min) +
                          ", and all components lie within " + short_number(size) +
                          ": give shorter steps, or drive it less");
  }
  return now_.t + longest;
}

// Forces act where they are at the beginning: components must not move far past each other.
double Simulation::end_within_reach(const Configuration& configuration,
                                    const VectorXd& free_velocity, double t_end) const {
  const double dt = t_end - now_.t;
  const double way = contact_->relative_displacement(configuration, free_velocity, dt);
  return way > 1.0 ? now_.t + std::max(dt / way, stepping_.dt_min) : t_end;
}

double Simulation::shortened(double t_end, double factor, const std::string& reason) {
  const double shorter = now_.t + std::max(factor * (t_end - now_.t), stepping_.dt_min);
  if (shorter >= t_end) {
    throw NumericsRefused(reason + "; steps down to time.dt_min = " +
                          short_number(stepping_.dt_min) + " do not help");
  }
  ++totals_.rejected_steps;
  return shorter;
}

// The mean velocity of a step by Heun's method: in its second half forces act at the state that its
// first half leads to.
Simulation::SecondHalf Simulation::second_half(const Begun& begun, StepInfo& info) {
  const double dt = begun.t_end - now_.t;
  const VectorXd& first = begun.stage.outcome.result.velocity;
  const VectorXd predicted = now_.state + dt * first;
  const Configuration start = to_configuration(now_.state), acting = to_configuration(predicted);
  Solved free = solve(begun.t_end, predicted, Role::stage);
  const int left = most_iterations - begun.stage.outcome.result.iterations;
  InContact stage =
      in_contact({begun.t_end, dt, start, acting, 0.5, 0.5 * first, 1, left}, std::move(free));
  info = with_solve(info, stage.free.solution, stage.free.seconds);
  info = with_contact(info, stage.outcome, stage.cost, stage.seconds);
  if (stage.outcome.result.status != ContactStatus::resolved) {
    ++totals_.halved_by_contact;
    throw ConfigurationRefused(refusal_of(begun.t_end, stage.outcome));
  }
  const Configuration end = to_configuration(now_.state + dt * stage.outcome.result.velocity);
  const double distance = largest_distance(stage.free.solution.discretisation, acting, end);
  return {std::move(stage.outcome), to_state(end) - predicted,
          distance / (stepping_.bound.tolerance * stepping_.bound.scale[0])};
}

void Simulation::adapt_to_error(const StepInfo& step, double error, bool rejected) {
  const double factor = contact_step_factor(error);
  double dt = step.dt * (rejected ? std::min(1.0, factor) : factor);
  // A step that was shorter than planned for another reason shortens no others.
  if (factor >= 1.0 && !rejected) dt = std::max(dt, planned_dt());
  memory_.dt = std::clamp(dt, stepping_.dt_min, stepping_.dt_max);
}

// What contact did not resolve now, it will hardly resolve in the next step.
void Simulation::recover_length(double dt, bool shortened) {
  const double next = shortened ? dt : std::min(recovery * planned_dt(), *time_.dt);
  memory_.dt = std::max(next, stepping_.dt_min);
}

Simulation::Solved Simulation::advance_in_contact(Begun begun) {
  StepInfo spent = begun_step(begun.stage.free.solution, begun.stage.free.seconds);
  spent.velocity_error = begun.stage.solution.error_estimate;
  int rejected = 0, rejected_at_a_jump = 0;
  while (true) {
    StepInfo info = with_contact(spent, begun.stage.outcome, begun.stage.cost, begun.stage.seconds);
    try {
      std::optional<SecondHalf> second;
      if (stepping_.method == SteppingMethod::heun) second = second_half(begun, info);
      const ContactOutcome& outcome = second ? second->outcome : begun.stage.outcome;
      const bool too_long = time_.tolerance && second->error_in_bounds > 1.0;
      const bool jumps = too_long && pairs_in_contact(begun.stage.outcome.forces) !=
                                         pairs_in_contact(outcome.forces);
      if (too_long && !(jumps && rejected_at_a_jump == most_rejections_at_a_jump)) {
        rejected_at_a_jump += jumps ? 1 : 0;
        ++rejected;
        spent = with_costs_of(spent, info);
        begun =
            begin_in_contact(std::move(begun.stage.free),
                             shortened(begun.t_end, contact_step_factor(second->error_in_bounds),
                                       at_time(now_.t) + "the error of a step is " +
                                           short_number(second->error_in_bounds) +
                                           " times that which time.tolerance allows"));
        continue;
      }
      info.dt = begun.t_end - now_.t;
      const VectorXd state = now_.state + info.dt * outcome.result.velocity;
      const Configuration configuration = to_configuration(state);
      const std::string pairs = contact_->too_close(configuration, closer_);
      if (!pairs.empty()) {
        throw ConfigurationRefused(
            at_time(begun.t_end) +
            "a step leads to gaps below contact.minimum_separation: " + pairs);
      }
      ask_for_less(info.contacts > 0);
      Solved last = solve(begun.t_end, state, Role::step);
      info.t = begun.t_end;
      const double duration = second ? 0.5 * info.dt : info.dt;
      info = with_forces(info, begun.stage.outcome, duration);
      if (second) info = with_forces(info, outcome, duration);
      if (time_.tolerance) {
        adapt_to_error(info, second->error_in_bounds, rejected > 0);
      } else if (!time_.effort) {
        recover_length(info.dt, begun.t_end < planned_end());
      }
      now_ = {begun.t_end, state, {}};
      closer_ = contact_->widened(closer_, configuration);
      // The flow's velocities change from the beginning to the end; what contact adds is taken to
      // stay as it is.
      const VectorXd error =
          second ? second->error
                 : 0.5 * info.dt * (to_rate(last.solution) - to_rate(begun.stage.free.solution));
      note_step(info, error);
      return is_reversal(now_.t) ? reverse() : std::move(last);
    } catch (const ConfigurationRefused& refusal) {
      ++rejected;
      spent = with_costs_of(spent, info);
      begun = begin_in_contact(std::move(begun.stage.free),
                               shortened(begun.t_end, 0.5, refusal.what()));
    }
  }
}

// Nodes, answers and iterations that contact asked for, when it is over or has lasted. Before the
// solve at the end of a step, since a resume begins with that.
void Simulation::ask_for_less(bool in_contact) {
  if (!in_contact) {
    latest_.in_contact.clear();
    latest_.contacts = {};
    latest_.gmres_tolerance = solver_.plan().gmres_tolerance;
  } else if (++latest_.kept == most_kept) {
    latest_.in_contact = coarser(std::move(latest_.in_contact));
    latest_.kept = 0;
  }
}

}  // namespace stokesbook
