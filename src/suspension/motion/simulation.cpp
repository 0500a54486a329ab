// Moves a scene in time, and tells observers what happens (chapter 12).
#include "suspension/motion/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "record/number_text.hpp"
#include "suspension/bodies/state.hpp"
#include "suspension/motion/step_counts.hpp"
#include "suspension/motion/stepping.hpp"
#include "suspension/solver/fields.hpp"
#include "suspension/solver/refusal.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

// +1, or -1 after an odd number of reversals.
double amplitude_at(const std::vector<double>& reverse_at, double t) {
  const auto passed =
      std::upper_bound(reverse_at.begin(), reverse_at.end(), t) - reverse_at.begin();
  return passed % 2 == 0 ? 1.0 : -1.0;
}

Frame make_frame(double t, std::size_t bodies, const Solution& solution) {
  const Configuration& configuration = solution.instant.configuration;
  Frame frame{t, {}, {}};
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    const auto [velocity, omega] = solution.motions[k];
    const auto [force, torque] = solution.loads[k];
    if (k < bodies) {
      frame.bodies.push_back({position, orientation, velocity, omega, force, torque});
    } else {
      frame.walls.push_back({position, orientation, force, torque});
    }
  }
  return frame;
}

// Lets a stepper know where a shorter step may do.
Rate shorter_where_refused(const Rate& rate) {
  return [=](double t, const VectorXd& state) {
    try {
      return rate(t, state);
    } catch (const ConfigurationRefused& refusal) {
      throw InadmissibleState(refusal.what());
    }
  };
}

// Densities that are a worse start than none: the sweeps of steps before have made them so.
std::string divergence_refusal(const Solution& lagged) {
  if (!(lagged.gmres.residual > 1.0)) return {};
  return "the lagged coupling diverges: the densities of the step before leave a residual of " +
         short_number(lagged.gmres.residual, 3) +
         " times the data. Each step is one sweep, whatever its length: shorter ones do not help, "
         "solver.coupling = \"global\" does";
}

// The polynomial through four: more amplify what GMRES leaves, and stages are not that smooth.
constexpr std::size_t densities_kept = 4;

// In units of it, where contact makes it shorter.
constexpr double least_step_of_an_instant = 1e-6;

// In units of dt_write: a written time as near an event, such as a reversal, is that event, since a
// step between the two would be nothing but rounding.
constexpr double same_time = 1e-9;

// An estimate takes about as long as a solve.
constexpr int solves_per_estimate = 8;

}  // namespace

Simulation::Simulation(const SuspensionSolver& solver, Observer observer)
    : solver_(solver),
      time_(solver.scene().time.value_or(TimeSettings{})),
      stepping_(stepping_settings(solver)),
      observer_(std::move(observer)),
      now_{0.0, to_state(solver.start().configuration), {}},
      latest_{
          DensityHistory(solver.scene().solver.coupling == Coupling::local ? 1 : densities_kept)},
      begun_(latest_),
      errors_(VectorXd::Zero(now_.state.size())) {
  latest_.gmres_tolerance = solver.plan().gmres_tolerance;
  if (solver.scene().contact) {
    contact_.emplace(solver);
  } else {
    passing_.emplace(solver);
  }
}

void Simulation::run() {
  amplitude_ = amplitude_at(solver_.scene().reverse_at, now_.t);
  if (contact_ && totals_.steps == 0) closer_ = contact_->admit_start(to_configuration(now_.state));
  Solved now = solve(now_.t, now_.state, Role::step);
  while (true) {
    begun_ = now.before;
    const bool ends = now_.t >= time_.t_final;
    std::optional<Begun> begun;
    if (contact_) begun = begin_in_contact(std::move(now), planned_end());
    if (is_written_time(now_.t)) {
      begun ? write(now_.t, begun->stage.solution, begun->stage.outcome.forces)
            : write(now_.t, now.solution);
    }
    if (ends) return;
    now = begun ? advance_in_contact(std::move(*begun)) : advance(now);
  }
}

void Simulation::solve_once() {
  Solved now = solve(now_.t, now_.state, Role::step);
  if (!contact_) return write(now_.t, now.solution);
  closer_ = contact_->admit_start(to_configuration(now_.state));
  if (!solver_.scene().time) {
    time_.dt = instant(now.solution);
    stepping_.dt_min = least_step_of_an_instant * *time_.dt;
  }
  const Begun begun = begin_in_contact(std::move(now), planned_end());
  write(now_.t, begun.stage.solution, begun.stage.outcome.forces);
}

Simulation::Solved Simulation::solve(double t, const VectorXd& state, Role role) {
  const auto start = std::chrono::steady_clock::now();
  const bool due = latest_.densities.empty() || latest_.since >= solves_per_estimate;
  const bool estimated = role == Role::frame || (role == Role::step && (due || is_written_time(t)));
  const Instant instant{to_configuration(state), amplitude_};
  SolveMemory before = latest_;
  Solution solution = dated(t, [&] { return solve_by_guess(t, instant, estimated); });
  if (!estimated) solution.error_estimate = latest_.error_estimate;
  latest_.densities.add(t, instant.configuration, solution.discretisation, solution.density);
  if (!contact_) solution.system.reset();  // its memory: nobody asks for it
  latest_.error_estimate = solution.error_estimate;
  latest_.since = estimated ? 0 : latest_.since + 1;
  note_resolution(solution);
  note_solve(solution);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  return {std::move(solution), std::move(before), passed.count(), estimated};
}

DensityGuess Simulation::guess(double t, const Configuration& configuration) const {
  return [this, t, &configuration](const Discretisation& discretisation) {
    return latest_.densities.guess(t, configuration, discretisation);
  };
}

Solution Simulation::solve_by_guess(double t, const Instant& instant, bool estimated) const {
  const DensityHistory& densities = latest_.densities;
  const DensityGuess guess = this->guess(t, instant.configuration);
  const bool local = solver_.scene().solver.coupling == Coupling::local;
  if (local && !densities.empty()) {
    Solution solution = solver_.solve_lagged(instant, guess);
    refuse(divergence_refusal(solution));
    return solution;
  }
  return estimated ? solver_.solve(instant, guess, latest_.in_contact)
                   : solver_.solve_nearby(instant, densities.latest_resolutions(), guess);
}

void Simulation::note_solve(const Solution& solution) {
  ++totals_.solves;
  totals_.gmres_iterations += solution.cost.gmres_iterations;
  totals_.matvecs += solution.cost.matvecs;
}

// Errors keep their signs: those of a closed orbit, or of a way there and back, cancel.
void Simulation::note_step(StepInfo step, const VectorXd& error) {
  step.step_error = stepping_.bound.in_units_of_scale(error);
  errors_ += error;
  resolution_.configuration_error = stepping_.bound.in_units_of_scale(errors_);
  ++totals_.steps;
  totals_.largest_force_imbalance = std::max(totals_.largest_force_imbalance, step.force_imbalance);
  totals_.largest_torque_imbalance =
      std::max(totals_.largest_torque_imbalance, step.torque_imbalance);
  totals_.energy_injected += step.energy_injected;
  if (observer_.step) observer_.step(step);
  adapt_to_effort(step);
}

void Simulation::note_resolution(const Solution& solution) {
  std::vector<int> nodes;
  for (const Resolution& resolution : resolutions_of(solution.discretisation)) {
    nodes.push_back(resolution.n_nodes);
  }
  if (resolution_.first_nodes.empty()) resolution_.first_nodes = resolution_.most_nodes = nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    resolution_.most_nodes[k] = std::max(resolution_.most_nodes[k], nodes[k]);
  }
  resolution_.velocity_error = std::max(resolution_.velocity_error, solution.error_estimate);
}

void Simulation::write(double t, const Solution& solution,
                       const std::vector<ContactForce>& contacts) {
  if (t <= written_) return;  // on record before a resume
  if (observer_.frame) {
    Frame frame = make_frame(t, solver_.scene().bodies.size(), solution);
    frame.contacts = contacts;
    if (!rheometer_) rheometer_.emplace(solver_);
    frame.rheology = (*rheometer_)(solution);
    if (solver_.scene().output.fields) {
      EstimatedField found = estimated_field(solver_, solution);
      frame.field = std::move(found.field);
      note_field(found);
    }
    observer_.frame(frame);
  }
  written_ = t;
  if (observer_.checkpoint) observer_.checkpoint(checkpoint());
}

void Simulation::note_field(const EstimatedField& found) {
  totals_.solves += found.solves;
  totals_.gmres_iterations += found.cost.gmres_iterations;
  totals_.matvecs += found.cost.matvecs;
  for (const auto& [quantity, error] : found.errors) {
    double& largest = resolution_.field_errors[quantity];
    largest = std::max(largest, error);
  }
}

void Simulation::write_within(const Step& step) {
  for (double t = next_written_time(std::max(step.start.t, written_)); t < step.end.t;
       t = next_written_time(t)) {
    const VectorXd state = interpolate(step, t);
    const Solved frame = solve(t, state, Role::frame);
    latest_ = frame.before;
    write(t, frame.solution);
  }
}

bool Simulation::is_written_time(double t) const {
  const std::optional<double> dt_write = solver_.scene().output.dt_write;
  if (!dt_write || t >= time_.t_final) return true;
  // Compared, not subtracted: that might be done with the product before it is rounded.
  const double nearest = std::round(t / *dt_write) * *dt_write;
  const double rounding = rounding_of_written_times();
  return nearest >= t - rounding && nearest <= t + rounding;
}

// Methods that interpolate need no steps to written times.
double Simulation::rounding_of_written_times() const {
  if (has_dense_output(stepping_.method)) return 0.0;
  return same_time * solver_.scene().output.dt_write.value_or(0.0);
}

double Simulation::next_written_time(double t) const {
  const std::optional<double> dt_write = solver_.scene().output.dt_write;
  if (!dt_write) return std::numeric_limits<double>::infinity();
  double k = std::floor(t / *dt_write);
  while (k * *dt_write <= t + rounding_of_written_times()) k += 1.0;
  return k * *dt_write;
}

double Simulation::next_event() const {
  double event = time_.t_final;
  const std::vector<double>& reverse_at = solver_.scene().reverse_at;
  const auto reversal = std::upper_bound(reverse_at.begin(), reverse_at.end(), now_.t);
  if (reversal != reverse_at.end()) event = std::min(event, *reversal);
  if (has_dense_output(stepping_.method)) return event;
  const double written = next_written_time(now_.t);
  return written < event - rounding_of_written_times() ? written : event;
}

Advance Simulation::take_step(const Rates& rates) const {
  const std::string dt_min = "time.dt_min = " + short_number(stepping_.dt_min);
  try {
    return Stepper(stepping_, rates).advance(now_, memory_, next_event());
  } catch (const InadmissibleState& refusal) {
    throw ConfigurationRefused(std::string(refusal.what()) + "; steps down to " + dt_min +
                               " lead there");
  } catch (const StepRefused& refusal) {
    throw NumericsRefused(at_time(now_.t) + refusal.what() +
                          ", and steps are not to be shorter than " + dt_min);
  }
}

Simulation::Solved Simulation::advance(const Solved& first) {
  StepInfo info = begun_step(first.solution, first.seconds);
  const double closest = info.min_gap;
  std::optional<Solved> last;
  const auto within = [&](double t, const VectorXd& state) {
    const Solved stage = solve(t, state, Role::stage);
    info = with_solve(info, stage.solution, stage.seconds);
    return to_rate(stage.solution);
  };
  const auto at_end = [&](double t, const VectorXd& state) {
    if (last) info = with_solve(info, last->solution, last->seconds);  // of a rejected step
    dated(t, [&] {
      const Configuration start = to_configuration(now_.state);
      const std::string passing = passing_->refusal(start, to_configuration(state), closest);
      if (!passing.empty()) throw ConfigurationRefused(passing);
    });
    last = solve(t, state, Role::step);
    return to_rate(last->solution);
  };
  now_.rate = to_rate(first.solution);
  const Advance advance = take_step({shorter_where_refused(within), shorter_where_refused(at_end)});
  write_within(advance.step);
  now_ = advance.step.end;
  memory_ = advance.memory;
  totals_.rejected_steps += advance.rejected;
  info.t = now_.t;
  info.dt = advance.step.dt();
  note_step(info, advance.error);
  return is_reversal(now_.t) ? reverse() : std::move(*last);
}

bool Simulation::is_reversal(double t) const {
  const std::vector<double>& reverse_at = solver_.scene().reverse_at;
  return std::binary_search(reverse_at.begin(), reverse_at.end(), t);
}

Simulation::Solved Simulation::reverse() {
  amplitude_ = amplitude_at(solver_.scene().reverse_at, now_.t);
  memory_.previous.reset();  // an earlier rate says nothing about what comes after
  latest_.densities.reverse(now_.t);
  latest_.added = {};
  return solve(now_.t, now_.state, Role::step);
}

void Simulation::adapt_to_effort(const StepInfo& step) {
  if (!time_.effort || memory_.detour) return;
  double dt = memory_.dt.value_or(*time_.dt);
  if (step.gmres_iterations < time_.effort->few) dt = std::min(2.0 * dt, stepping_.dt_max);
  if (step.gmres_iterations > time_.effort->many) dt = std::max(0.5 * dt, stepping_.dt_min);
  memory_.dt = dt;
}

}  // namespace stokesbook
