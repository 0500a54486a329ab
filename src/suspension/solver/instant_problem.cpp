// Poses the boundary value problem of an instant, and reads motions and loads from the density that
// solves it (chapters 03 and 12).
#include "suspension/solver/instant_problem.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "double_layer/double_layer.hpp"
#include "suspension/bodies/background_flow.hpp"
#include "suspension/bodies/components.hpp"

namespace stokesbook {

using Eigen::Index;

Complex frame_velocity(const Scene& scene, double amplitude) {
  const auto outer = std::ranges::find(scene.walls, WallRole::outer, &Wall::role);
  if (outer == scene.walls.end()) return 0.0;
  const auto* translating = std::get_if<TranslatingWall>(&outer->motion);
  return translating == nullptr ? 0.0 : amplitude * translating->velocity;
}

StokesProblem instant_problem(const Scene& scene, const Instant& instant,
                              const Discretisation& discretisation) {
  const auto& [configuration, amplitude] = instant;
  StokesProblem problem{{}, scene.viscosity, {}, scene.gauge_length};
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    const Curve curve = place(discretisation[k]->curve, position, orientation);
    Component component{discretisation[k]->kind, curve, position, {}, 0.0, {}};
    const ComponentView source = component_of(scene, k);
    if (source.kind == ComponentKind::free_body) {
      component.force = amplitude * source.body->force;
      component.torque = amplitude * source.body->torque;
    } else {
      component.velocity = amplitude * prescribed_velocity(source, curve, position);
      component.velocity.array() -= frame_velocity(scene, amplitude);
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
                         ? strain_on(scene.flow, component)
                         : background_velocity(scene.flow, component.curve.x));
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

Solution complete_solution(const Scene& scene, const Instant& instant,
                           const Discretisation& discretisation,
                           std::shared_ptr<const LinearSystem> system, GmresResult gmres) {
  const double amplitude = instant.amplitude;
  Solution solution;
  solution.instant = instant;
  solution.discretisation = discretisation;
  solution.system = std::move(system);
  solution.gmres = std::move(gmres);
  solution.density = deinterleaved(solution.gmres.solution);
  const Completion completion = solution.system->system.closure().complete(solution.density);
  solution.motions = completion.motions;
  solution.loads = completion.loads;
  solution.uniform_velocity = completion.uniform_velocity;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    const ComponentView component = component_of(scene, k);
    if (component.kind != ComponentKind::free_body) {
      const RigidMotion motion = prescribed_motion(component);
      solution.motions[k] = {amplitude * motion.velocity, amplitude * motion.omega};
    } else {
      const StokesProblem& problem = solution.system->problem;
      RigidMotion carried{frame_velocity(scene, amplitude), 0.0};
      if (!is_bounded(problem)) {
        carried = carried_by(scene.flow, problem.components[k].centre);
        carried = {amplitude * carried.velocity, amplitude * carried.omega};
      }
      solution.motions[k].velocity += carried.velocity;
      solution.motions[k].omega += carried.omega;
    }
  }
  return solution;
}

}  // namespace stokesbook
