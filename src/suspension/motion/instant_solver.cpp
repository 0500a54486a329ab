// Solves the instants of a run, each from the densities of those before, and decides which solves
// estimate their error (chapter 12).
#include "suspension/motion/instant_solver.hpp"

#include <chrono>
#include <utility>

#include "suspension/solver/solver_checks.hpp"
#include "text/number_text.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

namespace {

// A quadratic in time: polynomials through more densities amplify the residuals that GMRES leaves,
// and these residuals are the ones that take most iterations.
constexpr std::size_t densities_kept = 3;

// An estimate takes about as long as a solve.
constexpr int solves_per_estimate = 8;

std::string divergence_error(const Solution& lagged) {
  if (!(lagged.gmres.residual > 1.0)) return {};
  return "the lagged coupling diverges: the densities of the step before leave a residual of " +
         short_number(lagged.gmres.residual, 3) +
         " times the data. Each step is one sweep, whatever its length: shorter ones do not help, "
         "solver.coupling = \"global\" does";
}

}  // namespace

InstantSolver::InstantSolver(const SuspensionSolver& solver, const OutputSchedule& schedule,
                             RunStatistics& statistics, LoadFunction loads)
    : solver_(solver),
      schedule_(schedule),
      statistics_(statistics),
      loads_(std::move(loads)),
      memory_{
          DensityHistory(solver.scene().solver.coupling == Coupling::local ? 1 : densities_kept)} {
  memory_.gmres_tolerance = solver.plan().gmres_tolerance;
}

TimedSolution InstantSolver::solve(const StepTime& time, const Configuration& configuration) {
  const bool due = memory_.densities.empty() ||
                   memory_.solves_since_estimate >= solves_per_estimate ||
                   schedule_.is_written(time.t);
  const bool is_lagged = solver_.scene().solver.coupling == Coupling::local;
  const bool in_contact = memory_.columns.loads.cols() > 0 && !is_lagged;
  const EstimateOf estimate = !due         ? EstimateOf::earlier_solve
                              : in_contact ? EstimateOf::solution_in_contact
                                           : EstimateOf::solution;
  const double dt = memory_.densities.ends_at(time.t) && !is_lagged ? memory_.stage_dt : 0.0;
  TimedSolution end =
      solve(time, configuration, density_guess(time.t, configuration, -dt * dt), estimate);
  memory_.stage_dt = 0.0;
  if (dt > 0.0) {
    const Discretisation& discretisation = end.solution.discretisation;
    const ComplexVector of_stage =
        end.before.densities.guess(time.t, configuration, discretisation);
    memory_.stage_deviations.add(time.t, configuration, discretisation,
                                 (of_stage - end.solution.density) / (dt * dt));
  }
  return end;
}

TimedSolution InstantSolver::solve_stage(const StepTime& time, const Configuration& configuration,
                                         const SharedTree& tree) {
  const double dt = time.t - time.begin;
  TimedSolution stage = solve(time, configuration, density_guess(time.t, configuration, dt * dt),
                              EstimateOf::earlier_solve, tree);
  memory_.stage_dt = dt;
  return stage;
}

TimedSolution InstantSolver::solve(const StepTime& time, const Configuration& configuration,
                                   const DensityGuess& guess, EstimateOf estimate,
                                   const SharedTree& tree) {
  const auto start = std::chrono::steady_clock::now();
  const double t = time.t;
  const Instant instant = this->instant(time, configuration);
  SolveMemory before = memory_;
  Solution solution =
      with_time_in_errors(t, [&] { return solve_from_guess(instant, guess, estimate, tree); });
  if (estimate != EstimateOf::solution) solution.error_estimate = memory_.error_estimate;
  memory_.densities.add(t, configuration, solution.discretisation, solution.density);
  if (!solver_.scene().contact) solution.system.reset();  // only contact solves it again
  if (loads_) memory_.motions = path_motions(solution);
  memory_.error_estimate = solution.error_estimate;
  memory_.solves_since_estimate =
      estimate == EstimateOf::earlier_solve ? memory_.solves_since_estimate + 1 : 0;
  statistics_.add_resolution(solution);
  statistics_.add_solve(solution);
  return {std::move(solution), std::move(before), seconds_since(start), estimate};
}

Instant InstantSolver::instant(const StepTime& time, const Configuration& configuration) const {
  Instant instant = solver_.instant(configuration, time);
  if (!loads_) return instant;
  std::vector<Load>& sum = instant.forcing.loads;
  const std::vector<Load> loads = loads_(time.t, configuration, memory_.motions);
  require(loads.size() == sum.size(), "the load function returns ", loads.size(), " loads for ",
          sum.size(), " bodies: it must return one for each");
  for (std::size_t k = 0; k < loads.size(); ++k) {
    sum[k].force += loads[k].force;
    sum[k].torque += loads[k].torque;
  }
  return instant;
}

Solution InstantSolver::solve_from_guess(const Instant& instant, const DensityGuess& guess,
                                         EstimateOf estimate, const SharedTree& tree) const {
  const DensityHistory& densities = memory_.densities;
  if (solver_.scene().solver.coupling == Coupling::local && !densities.empty()) {
    Solution solution = solver_.solve_lagged(instant, guess);
    throw_if(divergence_error(solution));
    return solution;
  }
  return solve_coupled(instant, guess, estimate, tree);
}

Solution InstantSolver::solve_coupled(const Instant& instant, const DensityGuess& guess,
                                      EstimateOf estimate, const SharedTree& tree) const {
  const Resolutions& for_contact = memory_.contact_resolutions;
  switch (estimate) {
    case EstimateOf::solution:
      return solver_.solve(instant, guess, for_contact);
    case EstimateOf::solution_in_contact:
      return solver_.solve_nearby(instant, for_contact, guess);
    default:
      return solver_.solve_nearby(instant, memory_.densities.latest_resolutions(), guess, tree);
  }
}

Solution InstantSolver::solve_again(double t, const TimedSolution& flow) {
  const Instant& instant = flow.solution.instant;
  const Configuration& configuration = instant.configuration;
  const bool is_estimated = flow.estimate == EstimateOf::solution;
  Solution solution = with_time_in_errors(t, [&] {
    return solve_coupled(instant, density_guess(t, configuration),
                         is_estimated ? EstimateOf::solution : EstimateOf::solution_in_contact);
  });
  statistics_.add_solve(solution);
  if (!is_estimated) solution.error_estimate = flow.solution.error_estimate;
  memory_.densities.add(t, configuration, solution.discretisation, solution.density);
  return solution;
}

// Extrapolates the densities, and adds the deviations of stages times a factor.
DensityGuess InstantSolver::density_guess(double t, const Configuration& configuration,
                                          double deviations) const {
  return [=, this](const Discretisation& discretisation) -> ComplexVector {
    ComplexVector guess = memory_.densities.guess(t, configuration, discretisation);
    if (deviations != 0.0 && !memory_.stage_deviations.empty()) {
      guess += deviations * memory_.stage_deviations.guess(t, configuration, discretisation);
    }
    return guess;
  };
}

}  // namespace stokesbook
