// Solves one instant: solves, estimates the error, and solves again with more nodes or a tighter
// GMRES tolerance until the estimate meets the tolerance of the scene (chapter 12). Evaluates the
// flow of a solution, near curves and far from them (chapters 06 to 08).
#include "suspension/solver/solver.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "double_layer/double_layer.hpp"
#include "preconditioning/large_problems.hpp"
#include "suspension/bodies/background_flow.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/solver/density_history.hpp"
#include "suspension/solver/solver_checks.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

double mean_spacing(const Scene& scene, const Discretisation& discretisation) {
  double length = 0.0, nodes = 0.0;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    length += perimeter(discretisation[k]->curve);
    nodes += static_cast<double>(discretisation[k]->curve.size());
  }
  return length / nodes;
}

// Increases node numbers to at least those of `least`; empty: to none.
Resolutions at_least(const Resolutions& least, Resolutions resolutions) {
  for (std::size_t k = 0; k < least.size(); ++k) {
    int& nodes = resolutions[k].n_nodes;
    nodes = std::max(nodes, least[k].n_nodes);
  }
  return resolutions;
}

// Replaces points by their images in a periodic cell, which few images of the bodies are near.
ComplexVector in_cell(const Scene& scene, const Instant& instant, const ComplexVector& points) {
  if (!instant.cell) return points;
  const Lattice lattice = lattice_of(*instant.cell);
  return points.unaryExpr([&](Complex point) { return lattice.wrap(point, cell_centre(scene)); });
}

// Interpolates a density to other nodes of the same configuration.
DensityGuess guess_from(const Configuration& configuration, const Discretisation& nodes,
                        const ComplexVector& density) {
  DensityHistory found(1);
  found.add(0.0, configuration, nodes, density);
  return [configuration, found](const Discretisation& others) {
    return found.guess(0.0, configuration, others);
  };
}

}  // namespace

SuspensionSolver::SuspensionSolver(const Scene& scene) : scene_(scene), plan_(make_plan(scene)) {
  const std::size_t count = count_components(scene).all();
  DiscretisationNeeds needs{plan_.near_correction, {}, {}};
  if (scene.solver.near_singular == NearSingular::interpolation) {
    needs.interpolation_tolerance = scene.solver.tolerance;
  }
  if (!plan_.null_space_fix) needs.gauge_length = scene.gauge_length;
  // A solve uses at most one shape per component, and its error estimate another: the shapes of two
  // solves are kept.
  cache_ = std::make_shared<DiscretisationCache>(needs, 4 * count);
  Resolutions own;
  for (std::size_t k = 0; k < count; ++k) {
    const ComponentView component = component_of(scene_, k);
    own.push_back({own_nodes(component.shape, component.n_nodes, side_of(component.kind),
                             scene.solver.tolerance, component.name())});
  }
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
  Configuration start;
  for (std::size_t k = 0; k < discretisation_.size(); ++k) {
    start.push_back(component_of(scene_, k).start);
  }
  return instant(std::move(start));
}

Instant SuspensionSolver::instant(Configuration configuration, const StepTime& time) const {
  Instant instant{std::move(configuration), {}, cell_at(scene_, time.t)};
  if (instant.cell) {
    instant.path_shifts = path_shifts(scene_, *instant.cell, instant.configuration);
    for (std::size_t k = 0; k < instant.configuration.size(); ++k) {
      instant.configuration[k].position -= instant.path_shifts[k].vector;
    }
  }
  instant.forcing = forcing_at(scene_, discretisation_, time, instant);
  return instant;
}

std::vector<Gap> SuspensionSolver::gaps(const Configuration& configuration,
                                        const std::optional<PeriodicCell>& cell) const {
  return find_gaps(configuration, discretisation_, scene_.solver.tolerance, cell);
}

std::vector<Gap> SuspensionSolver::find_open_gaps(const Instant& instant) const {
  std::vector<Gap> gaps = this->gaps(instant.configuration, instant.cell);
  throw_if<ConfigurationError>(overlap_error(scene_, gaps, instant.configuration));
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

LinearSystem SuspensionSolver::assemble(const StokesProblem& problem,
                                        const Configuration& configuration,
                                        const std::vector<Gap>& gaps,
                                        const Discretisation& discretisation,
                                        const SharedTree& tree) const {
  return preconditioned_system(scene_, plan_, problem, configuration, gaps, discretisation,
                               separation(), tree);
}

LinearSystem SuspensionSolver::linear_system(const Instant& instant,
                                             const Discretisation& discretisation) const {
  const Configuration& configuration = instant.configuration;
  return assemble(instant_problem(scene_, instant, discretisation), configuration,
                  gaps(configuration, instant.cell), discretisation);
}

// Discretises the components of an instant and assembles its linear system.
Solution SuspensionSolver::prepare(const Instant& instant, const std::vector<Gap>& gaps,
                                   const Resolutions& resolutions, const SharedTree& tree) const {
  const Configuration& configuration = instant.configuration;
  throw_if<ConfigurationError>(limit_error(scene_, resolutions, gaps));
  Solution prepared{instant, discretise(resolutions)};
  const Discretisation& discretisation = prepared.discretisation;
  throw_if<ConfigurationError>(geometry_error(scene_, gaps, configuration, discretisation));
  const StokesProblem problem = instant_problem(scene_, instant, discretisation);
  throw_if(data_error(scene_, problem));
  prepared.system = std::make_shared<const LinearSystem>(
      assemble(problem, configuration, gaps, discretisation, tree));
  prepared.tree = prepared.system->tree;
  prepared.velocity_scale = prepared.system->system.right_hand_side().cwiseAbs().maxCoeff();
  prepared.gaps = gaps;
  return prepared;
}

Solution SuspensionSolver::solve_system(Solution prepared, double gmres_tolerance,
                                        const DensityGuess& guess) const {
  const LinearSystem& discrete = *prepared.system;
  GmresResult gmres = stokesbook::solve(discrete, discrete.system.right_hand_side(),
                                        {gmres_tolerance, scene_.solver.gmres_max_iterations},
                                        guess ? guess(prepared.discretisation) : ComplexVector{});
  if (!gmres.converged) {
    throw SolverError(
        "GMRES stopped at a relative residual of " + short_number(gmres.history.back()) +
        " after " + std::to_string(gmres.iterations) + " iterations, required " +
        short_number(gmres_tolerance) + ": raise solver.gmres_max_iterations or solver.tolerance");
  }
  return complete_solution(scene_, std::move(prepared), std::move(gmres));
}

// A quarter more nodes, and at least as many as the softest modes require.
Resolutions SuspensionSolver::finer_than(const Solution& solution) const {
  return at_least(least_, refine(resolutions_of(solution.discretisation)));
}

// The tightest GMRES tolerance of a solve: a hundredth of the planned one, but above rounding.
double SuspensionSolver::least_gmres_tolerance() const {
  return std::max(1e-14, 0.01 * plan_.gmres_tolerance);
}

ErrorEstimate SuspensionSolver::estimate_on_finer_nodes(const LinearSystem& discrete,
                                                        const Solution& solution,
                                                        double gmres_tolerance) const {
  if (solution.velocity_scale == 0.0) return {};
  const bool large = is_large(solution.density.size());
  return_freed_memory(large);
  const Discretisation finer = discretise(finer_than(solution));
  LinearSystem fine = unpreconditioned_system(plan_, loaded_problem(scene_, solution, finer),
                                              solution.instant.configuration, finer);
  return_freed_memory(large);
  // A direct solution leaves far less residual than the estimate needs.
  const double least = discrete.is_factorised() ? gmres_tolerance : 0.0;
  try {
    return estimate_error(discrete, solution.density, std::max(least, solution.gmres.residual),
                          std::move(fine), solution.velocity_scale);
  } catch (const SolverError&) {
    // Rounding errors exceed the correction: the error is unknown.
    return {std::numeric_limits<double>::infinity(), 0};
  }
}

// [solve]

Solution SuspensionSolver::solve(const Instant& instant, DensityGuess guess,
                                 const Resolutions& least) const {
  const std::vector<Gap> gaps = find_open_gaps(instant);
  Effort effort{at_least(least, first_resolutions(instant.configuration, gaps)),
                plan_.gmres_tolerance};
  constexpr int most_increases_without_tail = 3;
  int increases_without_tail = 0;
  SolveCost cost;
  while (true) {
    Solution solution =
        solve_system(prepare(instant, gaps, effort.resolutions), effort.gmres_tolerance, guess);
    const auto [error, matvecs, corrected] =
        estimate_on_finer_nodes(*solution.system, solution, effort.gmres_tolerance);
    cost += {solution.gmres.iterations, solution.gmres.applications + matvecs};
    solution.error_estimate = error;
    solution.cost = cost;
    if (error <= scene_.solver.tolerance) return solution;
    const std::vector<TailEstimate> tails = tail_estimates(
        *solution.system, solution.discretisation, solution.density, solution.velocity_scale);
    Effort next = increase(effort, tails, error);
    // With few nodes the tail of a density may be small by accident, or a point may just miss the
    // near-field criterion: nodes are added even though no tail is large.
    if (next == effort && ++increases_without_tail <= most_increases_without_tail) {
      next.resolutions = refine_automatic(scene_, effort.resolutions);
    }
    if (next == effort) {
      throw ConfigurationError(
          accuracy_error(scene_, effort.resolutions, least_, tails, error, gaps));
    }
    effort = std::move(next);
    guess = corrected.size() > 0
                ? guess_from(instant.configuration, discretise(finer_than(solution)), corrected)
                : guess_from(instant.configuration, solution.discretisation, solution.density);
  }
}
// [solve]

// More nodes where tails are large. If all tails are small, the system is so ill-conditioned that a
// small residual does not imply a small error: the GMRES tolerance is tightened.
SuspensionSolver::Effort SuspensionSolver::increase(const Effort& effort,
                                                    const std::vector<TailEstimate>& tails,
                                                    double error) const {
  Effort next{refine_by_tails(scene_, effort.resolutions, tails, error), effort.gmres_tolerance};
  const double worst_tail = std::ranges::max(tails, {}, &TailEstimate::error).error;
  if (worst_tail < scene_.solver.tolerance && !scene_.solver.gmres_tol) {
    const double required = 0.1 * effort.gmres_tolerance * scene_.solver.tolerance / error;
    next.gmres_tolerance =
        std::min(effort.gmres_tolerance, std::max(required, least_gmres_tolerance()));
  }
  return next;
}

LoadedCheck SuspensionSolver::check_loaded(const Solution& loaded, double gmres_tolerance) const {
  const Resolutions resolutions = resolutions_of(loaded.discretisation);
  LinearSystem discrete =
      unpreconditioned_system(plan_, loaded_problem(scene_, loaded, loaded.discretisation),
                              loaded.instant.configuration, loaded.discretisation);
  if (const LinearMap& precondition = loaded.system->precondition) {
    discrete.precondition = std::cref(precondition);
    discrete.kind = loaded.system->kind;
  }
  Solution solution = loaded;
  const Completion completion = discrete.system.closure().complete(loaded.density);
  for (std::size_t k = 0; k < loaded.discretisation.size(); ++k) {
    if (loaded.discretisation[k]->kind != ComponentKind::free_body) continue;
    // These motions are relative to the flow that carries the body: background_rigid_motion() is no
    // part of the problem.
    const auto& [velocity, omega] = completion.motions[k];
    solution.velocity_scale =
        std::max({solution.velocity_scale, std::abs(velocity),
                  loaded.discretisation[k]->gyration_radius * std::abs(omega)});
  }
  const ErrorEstimate estimate = estimate_on_finer_nodes(discrete, solution, gmres_tolerance);
  if (estimate.error <= scene_.solver.tolerance) return {estimate, resolutions, gmres_tolerance};
  const auto tails =
      tail_estimates(discrete, solution.discretisation, solution.density, solution.velocity_scale);
  const Effort next = increase({resolutions, gmres_tolerance}, tails, estimate.error);
  const bool too_many = !limit_error(scene_, next.resolutions, loaded.gaps).empty();
  return {estimate, too_many ? resolutions : next.resolutions, next.gmres_tolerance};
}

Solution SuspensionSolver::solve_nearby(const Instant& instant, const Resolutions& earlier,
                                        const DensityGuess& guess, const SharedTree& tree) const {
  const std::vector<Gap> gaps = find_open_gaps(instant);
  const Resolutions resolutions = at_least(earlier, first_resolutions(instant.configuration, gaps));
  Solution solution =
      solve_system(prepare(instant, gaps, resolutions, tree), plan_.gmres_tolerance, guess);
  solution.cost = {solution.gmres.iterations, solution.gmres.applications};
  solution.error_estimate = std::numeric_limits<double>::quiet_NaN();
  return solution;
}

Solution SuspensionSolver::solve_lagged(const Instant& instant, const DensityGuess& guess) const {
  const std::vector<Gap> gaps = find_open_gaps(instant);
  Solution solution = prepare(instant, gaps, first_resolutions(instant.configuration, gaps));
  const SuspensionOperator& apply = solution.system->system;
  const ComplexVector rhs = apply.right_hand_side(), before = guess(solution.discretisation);
  const ComplexVector residual = rhs - apply(before);
  GmresResult sweep;
  sweep.solution = interleaved(before) + solution.system->precondition(interleaved(residual));
  sweep.residual = residual.norm() / rhs.norm();
  solution = complete_solution(scene_, std::move(solution), std::move(sweep));
  const ErrorEstimate estimate =
      estimate_on_finer_nodes(*solution.system, solution, plan_.gmres_tolerance);
  solution.error_estimate = estimate.error;
  solution.cost = {0, 1 + estimate.matvecs};
  return solution;
}

Solution SuspensionSolver::solve_refined(const Solution& solution) const {
  const Configuration& configuration = solution.instant.configuration;
  const Resolutions resolutions = finer_than(solution);
  throw_if<ConfigurationError>(limit_error(scene_, resolutions, solution.gaps));
  Solution finer{solution.instant, discretise(resolutions)};
  const StokesProblem problem = loaded_problem(scene_, solution, finer.discretisation);
  finer.system = std::make_shared<const LinearSystem>(
      assemble(problem, configuration, solution.gaps, finer.discretisation));
  finer.velocity_scale = solution.velocity_scale;
  finer.gaps = solution.gaps;
  return solve_system(std::move(finer), least_gmres_tolerance(),
                      guess_from(configuration, solution.discretisation, solution.density));
}

ComplexVector SuspensionSolver::velocity(const Solution& solution,
                                         const ComplexVector& points) const {
  if (points.size() == 0) return {};
  const auto& [configuration, forcing, cell, shifts] = solution.instant;
  const StokesProblem problem = loaded_problem(scene_, solution, solution.discretisation);
  const auto near_curves = scene_.solver.near_singular == NearSingular::off
                               ? std::vector<PlacedCurve>{}
                               : placed_schemes(configuration, solution.discretisation);
  const SolvedFlow flow(problem, near_curves, solution.density,
                        {plan_.near_tolerance, planned_sum(plan_)});
  const ComplexVector velocity = flow.velocity(in_cell(scene_, solution.instant, points));
  if (is_bounded(problem)) return velocity.array() + frame_velocity(scene_, forcing);
  return velocity + forcing.flow * background_velocity(undisturbed_flow(scene_), points);
}

SolvedFlow SuspensionSolver::disturbance(const Solution& solution) const {
  return {loaded_problem(scene_, solution, solution.discretisation),
          placed_cauchy_schemes(solution.instant.configuration, solution.discretisation),
          solution.density,
          {plan_.near_tolerance, planned_sum(plan_)}};
}

std::vector<FlowDerivatives> SuspensionSolver::derivatives(const Solution& solution,
                                                           const ComplexVector& points) const {
  if (points.size() == 0) return {};
  const SolvedFlow flow = disturbance(solution);
  const ComplexVector targets = in_cell(scene_, solution.instant, points);
  std::vector<FlowDerivatives> derivatives = flow.derivatives(targets);
  if (const std::optional<PeriodicCell>& cell = solution.instant.cell) {
    // The pressure rises by F.w/V along a lattice vector w, with the force F of all components.
    Complex force{};
    for (const Load& load : solution.loads) force += load.force;
    const Complex slope = force / (cell->area() * scene_.viscosity);
    for (std::size_t i = 0; i < derivatives.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      derivatives[i].pressure += dot(slope, points[k] - targets[k]);
    }
  }
  if (is_bounded(flow.problem())) return derivatives;
  const double amplitude = solution.instant.forcing.flow;
  for (std::size_t i = 0; i < derivatives.size(); ++i) {
    const auto [pressure, vorticity, strain] =
        background_derivatives(scene_.flow, points[static_cast<Eigen::Index>(i)]);
    derivatives[i] += {amplitude * pressure, amplitude * vorticity, amplitude * strain};
  }
  return derivatives;
}

}  // namespace stokesbook
