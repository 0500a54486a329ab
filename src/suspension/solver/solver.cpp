// Solves one instant: solves, estimates the error, and solves again with more nodes or a tighter
// GMRES tolerance until the estimate meets the tolerance of the scene (chapter 12).
#include "suspension/solver/solver.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "double_layer/double_layer.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/nodes/density_decay.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "suspension/solver/density_history.hpp"
#include "suspension/solver/solver_checks.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// The resolution that a component requires alone.
Resolution own_resolution(const ComponentView& component, double tolerance) {
  return {own_nodes(component, side_of(component.kind), tolerance, component.name())};
}

double mean_spacing(const Scene& scene, const Discretisation& discretisation) {
  double length = 0.0, nodes = 0.0;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    length += perimeter(discretisation[k]->curve);
    nodes += static_cast<double>(discretisation[k]->curve.size());
  }
  return length / nodes;
}

// At most this many times, nodes are increased because of the error estimate alone, although no
// tail of a density is large.
constexpr int most_increases_without_tail = 3;

// The tightest GMRES tolerance of a solve: a hundredth of the planned one, but above rounding.
double least_gmres_tolerance(const Plan& plan) {
  return std::max(1e-14, 0.01 * plan.gmres_tolerance);
}

// Increases node numbers to at least those of `least`; empty: to none.
Resolutions at_least(const Resolutions& least, Resolutions resolutions) {
  for (std::size_t k = 0; k < least.size(); ++k) {
    int& nodes = resolutions[k].n_nodes;
    nodes = std::max(nodes, least[k].n_nodes);
  }
  return resolutions;
}

// Interpolates the density of a solution to other nodes of the same configuration.
DensityGuess guess_from(const Solution& solution) {
  const Configuration& configuration = solution.instant.configuration;
  DensityHistory found(1);
  found.add(0.0, configuration, solution.discretisation, solution.density);
  return [configuration, found](const Discretisation& discretisation) {
    return found.guess(0.0, configuration, discretisation);
  };
}

// Estimates the error of the density on each component from the tail of its Fourier coefficients.
std::vector<TailEstimate> tails_of(const LinearSystem& discrete, const Solution& solution) {
  const ComplexVector complement = discrete.system.closure().without_rigid_part(solution.density);
  const std::vector<Index>& offsets = discrete.system.offsets();
  std::vector<TailEstimate> tails;
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
    tails.push_back(tail_estimate(complement.segment(offsets[k], offsets[k + 1] - offsets[k]),
                                  solution.velocity_scale));
    // The tail does not show the aliasing error of the kernel, which the shape residual measures.
    tails[k].error = std::max(tails[k].error, solution.discretisation[k]->shape_residual);
  }
  return tails;
}

}  // namespace

SuspensionSolver::SuspensionSolver(const Scene& scene) : scene_(scene), plan_(make_plan(scene)) {
  const bool bounded = plan_.null_space_fix;
  const bool interpolate = scene.solver.near_singular == NearSingular::interpolation;
  const std::size_t count = count_components(scene_);
  // A solve uses at most one shape a component, and its error estimate another: those of two kept.
  const std::size_t most_shapes = 4 * count;
  const DiscretisationNeeds needs{
      plan_.near_correction, interpolate ? std::optional(scene.solver.tolerance) : std::nullopt,
      bounded ? std::nullopt : scene.gauge_length};
  cache_ = std::make_shared<DiscretisationCache>(needs, most_shapes);
  Resolutions own;
  for (std::size_t k = 0; k < count; ++k)
    own.push_back(own_resolution(component_of(scene_, k), scene_.solver.tolerance));
  throw_if(limit_error(scene_, own, {}));
  discretisation_ = discretise(own);
  std::map<const DiscretisedShape*, int> least;
  for (std::size_t k = 0; k < count; ++k) {
    const DiscretisedShape& discretised = *discretisation_[k];
    const auto [entry, is_new] = least.try_emplace(&discretised);
    if (is_new) {
      entry->second =
          nodes_for_softest_mode(*cache_, discretised.shape, discretised.kind, own[k].n_nodes);
    }
    least_.push_back({entry->second});
    if (component_of(scene_, k).has_automatic_nodes()) own[k] = least_[k];
  }
  throw_if(limit_error(scene_, own, {}));
  discretisation_ = discretise(own);
  throw_if(separation_error(separation(), start().configuration, discretisation_));
}

double SuspensionSolver::separation() const {
  if (!scene_.contact) return 0.0;
  const double unit = scene_.contact->in_spacings ? mean_spacing(scene_, discretisation_) : 1.0;
  return unit * scene_.contact->minimum_separation;
}

Instant SuspensionSolver::start() const {
  Instant start;
  for (std::size_t k = 0; k < discretisation_.size(); ++k) {
    start.configuration.push_back(component_of(scene_, k).start);
  }
  return start;
}

std::vector<Gap> SuspensionSolver::gaps(const Configuration& configuration) const {
  return find_gaps(configuration, discretisation_, scene_.solver.tolerance);
}

std::vector<Gap> SuspensionSolver::open_gaps(const Configuration& configuration) const {
  std::vector<Gap> gaps = this->gaps(configuration);
  throw_if<ConfigurationError>(overlap_error(scene_, gaps, configuration));
  return gaps;
}

Discretisation SuspensionSolver::discretise(const Resolutions& resolutions) const {
  Discretisation discretisation;
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    const ComponentView component = component_of(scene_, k);
    discretisation.push_back(cache_->get(component.shape, resolutions[k], component.kind));
  }
  return discretisation;
}

LinearSystem SuspensionSolver::linear_system(const Instant& instant,
                                             const Discretisation& discretisation) const {
  const Configuration& configuration = instant.configuration;
  return preconditioned_system(scene_, plan_, problem(instant, discretisation), configuration,
                               gaps(configuration), discretisation, separation());
}

SuspensionSolver::System SuspensionSolver::system(const Instant& instant,
                                                  const std::vector<Gap>& gaps,
                                                  const Resolutions& resolutions) const {
  const Configuration& configuration = instant.configuration;
  throw_if<ConfigurationError>(limit_error(scene_, resolutions, gaps));
  Discretisation discretisation = this->discretise(resolutions);
  throw_if<ConfigurationError>(geometry_error(scene_, gaps, configuration, discretisation));
  const StokesProblem problem = this->problem(instant, discretisation);
  throw_if(data_error(scene_, problem));
  auto discrete = std::make_shared<const LinearSystem>(preconditioned_system(
      scene_, plan_, problem, configuration, gaps, discretisation, separation()));
  return {instant, std::move(discretisation), std::move(discrete)};
}

Solution SuspensionSolver::attempt(const Instant& instant, const std::vector<Gap>& gaps,
                                   const Effort& effort) const {
  const System system = this->system(instant, gaps, effort.resolutions);
  const ComplexVector guess = effort.guess ? effort.guess(system.discretisation) : ComplexVector{};
  Solution solution = converged(system, effort.gmres_tolerance, guess);
  solution.velocity_scale = system.discrete->system.right_hand_side().cwiseAbs().maxCoeff();
  solution.gaps = gaps;
  return solution;
}

Solution SuspensionSolver::converged(const System& system, double gmres_tolerance,
                                     const ComplexVector& guess) const {
  GmresResult gmres =
      stokesbook::solve(*system.discrete, system.discrete->system.right_hand_side(),
                        {gmres_tolerance, scene_.solver.gmres_max_iterations}, guess);
  if (!gmres.converged) {
    throw SolverError(
        "GMRES stopped at a relative residual of " + short_number(gmres.history.back()) +
        " after " + std::to_string(gmres.iterations) + " iterations, asked " +
        short_number(gmres_tolerance) + ": raise solver.gmres_max_iterations or solver.tolerance");
  }
  return complete_solution(scene_, system.instant, system.discretisation, system.discrete,
                           std::move(gmres));
}

// A quarter more nodes, and at least as many as the softest modes require.
Resolutions SuspensionSolver::finer_than(const Solution& solution) const {
  return at_least(least_, finer(resolutions_of(solution.discretisation)));
}

Solution SuspensionSolver::refined(const Solution& solution) const {
  const Configuration& configuration = solution.instant.configuration;
  const Resolutions resolutions = finer_than(solution);
  throw_if<ConfigurationError>(limit_error(scene_, resolutions, solution.gaps));
  System system{solution.instant, discretise(resolutions), {}};
  const StokesProblem problem = loaded_problem(scene_, solution, system.discretisation);
  system.discrete = std::make_shared<const LinearSystem>(preconditioned_system(
      scene_, plan_, problem, configuration, solution.gaps, system.discretisation, separation()));
  Solution finer =
      converged(system, least_gmres_tolerance(plan_), guess_from(solution)(system.discretisation));
  finer.velocity_scale = solution.velocity_scale;
  finer.gaps = solution.gaps;
  return finer;
}

ErrorEstimate SuspensionSolver::estimate(const LinearSystem& discrete,
                                         const Solution& solution) const {
  if (solution.velocity_scale == 0.0) return {};
  const Discretisation finer = discretise(finer_than(solution));
  const LinearSystem fine = unpreconditioned_system(plan_, loaded_problem(scene_, solution, finer),
                                                    solution.instant.configuration, finer);
  try {
    return estimate_error(discrete, solution.gmres, fine, solution.velocity_scale);
  } catch (const SolverError&) {
    // The correction drowns in rounding: the error is unknown.
    return {std::numeric_limits<double>::infinity(), 0};
  }
}

LoadedCheck SuspensionSolver::check_loaded(const Solution& loaded, double gmres_tolerance) const {
  const Resolutions resolutions = resolutions_of(loaded.discretisation);
  LinearSystem discrete =
      unpreconditioned_system(plan_, loaded_problem(scene_, loaded, loaded.discretisation),
                              loaded.instant.configuration, loaded.discretisation);
  discrete.precondition = loaded.system->precondition;
  Solution solution = loaded;
  solution.gmres.solution = interleaved(loaded.density);
  const Completion completion = discrete.system.closure().complete(loaded.density);
  for (std::size_t k = 0; k < loaded.discretisation.size(); ++k) {
    if (loaded.discretisation[k]->kind != ComponentKind::free_body) continue;
    // The motion relative to the flow that carries the body: carried_by() is no part of the
    // problem.
    const auto& [velocity, omega] = completion.motions[k];
    solution.velocity_scale =
        std::max({solution.velocity_scale, std::abs(velocity),
                  loaded.discretisation[k]->gyration_radius * std::abs(omega)});
  }
  const ErrorEstimate estimate = this->estimate(discrete, solution);
  if (estimate.error <= scene_.solver.tolerance) return {estimate, resolutions, gmres_tolerance};
  const Effort effort{resolutions, gmres_tolerance, {}, most_increases_without_tail};
  const Effort next = more_effort(effort, tails_of(discrete, solution), estimate.error);
  const bool too_many = !limit_error(scene_, next.resolutions, loaded.gaps).empty();
  return {estimate, too_many ? resolutions : next.resolutions, next.gmres_tolerance};
}

// [solve]

Solution SuspensionSolver::solve(const Instant& instant, const DensityGuess& guess,
                                 const Resolutions& least) const {
  const std::vector<Gap> gaps = open_gaps(instant.configuration);
  Effort effort{at_least(least, first_resolutions(instant.configuration, gaps)),
                plan_.gmres_tolerance, guess};
  SolveCost cost;
  while (true) {
    Solution solution = attempt(instant, gaps, effort);
    const ErrorEstimate estimate = this->estimate(*solution.system, solution);
    cost.gmres_iterations += solution.gmres.iterations;
    cost.matvecs += solution.gmres.applications + estimate.matvecs;
    solution.error_estimate = estimate.error;
    solution.cost = cost;
    if (solution.error_estimate <= scene_.solver.tolerance) return solution;
    const std::vector<TailEstimate> tails = tails_of(*solution.system, solution);
    Effort next = more_effort(effort, tails, solution.error_estimate);
    if (next.resolutions == effort.resolutions && next.gmres_tolerance == effort.gmres_tolerance) {
      throw ConfigurationError(
          accuracy_error(scene_, effort.resolutions, least_, tails, solution.error_estimate, gaps));
    }
    next.guess = guess_from(solution);
    effort = std::move(next);
  }
}
// [solve]

SuspensionSolver::Effort SuspensionSolver::more_effort(const Effort& effort,
                                                       const std::vector<TailEstimate>& tails,
                                                       double error) const {
  const double worst_tail = std::ranges::max(tails, {}, &TailEstimate::error).error;
  Effort next{raised(scene_, effort.resolutions, tails, error),
              effort.gmres_tolerance,
              {},
              effort.increases_without_tail};
  // All tails are small: the system is so ill-conditioned that a small residual does not imply a
  // small error.
  if (worst_tail < scene_.solver.tolerance && !scene_.solver.gmres_tol) {
    next.gmres_tolerance = std::min(effort.gmres_tolerance, least_gmres_tolerance(plan_));
  }
  // With few nodes the tail of a density may be small by accident, or a point may just miss the
  // near-field criterion: nodes are added even though no tail is large.
  if (next.resolutions == effort.resolutions && next.gmres_tolerance == effort.gmres_tolerance &&
      effort.increases_without_tail < most_increases_without_tail) {
    next.resolutions = finer_automatic(scene_, effort.resolutions);
    ++next.increases_without_tail;
  }
  return next;
}

Solution SuspensionSolver::solve_nearby(const Instant& instant, const Resolutions& earlier,
                                        const DensityGuess& guess) const {
  const std::vector<Gap> gaps = open_gaps(instant.configuration);
  const Resolutions resolutions = at_least(earlier, first_resolutions(instant.configuration, gaps));
  Solution solution = attempt(instant, gaps, {resolutions, plan_.gmres_tolerance, guess});
  solution.cost = {solution.gmres.iterations, solution.gmres.applications};
  solution.error_estimate = std::numeric_limits<double>::quiet_NaN();
  return solution;
}

Solution SuspensionSolver::solve_lagged(const Instant& instant, const DensityGuess& guess) const {
  const std::vector<Gap> gaps = open_gaps(instant.configuration);
  const System system = this->system(instant, gaps, first_resolutions(instant.configuration, gaps));
  const SuspensionOperator& apply = system.discrete->system;
  const ComplexVector rhs = apply.right_hand_side(), before = guess(system.discretisation);
  const ComplexVector residual = rhs - apply(before);
  GmresResult sweep;
  sweep.solution = interleaved(before) + system.discrete->precondition(interleaved(residual));
  sweep.residual = residual.norm() / rhs.norm();
  Solution solution = complete_solution(scene_, system.instant, system.discretisation,
                                        system.discrete, std::move(sweep));
  solution.velocity_scale = rhs.cwiseAbs().maxCoeff();
  solution.gaps = gaps;
  const ErrorEstimate estimate = this->estimate(*system.discrete, solution);
  solution.error_estimate = estimate.error;
  solution.cost = {0, 1 + estimate.matvecs};
  return solution;
}

}  // namespace stokesbook
