// Poses the boundary value problem of an instant, and reads motions and loads from the density that
// solves it (chapters 03 and 12).
#include "suspension/solver/solution.hpp"

#include <utility>
#include <variant>

#include "double_layer/double_layer.hpp"
#include "suspension/bodies/background_flow.hpp"
#include "suspension/bodies/boundary_velocity.hpp"
#include "suspension/bodies/components.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

RigidMotion scaled(double factor, const RigidMotion& motion) {
  return {factor * motion.velocity, factor * motion.omega};
}

}  // namespace

std::vector<RigidMotion> path_motions(const Solution& solution) {
  std::vector<RigidMotion> motions = solution.motions;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    motions[k].velocity += solution.instant.path_velocity(k);
  }
  return motions;
}

Complex frame_velocity(const Scene& scene, const Forcing& forcing) {
  const Wall* outer = only_wall(scene, WallRole::outer);
  if (outer == nullptr) return 0.0;
  const auto* translating = std::get_if<TranslatingWall>(&outer->motion);
  if (translating == nullptr) return 0.0;
  const auto number = static_cast<std::size_t>(outer - scene.walls.data());
  return forcing.motions[scene.bodies.size() + number] * translating->velocity;
}

StokesProblem instant_problem(const Scene& scene, const Instant& instant,
                              const Discretisation& discretisation) {
  const auto& [configuration, forcing, cell, shifts] = instant;
  require(
      forcing.motions.size() == configuration.size() && forcing.loads.size() == scene.bodies.size(),
      "an instant lacks its forcing: make it by SuspensionSolver::instant()");
  StokesProblem problem{{}, scene.viscosity, {}, scene.gauge_length, cell};
  if (cell && cell->pressure_gradient) *problem.cell->pressure_gradient *= forcing.flow;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    const Curve curve = place(discretisation[k]->curve, position, orientation);
    Component component{discretisation[k]->kind, curve, position, {}, 0.0, {}};
    const ComponentView source = component_of(scene, k);
    component.velocity =
        forcing.motions[k] * boundary_velocity(source, *discretisation[k], curve, configuration[k]);
    if (source.kind == ComponentKind::free_body) {
      component.force = forcing.loads[k].force;
      component.torque = forcing.loads[k].torque;
    } else {
      component.velocity.array() -= frame_velocity(scene, forcing) + instant.path_velocity(k);
    }
    problem.components.push_back(std::move(component));
  }
  if (is_bounded(problem)) return problem;
  const BackgroundFlow flow = undisturbed_flow(scene);
  const std::vector<Index> offsets = node_offsets(problem);
  problem.background.resize(offsets.back());
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    problem.background.segment(offsets[k], component.curve.size()) =
        forcing.flow * (component.kind == ComponentKind::free_body
                            ? straining_velocity(flow, component)
                            : background_velocity(flow, component.curve.x));
  }
  return problem;
}

StokesProblem loaded_problem(const Scene& scene, const Solution& solution,
                             const Discretisation& discretisation) {
  StokesProblem problem = instant_problem(scene, solution.instant, discretisation);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    Component& component = problem.components[k];
    if (component.kind != ComponentKind::free_body) continue;
    component.force = solution.loads[k].force;
    component.torque = solution.loads[k].torque;
  }
  return problem;
}

Solution complete_solution(const Scene& scene, Solution solution, GmresResult gmres) {
  const Forcing& forcing = solution.instant.forcing;
  const Closure& closure = solution.system->system.closure();
  solution.gmres = std::move(gmres);
  solution.density = deinterleaved(solution.gmres.solution);
  const Completion completion = closure.complete(solution.density);
  solution.motions = completion.motions;
  solution.loads = completion.loads;
  solution.uniform_velocity = completion.uniform_velocity;
  const BackgroundFlow flow = undisturbed_flow(scene);
  for (std::size_t k = 0; k < solution.motions.size(); ++k) {
    const ComponentView component = component_of(scene, k);
    if (component.kind != ComponentKind::free_body) {
      solution.motions[k] = scaled(forcing.motions[k], prescribed_motion(component));
      solution.motions[k].velocity -= solution.instant.path_velocity(k);
      continue;
    }
    // The problem leaves out the rigid motion of the flow at the body, and of the container.
    const Complex centre = closure.problem().components[k].centre;
    const RigidMotion carried = is_bounded(closure.problem())
                                    ? RigidMotion{frame_velocity(scene, forcing)}
                                    : scaled(forcing.flow, background_rigid_motion(flow, centre));
    solution.motions[k].velocity += carried.velocity;
    solution.motions[k].omega += carried.omega;
  }
  return solution;
}

}  // namespace stokesbook
