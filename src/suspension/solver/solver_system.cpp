// The linear system of a configuration, and what its solution means.
#include <algorithm>
#include <variant>

#include "double_layer/double_layer.hpp"
#include "krylov/direct.hpp"
#include "suspension/bodies/background_flow.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/solver/solver.hpp"
#include "suspension/solver/solver_checks.hpp"
#include "suspension/system/clusters.hpp"
#include "suspension/system/layer_blocks.hpp"
#include "suspension/system/preconditioner_choice.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// The inverse of a component's own block, or the reason why there is none.
std::shared_ptr<const Eigen::MatrixXd> inverse_block(const Scene& scene, std::size_t component,
                                                     const DiscretisedShape& discretised) {
  try {
    return discretised.inverse_block.get();
  } catch (const std::domain_error& error) {
    throw SolverError(
        component_of(scene, component).name() + ": " + error.what() +
        "; a gauge_length close to the size of a held component is a degenerate scale");
  }
}

// Its clusters, or the reason why there are none.
ClusterPreconditioner clusters_of(const StokesProblem& problem, const Configuration& configuration,
                                  const Discretisation& discretisation,
                                  const std::vector<PlacedCurve>& near) {
  try {
    return cluster_preconditioner(problem, configuration, discretisation, near);
  } catch (const std::domain_error& error) {
    throw SolverError("preconditioner by clusters: " + std::string(error.what()) +
                      "; set solver.preconditioner = \"block_diagonal\"");
  }
}

}  // namespace

StokesProblem SuspensionSolver::problem(const Instant& instant,
                                        const Discretisation& discretisation) const {
  const auto& [configuration, amplitude] = instant;
  StokesProblem problem{{}, scene_.viscosity, {}, scene_.gauge_length};
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    const Curve curve = place(discretisation[k]->curve, position, orientation);
    Component component{discretisation[k]->kind, curve, position, {}, 0.0, {}};
    const ComponentView source = component_of(scene_, k);
    if (source.kind == ComponentKind::free_body) {
      component.force = amplitude * source.body->force;
      component.torque = amplitude * source.body->torque;
    } else {
      component.velocity = amplitude * prescribed_velocity(source, curve, position);
      component.velocity.array() -= frame_velocity(amplitude);
    }
    problem.components.push_back(std::move(component));
  }
  if (is_bounded(problem)) return problem;
  const std::vector<Index> offsets = node_offsets(problem);
  problem.background.resize(offsets.back());
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    problem.background.segment(offsets[k], component.curve.size()) =
        amplitude * (component.kind == ComponentKind::free_body
                         ? strain_on(scene_.flow, component)
                         : background_velocity(scene_.flow, component.curve.x));
  }
  return problem;
}

// In a container that is moved as a whole, problems are those that it sees.
Complex SuspensionSolver::frame_velocity(double amplitude) const {
  const auto outer = std::ranges::find(scene_.walls, WallRole::outer, &Wall::role);
  if (outer == scene_.walls.end()) return 0.0;
  const auto* translating = std::get_if<TranslatingWall>(&outer->motion);
  return translating == nullptr ? 0.0 : amplitude * translating->velocity;
}

// Free bodies bear the solution's own loads: the scene's, and those of contact where there are any.
StokesProblem SuspensionSolver::loaded_problem(const Solution& solution,
                                               const Discretisation& discretisation) const {
  StokesProblem problem = this->problem(solution.instant, discretisation);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    Component& component = problem.components[k];
    if (component.kind != ComponentKind::free_body) continue;
    component.force = solution.loads[k].force;
    component.torque = solution.loads[k].torque;
  }
  return problem;
}

LinearSystem SuspensionSolver::linear_system(const Instant& instant,
                                             const Discretisation& discretisation) const {
  const Configuration& configuration = instant.configuration;
  return preconditioned(problem(instant, discretisation), configuration, gaps(configuration),
                        discretisation);
}

LinearSystem SuspensionSolver::preconditioned(const StokesProblem& problem,
                                              const Configuration& configuration,
                                              const std::vector<Gap>& gaps,
                                              const Discretisation& discretisation) const {
  const std::vector<PlacedCurve> near = near_curves(configuration, discretisation);
  LinearSystem discrete{problem, SuspensionOperator(problem, near, plan_)};
  switch (chosen_preconditioner(plan_, gaps, discretisation, separation())) {
    case PreconditionerKind::direct:
      discrete.precondition =
          DirectPreconditioner(problem, layer_blocks(problem, near, plan_.near_tolerance));
      discrete.is_factorised = true;
      return discrete;
    case PreconditionerKind::clusters:
      discrete.precondition = clusters_of(problem, configuration, discretisation, near);
      return discrete;
    case PreconditionerKind::none:
      return discrete;
    default:
      break;
  }
  std::vector<BlockDiagonalPreconditioner::Member> members;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    members.push_back({inverse_block(scene_, k, *discretisation[k]), configuration[k].orientation});
  }
  discrete.precondition = BlockDiagonalPreconditioner(std::move(members));
  return discrete;
}

LinearSystem SuspensionSolver::unpreconditioned(const StokesProblem& problem,
                                                const Configuration& configuration,
                                                const Discretisation& discretisation) const {
  return {problem, SuspensionOperator(problem, near_curves(configuration, discretisation), plan_)};
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
  auto discrete = std::make_shared<const LinearSystem>(
      preconditioned(problem, configuration, gaps, discretisation));
  return {instant, std::move(discretisation), std::move(discrete)};
}

Solution SuspensionSolver::completed(const System& system, GmresResult gmres) const {
  const double amplitude = system.instant.amplitude;
  Solution solution;
  solution.instant = system.instant;
  solution.discretisation = system.discretisation;
  solution.system = system.discrete;
  solution.gmres = std::move(gmres);
  solution.density = deinterleaved(solution.gmres.solution);
  const Completion completion = system.discrete->system.closure().complete(solution.density);
  solution.motions = completion.motions;
  solution.loads = completion.loads;
  solution.uniform_velocity = completion.uniform_velocity;
  for (std::size_t k = 0; k < system.discretisation.size(); ++k) {
    const ComponentView component = component_of(scene_, k);
    if (component.kind != ComponentKind::free_body) {
      const RigidMotion motion = prescribed_motion(component);
      solution.motions[k] = {amplitude * motion.velocity, amplitude * motion.omega};
    } else {
      const StokesProblem& problem = system.discrete->problem;
      RigidMotion carried{frame_velocity(amplitude), 0.0};
      if (!is_bounded(problem)) {
        carried = carried_by(scene_.flow, problem.components[k].centre);
        carried = {amplitude * carried.velocity, amplitude * carried.omega};
      }
      solution.motions[k].velocity += carried.velocity;
      solution.motions[k].omega += carried.omega;
    }
  }
  return solution;
}

}  // namespace stokesbook
