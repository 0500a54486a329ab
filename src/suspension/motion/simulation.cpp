// Moves a scene in time, and passes frames, steps and checkpoints on (chapter 12).
#include "suspension/motion/simulation.hpp"

#include <algorithm>
#include <utility>

#include "suspension/bodies/configuration.hpp"
#include "suspension/motion/contact_steps.hpp"
#include "suspension/motion/free_steps.hpp"
#include "suspension/solver/fields.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

Frame make_frame(double t, const Scene& scene, const Solution& solution) {
  const Configuration& configuration = solution.instant.configuration;
  const std::vector<RigidMotion> motions = path_motions(solution);
  Frame frame{t, {}, {}};
  if (const auto& cell = solution.instant.cell) {
    frame.cell = FrameCell{lattice_of(*cell), cell_centre(scene), {}};
  }
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Complex position = solution.instant.path_position(k);
    const double orientation = configuration[k].orientation;
    const auto [velocity, omega] = motions[k];
    const auto [force, torque] = solution.loads[k];
    if (k < scene.bodies.size()) {
      frame.bodies.push_back({position, orientation, velocity, omega, force, torque});
      if (!frame.cell) continue;
      BodyState& image = frame.cell->bodies.emplace_back(frame.bodies.back());
      image.position = configuration[k].position;
      image.velocity = solution.motions[k].velocity;
    } else {
      frame.walls.push_back({position, orientation, force, torque});
    }
  }
  return frame;
}

}  // namespace

Simulation::Simulation(const SuspensionSolver& solver, Observer observer, LoadFunction loads)
    : solver_(solver),
      observer_(std::move(observer)),
      schedule_(solver.scene()),
      instants_(solver, schedule_, statistics_, std::move(loads)),
      state_{.now = {0.0, initial_state(solver), {}}, .solves = instants_.memory()} {
  const Eigen::Index entries = state_.now.state.size();
  statistics_.errors.setZero(entries);
  statistics_.bound = stepping_settings(solver, entries).bound;
  const std::optional<TimeSettings>& time = solver.scene().time;
  require(!time || is_embedded(time->method) || time->dt,
          "time.dt is required: the method of the scene does not choose its first step");
  if (solver.scene().contact) {
    state_.closer.emplace();
    steps_ = std::make_unique<ContactSteps>(solver, schedule_, instants_, statistics_);
  } else {
    steps_ = std::make_unique<FreeSteps>(solver, schedule_, instants_, statistics_);
  }
}

void Simulation::resume(const Checkpoint& checkpoint) {
  std::tie(state_, statistics_) = from_checkpoint(checkpoint, state_, statistics_);
  instants_.memory() = state_.solves;
}

void Simulation::continue_from(const Checkpoint& checkpoint) {
  auto [reached, statistics] = from_checkpoint(checkpoint, state_, statistics_);
  statistics_ = std::move(statistics);
  state_.now = std::move(reached.now);
  state_.last_written = reached.last_written;
  state_.closer = steps_->admit_start(state_.now);
}

// [run]
void Simulation::run() {
  TimedSolution flow = solve_flow();
  while (true) {
    StepStart start = steps_->begin(state_, std::move(flow));  // with contact forces from here on
    if (schedule_.is_written(time())) write(start);
    if (time() >= schedule_.t_final()) return;
    TakenStep taken = steps_->advance(state_, std::move(start));
    write_within(taken.step);
    flow = accept(std::move(taken));
  }
}
// [run]

void Simulation::solve_once() {
  write(steps_->begin(state_, solve_flow()));
}

// Solves for the flow where the run is: at its start, after a resume, or after a restart.
TimedSolution Simulation::solve_flow() {
  const Configuration configuration = configuration_of(solver_, state_.now.state);
  if (statistics_.totals.steps == 0) state_.closer = steps_->admit_start(state_.now);
  TimedSolution flow = instants_.solve({time(), time()}, configuration);
  state_.solves = std::move(flow.before);
  return flow;
}

// Moves the run to the end of a step, and returns the flow there.
TimedSolution Simulation::accept(TakenStep taken) {
  state_.now = std::move(taken.step.end);
  state_.steps = std::move(taken.memory);
  state_.solves = std::move(taken.end.before);
  state_.closer = std::move(taken.closer);
  const StepInfo info = statistics_.add_step(taken.info, taken.error);
  if (observer_.step) observer_.step(info);
  if (observer_.warning && !taken.warning.empty()) observer_.warning(taken.warning);
  adapt_to_effort(info);
  if (!schedule_.is_event(time())) return std::move(taken.end);
  restart();
  return solve_flow();
}

// Prepares for a forcing that continues neither rates nor densities: where all forcing changes its
// sign, bodies retrace their paths.
void Simulation::restart() {
  state_.steps.previous.reset();
  SolveMemory& memory = instants_.memory();
  for (DensityHistory* history : {&memory.densities, &memory.stage_deviations}) {
    if (schedule_.is_reversal(time())) {
      history->reverse(time());
    } else {
      history->clear();
    }
  }
  memory.contact_velocities = {};
}

// Doubles or halves the steps of a fixed method by the iterations that a step took.
void Simulation::adapt_to_effort(const StepInfo& step) {
  const TimeSettings& time = *solver_.scene().time;
  StepMemory& memory = state_.steps;
  if (!time.effort || memory.reduced) return;
  const SteppingSettings settings = stepping_settings(solver_, state_.now.state.size());
  double dt = memory.dt.value_or(*time.dt);
  if (step.gmres_iterations < time.effort->few) dt = std::min(2.0 * dt, settings.dt_max);
  if (step.gmres_iterations > time.effort->many) dt = std::max(0.5 * dt, settings.dt_min);
  memory.dt = dt;
}

void Simulation::write(const StepStart& start) {
  write(state_.now, start.solution(),
        start.contact ? start.contact->outcome.forces : std::vector<ContactForce>{});
}

// Writes the frames between the ends of a step. Their solves leave no trace in the next ones.
void Simulation::write_within(const Step& step) {
  const double after = std::max(step.start.t, state_.last_written);
  for (const double t : schedule_.written_within(after, step.end.t)) {
    const VectorXd state = interpolate(step, t);
    TimedSolution frame = instants_.solve({t, step.start.t}, configuration_of(solver_, state));
    instants_.memory() = std::move(frame.before);
    write({t, state, {}}, frame.solution, {});
  }
}

void Simulation::write(const TimePoint& point, const Solution& solution,
                       const std::vector<ContactForce>& contacts) {
  const double t = point.t;
  if (t <= state_.last_written) return;  // written before the run was resumed
  if (observer_.frame) {
    Frame frame = make_frame(t, solver_.scene(), solution);
    frame.contacts = contacts;
    const ComplexVector tracers = tracers_of(solver_, point.state);
    frame.tracers.assign(tracers.begin(), tracers.end());
    if (solver_.scene().output.nodes) frame.nodes = node_values(solver_, solution);
    if (!rheometer_) rheometer_.emplace(solver_);
    frame.rheology = (*rheometer_)(solution, contacts);
    if (solver_.scene().output.fields) {
      EstimatedField found = estimated_field(solver_, solution);
      frame.field = std::move(found.field);
      statistics_.add_field(found);
    }
    observer_.frame(frame);
  }
  state_.last_written = t;
  if (observer_.checkpoint) observer_.checkpoint(checkpoint());
}

}  // namespace stokesbook
