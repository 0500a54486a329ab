#include "suspension/solver.hpp"

#include <algorithm>
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"
#include "record/number_text.hpp"
#include "suspension/background_flow.hpp"
#include "suspension/component_data.hpp"
#include "suspension/operator.hpp"
#include "suspension/refusal.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

ComplexVector all_nodes(const StokesProblem& problem) {
  const std::vector<Index> offsets = node_offsets(problem);
  ComplexVector nodes(offsets.back());
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    nodes.segment(offsets[k], offsets[k + 1] - offsets[k]) = problem.components[k].curve.x;
  }
  return nodes;
}

// Radius about their centroid of all components with prescribed velocity; 0 when there is none.
double prescribed_extent(const StokesProblem& problem) {
  std::vector<Complex> nodes;
  for (const Component& component : problem.components) {
    if (component.kind != ComponentKind::prescribed) continue;
    nodes.insert(nodes.end(), component.curve.x.begin(), component.curve.x.end());
  }
  const Eigen::Map<const ComplexVector> x(nodes.data(), static_cast<Index>(nodes.size()));
  return nodes.empty() ? 0.0 : (x.array() - x.mean()).abs().maxCoeff();
}

// A component that is alone has none: only the flow near it asks for one.
std::shared_ptr<const CauchyCurve> cauchy_of(const Reference& reference) {
  return reference.cauchy ? reference.cauchy : std::make_shared<const CauchyCurve>(reference.curve);
}

}  // namespace

SuspensionSolver::SuspensionSolver(const Scene& scene) : scene_(scene), plan_(make_plan(scene)) {
  const bool bounded = plan_.null_space_fix;
  const bool interpolate = scene.solver.near_singular == NearSingular::interpolation;
  ReferenceShelf shelf({plan_.near_correction,
                        interpolate ? std::optional(scene.solver.tolerance) : std::nullopt,
                        plan_.block_diagonal, bounded ? std::nullopt : scene.gauge_length});
  const auto add = [&](const auto& component) {
    references_.push_back(shelf.get(component.shape, component.n_nodes, kind_of(component)));
  };
  try {
    std::for_each(scene_.bodies.begin(), scene_.bodies.end(), add);
    std::for_each(scene_.walls.begin(), scene_.walls.end(), add);
  } catch (const std::domain_error& error) {
    throw NumericsRefused(
        component_name(scene_, references_.size()) + ": " + error.what() +
        "; a gauge_length close to the size of a held component is a degenerate scale");
  }
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

StokesProblem SuspensionSolver::problem(const Configuration& configuration, double drive) const {
  StokesProblem problem{{}, scene_.viscosity, {}, scene_.gauge_length};
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    const Curve curve = place(references_[k]->curve, position, orientation);
    Component component{references_[k]->kind, curve, position, {}, 0.0, {}};
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
    problem.background = drive * background_velocity(scene_.flow, all_nodes(problem));
  }
  return problem;
}

std::vector<PlacedCurve> SuspensionSolver::placed(const Configuration& configuration) const {
  std::vector<PlacedCurve> placed;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Reference& reference = *references_[k];
    CloseScheme scheme = cauchy_of(reference);
    if (reference.interpolation) scheme = reference.interpolation;
    placed.push_back({scheme, configuration[k].position, configuration[k].orientation});
  }
  return placed;
}

BlockDiagonalPreconditioner SuspensionSolver::preconditioner(
    const Configuration& configuration) const {
  std::vector<BlockDiagonalPreconditioner::Member> members;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    members.push_back({references_[k]->inverse_block, configuration[k].orientation});
  }
  return BlockDiagonalPreconditioner(std::move(members));
}

void SuspensionSolver::refuse_unresolved(const Configuration& configuration) const {
  refuse_bad_geometry(configuration,
                      find_gaps(configuration, references_, scene_.solver.tolerance));
}

void SuspensionSolver::refuse_bad_geometry(const Configuration& configuration,
                                           const std::vector<Gap>& gaps) const {
  const std::string refusal = geometry_refusal(scene_, gaps, configuration, references_);
  if (!refusal.empty()) throw NumericsRefused(refusal);
}

void SuspensionSolver::refuse_bad_data(const StokesProblem& problem) const {
  if (is_bounded(problem)) {
    const double flux = net_flux(problem);
    if (std::abs(flux) > scene_.solver.tolerance * flux_scale(problem)) {
      throw NumericsRefused(
          "the walls' velocities drive a net flux of " + short_number(flux) +
          " out of the enclosed fluid, which is incompressible: make them balance");
    }
    return;
  }
  const double extent = prescribed_extent(problem);
  if (scene_.gauge_length && extent > 0.5 * *scene_.gauge_length) {
    throw NumericsRefused("flow.gauge_length = " + short_number(*scene_.gauge_length) +
                          " is not large against the held components, which reach " +
                          short_number(extent) +
                          " from their centre: near that size the problem is singular (Stokes' "
                          "paradox); give at least " +
                          short_number(2.0 * extent) + ", or leave it out for zero net force");
  }
  double scale = 0.0;
  for (const Component& component : problem.components) scale += std::abs(component.force);
  const Complex force = total_given_force(problem);
  if (extent == 0.0 && !scene_.gauge_length && std::abs(force) > 1e-12 * scale) {
    throw NumericsRefused(
        "the loads have a net force of (" + short_number(force.real()) + ", " +
        short_number(force.imag()) +
        ") in an unbounded plane, where velocities grow like the logarithm of the distance "
        "(Stokes' "
        "paradox): balance the forces, enclose the fluid, or give flow.gauge_length");
  }
}

void SuspensionSolver::estimate_error(Solution& solution, const StokesProblem& problem,
                                      const ComplexVector& rest) const {
  const double tolerance = scene_.solver.tolerance;
  solution.error_estimate = 10.0 * solution.gmres.residual;
  if (solution.velocity_scale == 0.0) return;
  Index first = 0;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Index n = problem.components[k].curve.size();
    const TailEstimate tail = tail_estimate(rest.segment(first, n), solution.velocity_scale);
    first += n;
    if (tail.error > tolerance) {
      throw NumericsRefused(density_refusal(scene_, k, n, tail, solution.gaps));
    }
    solution.error_estimate =
        std::max({solution.error_estimate, tail.error, references_[k]->rigid_motion_residual});
  }
}

Solution SuspensionSolver::solve(const Configuration& configuration, double drive) const {
  Solution solution;
  solution.gaps = find_gaps(configuration, references_, scene_.solver.tolerance);
  refuse_bad_geometry(configuration, solution.gaps);
  const StokesProblem problem = this->problem(configuration, drive);
  refuse_bad_data(problem);

  const auto near_curves =
      plan_.near_correction ? placed(configuration) : std::vector<PlacedCurve>{};
  const SuspensionOperator system(problem, near_curves, plan_);
  const LinearMap apply = [&](const VectorXd& v) -> VectorXd {
    const ComplexVector velocity = system(deinterleaved(v));
    return interleaved(velocity);
  };
  LinearMap precondition;
  if (plan_.block_diagonal) precondition = preconditioner(configuration);
  const ComplexVector rhs = system.closure().right_hand_side();
  solution.velocity_scale = rhs.cwiseAbs().maxCoeff();
  try {
    solution.gmres = gmres(apply, precondition, interleaved(rhs),
                           {plan_.gmres_tolerance, scene_.solver.gmres_max_iterations});
  } catch (const std::domain_error& error) {
    throw NumericsRefused(error.what());
  }
  if (!solution.gmres.converged) {
    throw NumericsRefused("GMRES stopped at a relative residual of " +
                          short_number(solution.gmres.history.back()) + " after " +
                          std::to_string(solution.gmres.iterations) + " iterations, asked " +
                          short_number(plan_.gmres_tolerance) +
                          ": raise solver.gmres_max_iterations or solver.tolerance");
  }
  solution.density = deinterleaved(solution.gmres.solution);
  estimate_error(solution, problem, system.closure().without_rigid_part(solution.density));

  const Completion completion = system.closure().complete(solution.density);
  solution.motions = completion.motions;
  solution.loads = completion.loads;
  solution.uniform_velocity = completion.uniform_velocity;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    if (k >= scene_.bodies.size()) {
      const RigidMotion motion = rigid_motion(scene_.walls[k - scene_.bodies.size()].motion);
      solution.motions[k] = {drive * motion.velocity, drive * motion.omega};
    } else if (const Body& body = scene_.bodies[k]; body.held) {
      solution.motions[k] = {drive * body.velocity, drive * body.omega};
    }
  }
  return solution;
}

ComplexVector SuspensionSolver::velocity(const Configuration& configuration,
                                         const Solution& solution, const ComplexVector& points,
                                         double drive) const {
  const StokesProblem problem = this->problem(configuration, drive);
  const SuspensionOperator system(problem, {}, plan_);
  const auto near_curves = scene_.solver.near_singular == NearSingular::off
                               ? std::vector<PlacedCurve>{}
                               : placed(configuration);
  ComplexVector velocity =
      system.velocity(solution.density, points, near_curves, plan_.near_tolerance);
  if (!is_bounded(problem)) velocity += drive * background_velocity(scene_.flow, points);
  return velocity;
}

SolvedFlow SuspensionSolver::disturbance(const Configuration& configuration,
                                         const Solution& solution, double drive) const {
  std::vector<PlacedCurve> curves;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    curves.push_back({cauchy_of(*references_[k]), position, orientation});
  }
  return {problem(configuration, drive), std::move(curves), solution.density, plan_.near_tolerance};
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
  const double tolerance = scene_.solver.tolerance;
  std::vector<int> nodes;
  for (const auto& reference : references_) {
    nodes.push_back(nodes_for_shape(*reference, tolerance, 16));
  }
  for (const Gap& gap : find_gaps(configuration, references_, tolerance)) {
    if (gap.points.gap <= 0.0) continue;
    const DensityDecay decay = gap_resolution(gap, configuration, references_).decay;
    nodes[gap.a] = std::max(nodes[gap.a], stokesbook::recommended_nodes(decay.a, tolerance));
    nodes[gap.b] = std::max(nodes[gap.b], stokesbook::recommended_nodes(decay.b, tolerance));
  }
  return nodes;
}

}  // namespace stokesbook
