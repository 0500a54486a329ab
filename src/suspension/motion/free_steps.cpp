// Takes steps without contact: the rates of chapter 09's stepper are solutions of instants. The
// space-time interference of chapter 10 finds steps that take bodies through each other, with
// polygons that are as coarse as the depth of an overlap allows.
#include "suspension/motion/free_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "suspension/bodies/configuration.hpp"
#include "suspension/contact/path_images.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

// Largest distance of the polygons of PassingTest from their curves, over the smallest radius of
// gyration.
constexpr double sag_of_passing = 1e-3;

// Depth of the deepest overlap that is not found, over this distance.
constexpr double accepted_sags = 10.0;

double smallest_radius(const Discretisation& discretisation) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& discretised : discretisation) {
    smallest = std::min(smallest, discretised->gyration_radius);
  }
  return smallest;
}

// Returns the largest displacement of a point on some of the first paths.
double longest_displacement(const PathImages& images, std::size_t count) {
  double longest = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [start, displacement, rotation] = images.paths[k];
    longest =
        std::max(longest, std::abs(displacement) + std::abs(rotation) * images.shapes[k]->radius);
  }
  return longest;
}

// Marks the states from which a stepper takes a shorter step.
Rate shorter_on_error(const Rate& rate) {
  return [=](double t, const VectorXd& state) {
    try {
      return rate(t, state);
    } catch (const ConfigurationError& error) {
      throw InadmissibleState(error.what());
    }
  };
}

}  // namespace

PassingTest::PassingTest(const SuspensionSolver& solver)
    : solver_(solver),
      sag_(sag_of_passing * smallest_radius(solver.discretisation())),
      shapes_(contact_shapes(solver.discretisation(), sag_)) {}

std::string PassingTest::describe_passing(const Configuration& start, const Configuration& end,
                                          double closest,
                                          const std::optional<LatticeStep>& lattice) const {
  const ContactRules rules{{sag_}, accepted_sags * sag_};
  const VectorXd displacement = to_state(end) - to_state(start);
  const PathImages images =
      path_images(shapes_, straight_paths(start, displacement, 1.0), lattice, sag_);
  // A gap shrinks by at most the sum of the displacements of a component and of another path.
  const double shrunk = longest_displacement(images, images.components) +
                        longest_displacement(images, images.paths.size());
  if (shrunk < closest) return {};
  for (const Contact& contact : interferences(images.shapes, images.paths, rules).contacts) {
    const std::optional<ContactPair> pair = images.pair(contact.a, contact.b);
    if (!pair || !contact.is_violated()) continue;
    return name_contact_pair(solver_.scene(), *pair) +
           " overlap or pass through each other within a step: take smaller steps, or give "
           "[contact]";
  }
  return {};
}

FreeSteps::FreeSteps(const SuspensionSolver& solver, const OutputSchedule& schedule,
                     InstantSolver& instants, RunStatistics& statistics)
    : solver_(solver),
      schedule_(schedule),
      instants_(instants),
      statistics_(statistics),
      settings_(stepping_settings(solver, statistics.errors.size())),
      passing_(solver) {}

StepStart FreeSteps::begin(const RunState& state, TimedSolution flow) {
  return {std::move(flow), schedule_.next_event(state.now.t)};
}

TakenStep FreeSteps::advance(const RunState& state, StepStart start) {
  const TimedSolution& first = start.flow;
  StepInfo info = begin_step(first.solution, first.seconds);
  const double closest = info.min_gap;
  const Configuration here = configuration_of(solver_, state.now.state);
  std::optional<TimedSolution> last;
  SharedTree tree = std::move(start.flow.solution.tree);  // of the latest solve that was no stage
  const auto within = [&](double t, const VectorXd& q) {
    const TimedSolution stage =
        instants_.solve_stage({t, state.now.t}, admitted_configuration(solver_, t, q), tree);
    info = with_solve(info, stage.solution, stage.seconds);
    return state_rate(solver_, stage.solution, q);
  };
  const auto at_end = [&](double t, const VectorXd& q) {
    if (last) info = with_solve(info, last->solution, last->seconds);  // the step was rejected
    const Configuration there = admitted_configuration(solver_, t, q);
    const std::optional<LatticeStep> lattice =
        lattice_step(lattice_at(solver_.scene(), state.now.t), lattice_at(solver_.scene(), t));
    const std::string passing = passing_.describe_passing(here, there, closest, lattice);
    if (!passing.empty()) throw ConfigurationError(at_time(t) + passing);
    tree.reset();  // two large trees at a time would take too much memory
    last = instants_.solve({t, state.now.t}, there);
    tree = last->solution.tree;
    return state_rate(solver_, last->solution, q);
  };
  const TimePoint now{state.now.t, state.now.state,
                      state_rate(solver_, first.solution, state.now.state)};
  StepResult taken =
      take_step(now, state.steps, {shorter_on_error(within), shorter_on_error(at_end)});
  statistics_.totals.rejected_steps += taken.rejected;
  info.t = taken.step.end.t;
  info.dt = taken.step.dt();
  return {std::move(taken.step), std::move(taken.memory), std::move(*last), {}, info,
          std::move(taken.error)};
}

StepResult FreeSteps::take_step(const TimePoint& start, const StepMemory& memory,
                                const Rates& rates) const {
  const std::string dt_min = "time.dt_min = " + short_number(settings_.dt_min);
  try {
    return Stepper(settings_, rates).advance(start, memory, schedule_.next_event(start.t));
  } catch (const InadmissibleState& error) {
    throw ConfigurationError(std::string(error.what()) + "; steps down to " + dt_min +
                             " lead to it");
  } catch (const StepError& error) {
    throw SolverError(at_time(start.t) + error.what() + ", and steps are not to be shorter than " +
                      dt_min);
  }
}

}  // namespace stokesbook
