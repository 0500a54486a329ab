// Steps of a simulation with contact: by Euler's method, or by Heun's with contact at both stages.
#include <algorithm>
#include <cmath>

#include "record/number_text.hpp"
#include "suspension/simulation.hpp"
#include "suspension/step_counts.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

std::string refusal_of(const ContactOutcome& outcome) {
  return "contact is not resolved: " + outcome.result.reason;
}

}  // namespace

double Simulation::planned_end() const {
  // At the end there is no step to come: what would hold then.
  if (now_.t >= time_.t_final) return now_.t + time_.dt.value_or(1.0);
  return evened_end(now_.t, next_event(), *time_.dt);
}

ContactOutcome Simulation::resolve(const ContactStage& stage, LoadResponse& response) {
  ContactOutcome outcome = contact_->resolve(stage, response, closer_);
  const ContactResult& result = outcome.result;
  const bool resolved = result.status == ContactStatus::resolved;
  totals_.ncp_iterations += result.iterations;
  totals_.contact_seconds += outcome.seconds;
  totals_.halved_by_contact += resolved ? 0 : 1;
  if (!resolved) return outcome;
  totals_.largest_force_imbalance =
      std::max(totals_.largest_force_imbalance, outcome.force_imbalance);
  totals_.largest_torque_imbalance =
      std::max(totals_.largest_torque_imbalance, outcome.torque_imbalance);
  totals_.energy_injected += stage.share * stage.dt * std::max(0.0, result.power);
  return outcome;
}

// Contact depends on the step that is to be taken: one that cannot be resolved is halved.
Simulation::Begun Simulation::begin_in_contact(const Solved& first, double t_end) {
  const Configuration configuration = to_configuration(now_.state);
  LoadResponse response(solver_, configuration, first.solution.references);
  while (true) {
    ContactOutcome outcome = resolve(
        {configuration, to_rate(first.solution), t_end - now_.t, configuration, 1.0}, response);
    if (outcome.result.status == ContactStatus::resolved) {
      totals_.contact_solves += response.solves();
      Solution solution = contact_->with_forces(first.solution, outcome, response);
      return {t_end, std::move(outcome), std::move(solution), response.cost()};
    }
    t_end = halved(t_end, refusal_of(outcome));
  }
}

double Simulation::halved(double t_end, const std::string& reason) {
  const double dt = t_end - now_.t;
  if (dt <= stepping_.dt_min) {
    throw NumericsRefused("t = " + short_number(now_.t, 6) + ": " + reason +
                          "; steps down to time.dt_min = " + short_number(stepping_.dt_min) +
                          " do not help");
  }
  ++totals_.rejected_steps;
  return now_.t + std::max(0.5 * dt, stepping_.dt_min);
}

// The mean velocity of a step by Heun's method: in its second half forces act at the state that its
// first half leads to.
ContactOutcome Simulation::corrected(const Begun& begun, StepInfo& info) {
  const double dt = begun.t_end - now_.t;
  const VectorXd& first = begun.outcome.result.velocity;
  const VectorXd predicted = now_.state + dt * first;
  const Solved stage = solve(begun.t_end, predicted, Role::stage);
  info = with_solve(info, stage.solution, stage.seconds);
  const Configuration start = to_configuration(now_.state), acting = to_configuration(predicted);
  LoadResponse response(solver_, acting, stage.solution.references);
  ContactOutcome outcome =
      resolve({start, 0.5 * (first + to_rate(stage.solution)), dt, acting, 0.5}, response);
  totals_.contact_solves += response.solves();
  info = with_contact(info, outcome, response.cost());
  if (outcome.result.status == ContactStatus::resolved) return outcome;
  throw ConfigurationRefused(refusal_of(outcome));
}

Simulation::Solved Simulation::advance_in_contact(const Solved& first, Begun begun) {
  StepInfo info = begun_step(first.solution, first.seconds);
  while (true) {
    info = with_contact(info, begun.outcome, begun.cost);
    try {
      const VectorXd velocity = stepping_.method == Method::heun
                                    ? corrected(begun, info).result.velocity
                                    : begun.outcome.result.velocity;
      info.dt = begun.t_end - now_.t;
      const VectorXd state = now_.state + info.dt * velocity;
      const Configuration configuration = to_configuration(state);
      if (!contact_->admits(configuration, closer_)) {
        throw ConfigurationRefused("a step leads to gaps below contact.minimum_separation");
      }
      Solved last = solve(begun.t_end, state, Role::step);
      info.t = begun.t_end;
      now_ = {begun.t_end, state, {}};
      closer_ = contact_->widened(closer_, configuration);
      ++totals_.steps;
      if (observer_.step) observer_.step(info);
      return is_reversal(now_.t) ? reverse() : std::move(last);
    } catch (const ConfigurationRefused& refusal) {
      begun = begin_in_contact(first, halved(begun.t_end, refusal.what()));
    }
  }
}

}  // namespace stokesbook
