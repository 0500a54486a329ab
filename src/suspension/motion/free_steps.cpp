// Takes steps without contact: the rates of chapter 09's stepper are solutions of instants. The
// space-time interference of chapter 10 finds steps that take bodies through each other, with
// polygons that are as coarse as the depth of an overlap allows.
#include "suspension/motion/free_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "stiv/interferences.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/configuration.hpp"
#include "text/number_text.hpp"
#include "trapezoid/rectangle_index.hpp"

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

// Returns the largest displacement of a point of a component.
double longest_displacement(const ContactShapes& shapes, const Configuration& start,
                            const Configuration& end) {
  double longest = 0.0;
  for (std::size_t k = 0; k < start.size(); ++k) {
    const double turn = std::abs(end[k].orientation - start[k].orientation);
    longest =
        std::max(longest, std::abs(end[k].position - start[k].position) + turn * shapes[k]->radius);
  }
  return longest;
}

// Returns the vectors by which images of components may come within a reach of the cell in a step.
std::vector<Complex> near_vectors(const LatticeStep& lattice, double reach) {
  // An image w that moves by D w is within the reach R only if |w| < R (1 + |D|), as D^2 = 0 in a
  // shear. The components of w along a reduced basis are at most 2 |w| / sqrt(3).
  double moved = 0.0;
  for (const Complex b : {lattice.start.shortest(), lattice.start.second()}) {
    moved += 2.0 / std::numbers::sqrt3 * std::abs(lattice.at_end(b) - b) / std::abs(b);
  }
  std::vector<Complex> vectors;
  for (const Complex w : lattice.start.half_disk(reach * (1.0 + moved))) {
    vectors.insert(vectors.end(), {w, -w});
  }
  return vectors;
}

// Returns the least rectangle that holds the paths of the positions of some components.
Rectangle paths_rectangle(const Configuration& start, const Configuration& end) {
  ComplexVector points(2 * std::ssize(start));
  for (std::size_t k = 0; k < start.size(); ++k) {
    points.segment<2>(2 * static_cast<Eigen::Index>(k)) << start[k].position, end[k].position;
  }
  return bounding_rectangle(points);
}

Pose moved(const Pose& pose, Complex vector) {
  return {pose.position + vector, pose.orientation};
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
  const double longest = longest_displacement(shapes_, start, end);
  double radius = 0.0;
  for (const auto& shape : shapes_) radius = std::max(radius, shape->radius);
  std::vector<Complex> images;
  double carried = 0.0;  // largest displacement of an image relative to the cell
  if (lattice) {
    images =
        near_vectors(*lattice, std::abs(lattice->start.shortest()) +
                                   std::abs(lattice->start.second()) + 2.0 * (radius + longest));
    for (const Complex w : images) carried = std::max(carried, std::abs(lattice->at_end(w) - w));
  }
  // A gap shrinks by at most the sum of the displacements.
  if (2.0 * longest + carried < closest) return {};
  const std::size_t count = start.size();
  ContactShapes shapes = shapes_;
  Configuration starts = start, ends = end;
  std::vector<std::size_t> components(count);
  std::iota(components.begin(), components.end(), std::size_t{0});
  const RectangleIndex cell({widened(paths_rectangle(start, end), 2.0 * radius)});
  for (const Complex w : images) {
    for (std::size_t k = 0; k < count; ++k) {
      const Pose begin = moved(start[k], w), there = moved(end[k], lattice->at_end(w));
      if (cell.meeting(paths_rectangle({begin}, {there})).empty()) continue;
      shapes.push_back(shapes_[k]);
      starts.push_back(begin);
      ends.push_back(there);
      components.push_back(k);
    }
  }
  const Eigen::VectorXd displacement = to_state(ends) - to_state(starts);
  const ContactRules rules{{sag_}, accepted_sags * sag_};
  const Interferences found =
      interferences(shapes, straight_paths(starts, displacement, 1.0), rules);
  const auto passing = std::ranges::find_if(found.contacts, &Contact::is_violated);
  if (passing == found.contacts.end()) return {};
  const auto name = passing->b < count ? name_pair : name_image_pair;
  return name(solver_.scene(), components[passing->a], components[passing->b]) +
         " overlap or pass through each other within a step: take smaller steps, or give [contact]";
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
  const Instant& instant = first.solution.instant;
  // Looks for passing components between here and another state; in a cell, on the paths of the
  // images that are in the cell at the start.
  const auto describe_passing = [&](double t, Configuration there) {
    std::optional<LatticeStep> lattice;
    if (instant.cell) {
      lattice = {lattice_of(*instant.cell), lattice_of(*cell_at(solver_.scene(), t))};
      for (std::size_t k = 0; k < there.size(); ++k) {
        there[k].position -= lattice->at_end(instant.path_shifts[k].vector);
      }
    }
    return passing_.describe_passing(instant.configuration, there, closest, lattice);
  };
  std::optional<TimedSolution> last;
  const auto within = [&](double t, const VectorXd& q) {
    const TimedSolution stage =
        instants_.solve_stage({t, state.now.t}, admitted_configuration(solver_, t, q));
    info = with_solve(info, stage.solution, stage.seconds);
    return state_rate(solver_, stage.solution, q);
  };
  const auto at_end = [&](double t, const VectorXd& q) {
    if (last) info = with_solve(info, last->solution, last->seconds);  // the step was rejected
    const Configuration there = admitted_configuration(solver_, t, q);
    const std::string passing = describe_passing(t, there);
    if (!passing.empty()) throw ConfigurationError(at_time(t) + passing);
    last = instants_.solve({t, state.now.t}, there);
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
