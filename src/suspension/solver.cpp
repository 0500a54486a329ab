#include "suspension/solver.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "double_layer/double_layer.hpp"
#include "krylov/direct.hpp"
#include "record/number_text.hpp"
#include "suspension/background_flow.hpp"
#include "suspension/clusters.hpp"
#include "suspension/component_data.hpp"
#include "suspension/density_history.hpp"
#include "suspension/grading_for_gaps.hpp"
#include "suspension/layer_blocks.hpp"
#include "suspension/node_choice.hpp"
#include "suspension/preconditioner_choice.hpp"
#include "suspension/refusal.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// A component's reference from the shelf, or the reason why it cannot be used.
std::shared_ptr<const Reference> take(ReferenceShelf& shelf, const Scene& scene,
                                      std::size_t component, const Resolution& resolution) {
  const std::size_t bodies = scene.bodies.size();
  const auto get = [&](const auto& source) {
    return shelf.get(source.shape, resolution, kind_of(source));
  };
  try {
    return component < bodies ? get(scene.bodies[component]) : get(scene.walls[component - bodies]);
  } catch (const std::domain_error& error) {
    throw NumericsRefused(
        component_name(scene, component) + ": " + error.what() +
        "; a gauge_length close to the size of a held component is a degenerate scale");
  }
}

// What a component asks for alone.
Resolution own_resolution(const Scene& scene, std::size_t component) {
  const std::size_t bodies = scene.bodies.size();
  const auto nodes = [&](const auto& source) {
    return own_nodes(source, side_of(kind_of(source)), scene.solver.tolerance,
                     component_name(scene, component));
  };
  return {component < bodies ? nodes(scene.bodies[component])
                             : nodes(scene.walls[component - bodies])};
}

// A refusal's text, if there is any, ends the solve.
template <class Refused = NumericsRefused>
void refuse(const std::string& message) {
  if (!message.empty()) throw Refused(message);
}

// Nodes are raised as often on the estimate's word alone.
constexpr int most_suspicions = 3;

// A hundredth of what is planned, as far as rounding allows.
double least_gmres_tolerance(const Plan& plan) {
  return std::max(1e-14, 0.01 * plan.gmres_tolerance);
}

// No fewer nodes than others; they were automatic.
Resolutions at_least(const Resolutions& least, Resolutions resolutions) {
  for (std::size_t k = 0; k < least.size(); ++k) {
    int& nodes = resolutions[k].n_nodes;
    nodes = std::max(nodes, least[k].n_nodes);
  }
  return resolutions;
}

std::vector<TailEstimate> tails_of(const DiscreteProblem& discrete, const Solution& solution) {
  const ComplexVector rest = discrete.system.closure().without_rigid_part(solution.density);
  const std::vector<Index>& offsets = discrete.system.offsets();
  std::vector<TailEstimate> tails;
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k) {
    tails.push_back(tail_estimate(rest.segment(offsets[k], offsets[k + 1] - offsets[k]),
                                  solution.velocity_scale));
    // What aliases in the kernel, tails do not show.
    tails[k].error = std::max(tails[k].error, solution.references[k]->rigid_motion_residual);
  }
  return tails;
}

// Sums fast or directly, whichever takes less for the targets that come.
PlainSum planned_sum(const Plan& plan) {
  const auto choice = [=](const SolvedFlow& flow, const ComplexVector& targets) {
    const bool fast = plan.is_fast_at(targets.size(), flow.density().size());
    return fast ? fast_sum(plan.sum_tolerance) : direct_sum();
  };
  return {[=](const SolvedFlow& flow, const ComplexVector& targets) {
            return choice(flow, targets).velocity(flow, targets);
          },
          [=](const SolvedFlow& flow, const ComplexVector& targets) {
            return choice(flow, targets).derivatives(flow, targets);
          }};
}

// A component that is alone has none: only the flow near it asks for one.
std::shared_ptr<const CauchyCurve> cauchy_of(const Reference& reference) {
  return reference.cauchy ? reference.cauchy : std::make_shared<const CauchyCurve>(reference.curve);
}

}  // namespace

SuspensionSolver::SuspensionSolver(const Scene& scene) : scene_(scene), plan_(make_plan(scene)) {
  const bool bounded = plan_.null_space_fix;
  const bool interpolate = scene.solver.near_singular == NearSingular::interpolation;
  const std::size_t count = scene_.bodies.size() + scene_.walls.size();
  // A solve and its estimate ask for two a component: some thirty solves long.
  const std::size_t patience = 64 * count;
  shelf_ = std::make_shared<ReferenceShelf>(
      ReferenceNeeds{plan_.near_correction,
                     interpolate ? std::optional(scene.solver.tolerance) : std::nullopt,
                     plan_.preconditioner == PreconditionerKind::block_diagonal,
                     bounded ? std::nullopt : scene.gauge_length},
      patience);
  Resolutions own;
  for (std::size_t k = 0; k < count; ++k) own.push_back(own_resolution(scene_, k));
  refuse(limit_refusal(scene_, own, {}));
  references_ = references(own);
}

Configuration SuspensionSolver::initial_configuration() const {
  Configuration configuration;
  const auto add = [&](const auto& component) {
    configuration.push_back({component.position, component.orientation});
  };
  std::for_each(scene_.bodies.begin(), scene_.bodies.end(), add);
  std::for_each(scene_.walls.begin(), scene_.walls.end(), add);
  return configuration;
}

StokesProblem SuspensionSolver::problem(const Configuration& configuration,
                                        const References& references, double drive) const {
  StokesProblem problem{{}, scene_.viscosity, {}, scene_.gauge_length};
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    const Curve curve = place(references[k]->curve, position, orientation);
    Component component{references[k]->kind, curve, position, {}, 0.0, {}};
    if (k >= scene_.bodies.size()) {
      const Wall& wall = scene_.walls[k - scene_.bodies.size()];
      component.velocity = drive * wall_velocity(wall.motion, curve, position);
    } else if (const Body& body = scene_.bodies[k]; body.held) {
      const auto arm = curve.x.array() - position;
      component.velocity = (drive * (body.velocity + imaginary * body.omega * arm)).matrix();
    } else {
      component.force = drive * body.force;
      component.torque = drive * body.torque;
    }
    problem.components.push_back(std::move(component));
  }
  if (!is_bounded(problem)) {
    problem.background = drive * background_velocity(scene_.flow, all_nodes(curves_of(problem)));
  }
  return problem;
}

std::vector<PlacedCurve> SuspensionSolver::placed(const Configuration& configuration,
                                                  const References& references) const {
  std::vector<PlacedCurve> placed;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Reference& reference = *references[k];
    CloseScheme scheme = cauchy_of(reference);
    if (reference.interpolation) scheme = reference.interpolation;
    placed.push_back({scheme, configuration[k].position, configuration[k].orientation});
  }
  return placed;
}

DiscreteProblem SuspensionSolver::discretise(const Configuration& configuration,
                                             const References& references, double drive) const {
  return discretise(problem(configuration, references, drive), configuration, gaps(configuration),
                    references);
}

std::vector<PlacedCurve> SuspensionSolver::near_curves(const Configuration& configuration,
                                                       const References& references) const {
  return plan_.near_correction ? placed(configuration, references) : std::vector<PlacedCurve>{};
}

DiscreteProblem SuspensionSolver::unpreconditioned(const StokesProblem& problem,
                                                   const Configuration& configuration,
                                                   const References& references) const {
  return {problem, SuspensionOperator(problem, near_curves(configuration, references), plan_)};
}

DiscreteProblem SuspensionSolver::discretise(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const std::vector<Gap>& gaps,
                                             const References& references) const {
  DiscreteProblem discrete = unpreconditioned(problem, configuration, references);
  const std::vector<PlacedCurve> near = near_curves(configuration, references);
  switch (chosen_preconditioner(plan_, gaps, references)) {
    case PreconditionerKind::direct:
      discrete.precondition =
          DirectPreconditioner(problem, layer_blocks(problem, near, plan_.near_tolerance));
      return discrete;
    case PreconditionerKind::clusters:
      discrete.precondition = cluster_preconditioner(problem, configuration, references, near);
      return discrete;
    case PreconditionerKind::none:
      return discrete;
    default:
      break;
  }
  std::vector<BlockDiagonalPreconditioner::Member> members;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    members.push_back({references[k]->inverse_block, configuration[k].orientation});
  }
  discrete.precondition = BlockDiagonalPreconditioner(std::move(members));
  return discrete;
}

std::vector<Gap> SuspensionSolver::gaps(const Configuration& configuration) const {
  return find_gaps(configuration, references_, scene_.solver.tolerance);
}

std::vector<Gap> SuspensionSolver::open_gaps(const Configuration& configuration) const {
  std::vector<Gap> gaps = this->gaps(configuration);
  refuse<ConfigurationRefused>(overlap_refusal(scene_, gaps, configuration));
  return gaps;
}

Solution SuspensionSolver::completed(const System& system, GmresResult gmres, double drive) const {
  Solution solution;
  solution.references = system.references;
  solution.system = system.discrete;
  solution.gmres = std::move(gmres);
  solution.density = deinterleaved(solution.gmres.solution);
  const Completion completion = system.discrete->system.closure().complete(solution.density);
  solution.motions = completion.motions;
  solution.loads = completion.loads;
  solution.uniform_velocity = completion.uniform_velocity;
  for (std::size_t k = 0; k < system.references.size(); ++k) {
    if (k >= scene_.bodies.size()) {
      const RigidMotion motion = rigid_motion(scene_.walls[k - scene_.bodies.size()].motion);
      solution.motions[k] = {drive * motion.velocity, drive * motion.omega};
    } else if (const Body& body = scene_.bodies[k]; body.held) {
      solution.motions[k] = {drive * body.velocity, drive * body.omega};
    }
  }
  return solution;
}

SuspensionSolver::System SuspensionSolver::system(const Configuration& configuration,
                                                  const std::vector<Gap>& gaps,
                                                  const Resolutions& resolutions,
                                                  double drive) const {
  refuse<ConfigurationRefused>(limit_refusal(scene_, resolutions, gaps));
  References references = this->references(resolutions);
  refuse<ConfigurationRefused>(geometry_refusal(scene_, gaps, configuration, references));
  const StokesProblem problem = this->problem(configuration, references, drive);
  refuse(data_refusal(scene_, problem));
  auto discrete =
      std::make_shared<const DiscreteProblem>(discretise(problem, configuration, gaps, references));
  return {std::move(references), std::move(discrete)};
}

Solution SuspensionSolver::attempt(const Configuration& configuration, const std::vector<Gap>& gaps,
                                   const Effort& effort, double drive) const {
  const System system = this->system(configuration, gaps, effort.resolutions, drive);
  const ComplexVector rhs = system.discrete->system.right_hand_side();
  const ComplexVector guess = effort.guess ? effort.guess(system.references) : ComplexVector{};
  GmresResult gmres = stokesbook::solve(
      *system.discrete, rhs, {effort.gmres_tolerance, scene_.solver.gmres_max_iterations}, guess);
  if (!gmres.converged) {
    throw NumericsRefused("GMRES stopped at a relative residual of " +
                          short_number(gmres.history.back()) + " after " +
                          std::to_string(gmres.iterations) + " iterations, asked " +
                          short_number(effort.gmres_tolerance) +
                          ": raise solver.gmres_max_iterations or solver.tolerance");
  }
  Solution solution = completed(system, std::move(gmres), drive);
  solution.velocity_scale = rhs.cwiseAbs().maxCoeff();
  solution.gaps = gaps;
  return solution;
}

ErrorEstimate SuspensionSolver::estimate(const DiscreteProblem& discrete,
                                         const Configuration& configuration,
                                         const Solution& solution, double drive) const {
  if (solution.velocity_scale == 0.0) return {};
  const References finer = references(stokesbook::finer(resolutions_of(solution.references)));
  const DiscreteProblem fine =
      unpreconditioned(loaded_problem(configuration, finer, solution, drive), configuration, finer);
  try {
    return estimate_error(discrete, solution.gmres, fine, solution.velocity_scale);
  } catch (const NumericsRefused&) {
    // The correction is lost in rounding: nothing is known of the error.
    return {std::numeric_limits<double>::infinity(), 0};
  }
}

// Free bodies bear the solution's own loads: the scene's, and those of contact where there are any.
StokesProblem SuspensionSolver::loaded_problem(const Configuration& configuration,
                                               const References& references,
                                               const Solution& solution, double drive) const {
  StokesProblem problem = this->problem(configuration, references, drive);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    Component& component = problem.components[k];
    if (component.kind != ComponentKind::free_body) continue;
    component.force = solution.loads[k].force;
    component.torque = solution.loads[k].torque;
  }
  return problem;
}

LoadedCheck SuspensionSolver::check_loaded(const Configuration& configuration,
                                           const Solution& loaded, double gmres_tolerance,
                                           double drive) const {
  const Resolutions resolutions = resolutions_of(loaded.references);
  DiscreteProblem discrete =
      unpreconditioned(loaded_problem(configuration, loaded.references, loaded, drive),
                       configuration, loaded.references);
  discrete.precondition = loaded.system->precondition;
  Solution solution = loaded;
  solution.gmres.solution = interleaved(loaded.density);
  const ErrorEstimate estimate = this->estimate(discrete, configuration, solution, drive);
  if (estimate.error <= scene_.solver.tolerance) return {estimate, resolutions, gmres_tolerance};
  const Effort effort{resolutions, gmres_tolerance, {}, most_suspicions};
  const Effort next = greater(effort, tails_of(discrete, solution), estimate.error);
  const bool too_many = !limit_refusal(scene_, next.resolutions, loaded.gaps).empty();
  return {estimate, too_many ? resolutions : next.resolutions, next.gmres_tolerance};
}

// [solve]
Solution SuspensionSolver::solve(const Configuration& configuration, double drive,
                                 const DensityGuess& guess, const Resolutions& least) const {
  const std::vector<Gap> gaps = open_gaps(configuration);
  Effort effort{at_least(least, first_resolutions(configuration, gaps)), plan_.gmres_tolerance,
                guess};
  SolveCost cost;
  while (true) {
    Solution solution = attempt(configuration, gaps, effort, drive);
    const ErrorEstimate estimate = this->estimate(*solution.system, configuration, solution, drive);
    cost.gmres_iterations += solution.gmres.iterations;
    cost.matvecs += solution.gmres.applications + estimate.matvecs;
    solution.error_estimate = estimate.error;
    solution.cost = cost;
    if (solution.error_estimate <= scene_.solver.tolerance) return solution;
    const std::vector<TailEstimate> tails = tails_of(*solution.system, solution);
    Effort next = greater(effort, tails, solution.error_estimate);
    if (next.resolutions == effort.resolutions && next.gmres_tolerance == effort.gmres_tolerance) {
      throw ConfigurationRefused(
          accuracy_refusal(scene_, effort.resolutions, tails, solution.error_estimate, gaps));
    }
    DensityHistory found(1);
    found.add(0.0, configuration, solution.references, solution.density);
    next.guess = [&configuration, found](const References& references) {
      return found.guess(0.0, configuration, references);
    };
    effort = std::move(next);
  }
}
// [solve]

SuspensionSolver::Effort SuspensionSolver::greater(const Effort& effort,
                                                   const std::vector<TailEstimate>& tails,
                                                   double error) const {
  const double worst_tail = std::ranges::max(tails, {}, &TailEstimate::error).error;
  Effort next{raised(scene_, effort.resolutions, tails, error),
              effort.gmres_tolerance,
              {},
              effort.suspicions};
  // The nodes do: the system is so ill-conditioned that its residual says little.
  if (worst_tail < scene_.solver.tolerance && !scene_.solver.gmres_tol) {
    next.gmres_tolerance = std::min(effort.gmres_tolerance, least_gmres_tolerance(plan_));
  }
  // Few nodes may hide what they leave: a tail that is small by chance, a point that is nearly near.
  if (next.resolutions == effort.resolutions && next.gmres_tolerance == effort.gmres_tolerance &&
      effort.suspicions < most_suspicions) {
    next.resolutions = finer_automatic(scene_, effort.resolutions);
    ++next.suspicions;
  }
  return next;
}

Solution SuspensionSolver::solve_nearby(const Configuration& configuration,
                                        const Resolutions& earlier, double drive,
                                        const DensityGuess& guess) const {
  const std::vector<Gap> gaps = open_gaps(configuration);
  const Resolutions resolutions = at_least(earlier, first_resolutions(configuration, gaps));
  Solution solution =
      attempt(configuration, gaps, {resolutions, plan_.gmres_tolerance, guess}, drive);
  solution.cost = {solution.gmres.iterations, solution.gmres.applications};
  solution.error_estimate = std::numeric_limits<double>::quiet_NaN();
  return solution;
}

Solution SuspensionSolver::solve_lagged(const Configuration& configuration,
                                        const DensityGuess& guess, double drive) const {
  const std::vector<Gap> gaps = open_gaps(configuration);
  const System system =
      this->system(configuration, gaps, first_resolutions(configuration, gaps), drive);
  const auto& [problem, apply, precondition] = *system.discrete;
  const ComplexVector rhs = apply.right_hand_side(), before = guess(system.references);
  const ComplexVector residual = rhs - apply(before);
  GmresResult sweep;
  sweep.solution = interleaved(before) + precondition(interleaved(residual));
  sweep.residual = residual.norm() / rhs.norm();
  Solution solution = completed(system, std::move(sweep), drive);
  solution.velocity_scale = rhs.cwiseAbs().maxCoeff();
  solution.gaps = gaps;
  const ErrorEstimate estimate = this->estimate(*system.discrete, configuration, solution, drive);
  solution.error_estimate = estimate.error;
  solution.cost = {0, 1 + estimate.matvecs};
  return solution;
}

ComplexVector SuspensionSolver::velocity(const Configuration& configuration,
                                         const Solution& solution, const ComplexVector& points,
                                         double drive) const {
  const StokesProblem problem = this->problem(configuration, solution.references, drive);
  const auto near_curves = scene_.solver.near_singular == NearSingular::off
                               ? std::vector<PlacedCurve>{}
                               : placed(configuration, solution.references);
  ComplexVector velocity =
      SolvedFlow(problem, near_curves, solution.density, {plan_.near_tolerance, planned_sum(plan_)})
          .velocity(points);
  if (!is_bounded(problem)) velocity += drive * background_velocity(scene_.flow, points);
  return velocity;
}

SolvedFlow SuspensionSolver::disturbance(const Configuration& configuration,
                                         const Solution& solution, double drive) const {
  std::vector<PlacedCurve> curves;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    curves.push_back({cauchy_of(*solution.references[k]), position, orientation});
  }
  return {problem(configuration, solution.references, drive),
          std::move(curves),
          solution.density,
          {plan_.near_tolerance, planned_sum(plan_)}};
}

std::vector<FlowDerivatives> SuspensionSolver::derivatives(const Configuration& configuration,
                                                           const Solution& solution,
                                                           const ComplexVector& points,
                                                           double drive) const {
  const SolvedFlow flow = disturbance(configuration, solution, drive);
  std::vector<FlowDerivatives> derivatives = flow.derivatives(points);
  if (is_bounded(flow.problem())) return derivatives;
  const std::vector<FlowDerivatives> background = background_derivatives(scene_.flow, points);
  for (std::size_t i = 0; i < derivatives.size(); ++i) {
    const auto& [pressure, vorticity, strain] = background[i];
    derivatives[i] += {drive * pressure, drive * vorticity, drive * strain};
  }
  return derivatives;
}

std::vector<int> SuspensionSolver::recommended_nodes(const Configuration& configuration) const {
  return recommended_nodes(configuration, gaps(configuration));
}

std::vector<int> SuspensionSolver::recommended_nodes(const Configuration& configuration,
                                                     const std::vector<Gap>& gaps) const {
  const double tolerance = scene_.solver.tolerance;
  std::map<const Reference*, int> shape_nodes;
  std::vector<int> nodes;
  for (const auto& reference : references_) {
    const auto [entry, is_new] = shape_nodes.try_emplace(reference.get());
    if (is_new) {
      entry->second = nodes_for_shape(reference->shape, reference->curve.side, tolerance, 16);
    }
    nodes.push_back(entry->second);
  }
  for (const Gap& gap : gaps) {
    if (gap.points.gap <= 0.0) continue;
    const DensityDecay decay = gap_resolution(gap, configuration, references_).decay;
    nodes[gap.a] = std::max(nodes[gap.a], stokesbook::recommended_nodes(decay.a, tolerance));
    nodes[gap.b] = std::max(nodes[gap.b], stokesbook::recommended_nodes(decay.b, tolerance));
  }
  return nodes;
}

Resolutions SuspensionSolver::first_resolutions(const Configuration& configuration) const {
  return first_resolutions(configuration, gaps(configuration));
}

Resolutions SuspensionSolver::first_resolutions(const Configuration& configuration,
                                                const std::vector<Gap>& gaps) const {
  Resolutions resolutions = resolutions_of(references_);
  std::vector<std::vector<GapDemand>> demands(resolutions.size());
  for (const Gap& gap : gaps) {
    if (gap.points.gap <= 0.0) continue;
    const DensityDecay decay = gap_resolution(gap, configuration, references_).decay;
    demands[gap.a].push_back({gap.points.parameter_a, decay.a});
    demands[gap.b].push_back({gap.points.parameter_b, decay.b});
  }
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    if (given_nodes(scene_, k) != automatic_nodes || demands[k].empty()) continue;
    resolutions[k] = nodes_for_gaps(demands[k], resolutions[k].n_nodes, scene_.solver.tolerance);
    resolutions[k].n_nodes = rounded_nodes(resolutions[k].n_nodes);
  }
  return resolutions;
}

References SuspensionSolver::references(const Resolutions& resolutions) const {
  References references;
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    references.push_back(take(*shelf_, scene_, k, resolutions[k]));
  }
  return references;
}

}  // namespace stokesbook
