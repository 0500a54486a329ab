#include "suspension/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "record/number_text.hpp"
#include "suspension/fields.hpp"
#include "suspension/refusal.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// +1, or -1 after an odd number of reversals.
double drive_at(const std::vector<double>& reverse_at, double t) {
  const auto passed =
      std::upper_bound(reverse_at.begin(), reverse_at.end(), t) - reverse_at.begin();
  return passed % 2 == 0 ? 1.0 : -1.0;
}

VectorXd to_rate(const Solution& solution) {
  Configuration rate;
  for (const RigidMotion& motion : solution.motions)
    rate.push_back({motion.velocity, motion.omega});
  return to_state(rate);
}

Frame make_frame(double t, std::size_t bodies, const Configuration& configuration,
                 const Solution& solution) {
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

}  // namespace

VectorXd to_state(const Configuration& configuration) {
  VectorXd state(3 * static_cast<Index>(configuration.size()));
  for (Index k = 0; k < state.size() / 3; ++k) {
    const auto [position, orientation] = configuration[static_cast<std::size_t>(k)];
    state.segment<3>(3 * k) << position.real(), position.imag(), orientation;
  }
  return state;
}

Configuration to_configuration(const VectorXd& state) {
  Configuration configuration;
  for (Index k = 0; k < state.size(); k += 3) {
    configuration.push_back({{state[k], state[k + 1]}, state[k + 2]});
  }
  return configuration;
}

Simulation::Simulation(const SuspensionSolver& solver, Observer observer)
    : solver_(solver),
      time_(solver.scene().time.value_or(TimeSettings{})),
      observer_(std::move(observer)),
      state_(to_state(solver.initial_configuration())) {}

void Simulation::resume(const Checkpoint& checkpoint) {
  t_ = checkpoint.t;
  totals_.steps = checkpoint.step;
  state_ = checkpoint.state;
  previous_.reset();
  if (const auto rate = checkpoint.history.find("rate"); rate != checkpoint.history.end()) {
    previous_ = PreviousStep{checkpoint.history.at("dt")[0], rate->second};
  }
  written_ = true;
}

Checkpoint Simulation::checkpoint() const {
  Checkpoint checkpoint{t_, totals_.steps, state_, {}};
  if (previous_) {
    checkpoint.history["rate"] = previous_->rate;
    checkpoint.history["dt"] = VectorXd::Constant(1, previous_->dt);
  }
  return checkpoint;
}

void Simulation::run() {
  const std::vector<double>& reverse_at = solver_.scene().reverse_at;
  while (true) {
    drive_ = drive_at(reverse_at, t_);
    step_ = {};
    const Solution now = solve(state_);
    if (!written_ && is_written_time()) write(now);
    written_ = false;
    if (t_ >= time_.t_final) return;
    // A rate from before a reversal says nothing about what comes after.
    if (std::binary_search(reverse_at.begin(), reverse_at.end(), t_)) previous_.reset();
    advance(now);
  }
}

void Simulation::solve_once() {
  write(solve(state_));
}

Solution Simulation::solve(const VectorXd& state, const Solution* first_of_step) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const Configuration configuration = to_configuration(state);
    Solution solution = first_of_step == nullptr
                            ? solver_.solve(configuration, drive_)
                            : solver_.solve_nearby(configuration, *first_of_step, drive_);
    const double gap = solution.gaps.empty() ? std::numeric_limits<double>::infinity()
                                             : solution.gaps.front().points.gap;
    if (first_of_step == nullptr) {
      step_.error_estimate = solution.error_estimate;
      note_resolution(solution);
    }
    step_.min_gap = first_of_step == nullptr ? gap : std::min(step_.min_gap, gap);
    step_.gmres_iterations += solution.cost.gmres_iterations;
    step_.matvecs += solution.cost.matvecs;
    step_.residual = std::max(step_.residual, solution.gmres.residual);
    step_.seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++totals_.solves;
    totals_.gmres_iterations += solution.cost.gmres_iterations;
    totals_.matvecs += solution.cost.matvecs;
    return solution;
  } catch (const NumericsRefused& refusal) {
    throw NumericsRefused("t = " + short_number(t_, 6) + ": " + refusal.what());
  }
}

void Simulation::note_resolution(const Solution& solution) {
  std::vector<int> nodes;
  for (const Resolution& resolution : resolutions_of(solution.references)) {
    nodes.push_back(resolution.n_nodes);
  }
  if (resolution_.first_nodes.empty()) resolution_.first_nodes = resolution_.most_nodes = nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    resolution_.most_nodes[k] = std::max(resolution_.most_nodes[k], nodes[k]);
  }
  resolution_.error_estimate = std::max(resolution_.error_estimate, solution.error_estimate);
}

void Simulation::write(const Solution& now) {
  if (observer_.frame) {
    const Configuration configuration = to_configuration(state_);
    Frame frame = make_frame(t_, solver_.scene().bodies.size(), configuration, now);
    if (!rheometer_) rheometer_.emplace(solver_);
    frame.rheology = (*rheometer_)(configuration, now, drive_);
    if (solver_.scene().output.fields) {
      frame.field = evaluate_field(solver_, configuration, now, drive_);
    }
    observer_.frame(frame);
  }
  if (observer_.checkpoint) observer_.checkpoint(checkpoint());
}

bool Simulation::is_written_time() const {
  const std::optional<double> dt_write = solver_.scene().output.dt_write;
  if (!dt_write || t_ >= time_.t_final) return true;
  return t_ == std::round(t_ / *dt_write) * *dt_write;
}

double Simulation::next_event() const {
  double event = time_.t_final;
  if (const std::optional<double> dt_write = solver_.scene().output.dt_write) {
    double k = std::floor(t_ / *dt_write);
    while (k * *dt_write <= t_) k += 1.0;
    event = std::min(event, k * *dt_write);
  }
  const std::vector<double>& reverse_at = solver_.scene().reverse_at;
  const auto reversal = std::upper_bound(reverse_at.begin(), reverse_at.end(), t_);
  return reversal == reverse_at.end() ? event : std::min(event, *reversal);
}

void Simulation::advance(const Solution& now) {
  const double event = next_event();
  const double steps = std::max(1.0, std::ceil((event - t_) / time_.dt - 1e-9));
  const double dt = (event - t_) / steps;
  const VectorXd rate = to_rate(now);
  const Rate f = [&](double, const VectorXd& state) { return to_rate(solve(state, &now)); };
  if (time_.method == SteppingMethod::euler) {
    state_ = euler_step(state_, dt, rate);
  } else if (time_.method == SteppingMethod::adams_bashforth2 && previous_) {
    state_ = adams_bashforth2_step(state_, dt, rate, *previous_);
  } else {
    state_ = runge_kutta4_step(f, t_, state_, dt, rate);
  }
  previous_.reset();
  if (time_.method == SteppingMethod::adams_bashforth2) previous_ = PreviousStep{dt, rate};
  t_ = steps > 1.0 ? t_ + dt : event;
  ++totals_.steps;
  step_.t = t_;
  step_.dt = dt;
  if (observer_.step) observer_.step(step_);
}

}  // namespace stokesbook
