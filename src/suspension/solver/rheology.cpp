// Computes the rheology of a solution: dissipation (07.11), stresslets (07.14), the torque ratio of
// a Couette cell, and the order parameter of long bodies (page Scenes, section "A Couette cell").
#include "suspension/solver/rheology.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scene/scene.hpp"
#include "stress/dissipation.hpp"
#include "stress/stresslet.hpp"
#include "suspension/bodies/background_flow.hpp"
#include "suspension/solver/cell_rheology.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Returns the torque of a Couette cell's inner wall.
double inner_torque(const Scene& scene, const Solution& solution) {
  const auto number = only_wall(scene, WallRole::inner) - scene.walls.data();
  return solution.loads[scene.bodies.size() + static_cast<std::size_t>(number)].torque;
}

double torque_without_bodies(Scene scene) {
  scene.bodies.clear();
  for (Wall& wall : scene.walls) wall.amplitude = {};
  const SuspensionSolver solver(scene);
  return inner_torque(scene, solver.solve(solver.start()));
}

// Returns the factor of the rotation of a Couette cell's walls, which have the same factor.
double rotation_factor(const Scene& scene, const Forcing& forcing) {
  const auto is_rotating = [](const Wall& wall) {
    const auto* rotating = std::get_if<RotatingWall>(&wall.motion);
    return rotating != nullptr && rotating->omega != 0.0;
  };
  const auto number = std::ranges::find_if(scene.walls, is_rotating) - scene.walls.begin();
  return forcing.motions[scene.bodies.size() + static_cast<std::size_t>(number)];
}

bool deforms(const Wall& wall) {
  return !std::holds_alternative<FixedWall>(wall.motion) &&
         !std::holds_alternative<RotatingWall>(wall.motion) &&
         !std::holds_alternative<TranslatingWall>(wall.motion);
}

// Returns whether a flow, or a term of a sum, is of one of some kinds.
template <class... Kinds>
bool contains(const BackgroundFlow& flow) {
  if (const auto* sum = std::get_if<SumFlow>(&flow)) {
    return std::ranges::any_of(sum->terms, contains<Kinds...>);
  }
  return (std::holds_alternative<Kinds>(flow) || ...);
}

bool is_sheared(const BackgroundFlow& flow) {
  return contains<ShearFlow, ExtensionalFlow, LinearFlow>(flow) && !contains<TaylorGreenFlow>(flow);
}

// Returns whether the net force is zero, so that the disturbance and its dissipation decay far
// away. If a gauge length is given, the loads of held bodies and walls have a net force in general.
bool forces_balance(const StokesProblem& problem) {
  if (!problem.gauge_length) return true;
  const bool all_free = std::ranges::all_of(problem.components, [](const Component& component) {
    return component.kind == ComponentKind::free_body;
  });
  return all_free && !has_net_force(problem);
}

std::vector<Complex> stresslets_of(const StokesProblem& problem, const ComplexVector& density) {
  std::vector<Complex> stresslets;
  Index first = 0;
  for (const Component& component : problem.components) {
    const Index n = component.curve.size();
    stresslets.push_back(
        body_stresslet(component.curve, density.segment(first, n), problem.viscosity));
    first += n;
  }
  return stresslets;
}

}  // namespace

std::optional<double> long_axis(const Curve& curve) {
  const double h = 2.0 * std::numbers::pi / static_cast<double>(curve.size());
  // Green's theorem gives int f dA = 1/(2i) oint F dz for f = dF / d conj(z).
  const auto integral = [&](const auto& primitive) {
    Complex sum{};
    for (Index j = 0; j < curve.size(); ++j) sum += primitive(curve.x[j]) * curve.dx[j];
    return h / (2.0 * imaginary) * sum;
  };
  const Complex centroid = area_centroid(curve);
  // int z^2 dA and int |z|^2 dA about the centroid.
  const Complex moment =
      integral([&](Complex z) { return (z - centroid) * std::norm(z - centroid); });
  const Complex size =
      integral([&](Complex z) { return 0.5 * std::conj(z - centroid) * std::norm(z - centroid); });
  if (std::abs(moment) <= 1e-6 * std::abs(size)) return {};
  return 0.5 * std::arg(moment);
}

Rheometer::Rheometer(const SuspensionSolver& solver) : solver_(solver) {
  const Scene& scene = solver.scene();
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    long_axes_.push_back(long_axis(solver.discretisation()[k]->curve));
  }
  if (is_couette_cell(scene)) empty_torque_ = torque_without_bodies(scene);
}

double Rheometer::order_parameter(const Configuration& configuration) const {
  const Scene& scene = solver_.scene();
  if (!empty_torque_ && (is_enclosed(scene) || !is_sheared(scene.flow))) {
    return Rheology::undefined;
  }
  double sum = 0.0, count = 0.0;
  for (std::size_t k = 0; k < long_axes_.size(); ++k) {
    if (!long_axes_[k]) continue;
    double flow = 0.0;
    if (empty_torque_) {
      const Complex centre = only_wall(scene, WallRole::outer)->position;
      flow = std::arg(imaginary * (configuration[k].position - centre));
    }
    // cos 2(theta - theta_f) with the direction theta_f of the flow.
    sum += std::cos(2.0 * (configuration[k].orientation + *long_axes_[k] - flow));
    count += 1.0;
  }
  return count > 0.0 ? sum / count : Rheology::undefined;
}

double Rheometer::excess_dissipation(const Solution& solution,
                                     const std::vector<Complex>& stresslets) const {
  const auto& [configuration, forcing, cell, shifts] = solution.instant;
  const double amplitude = forcing.flow;
  const Scene& scene = solver_.scene();
  if (contains<TaylorGreenFlow>(scene.flow) || std::ranges::any_of(scene.walls, deforms)) {
    return Rheology::undefined;
  }
  // The sum of E:S_k (07.16), F_k . (U_k - u_inf(c_k)) and L_k (omega_k - Omega_inf). In a cell,
  // whose forces need not balance, u_inf includes a mean velocity that is a result.
  const BackgroundFlow flow = undisturbed_flow(scene);
  const Complex mean = cell ? solution.uniform_velocity : Complex{};
  double power = 0.0;
  for (std::size_t k = 0; k < stresslets.size(); ++k) {
    const Complex centre = configuration[k].position;
    const auto [stream, rotation] = background_rigid_motion(flow, centre);
    const Complex strain = background_derivatives(scene.flow, centre).strain;
    const auto& [velocity, omega] = solution.motions[k];
    const auto& [force, torque] = solution.loads[k];
    power += dot(amplitude * strain, stresslets[k]) +
             dot(force, velocity - amplitude * stream - mean) +
             torque * (omega - amplitude * rotation);
  }
  return power;
}

Rheology Rheometer::operator()(const Solution& solution,
                               const std::vector<ContactForce>& contacts) const {
  const Scene& scene = solver_.scene();
  Rheology rheology;
  rheology.order_parameter = order_parameter(solution.instant.configuration);
  // Only the power of walls that deform requires tractions, and only tractions require close
  // evaluation.
  const SolvedFlow flow =
      std::ranges::any_of(scene.walls, deforms)
          ? solver_.disturbance(solution)
          : SolvedFlow(solver_.problem(solution.instant, solution.discretisation), {},
                       solution.density);
  if (is_bounded(flow.problem())) {
    const std::vector<double> powers = power_of_loads(flow);
    rheology.dissipation = std::accumulate(powers.begin(), powers.end(), 0.0);
  } else {
    const std::vector<Complex> stresslets = stresslets_of(flow.problem(), flow.density());
    rheology.stresslet = std::accumulate(stresslets.begin(), stresslets.end(), Complex{});
    if (forces_balance(flow.problem())) {
      rheology.dissipation = excess_dissipation(solution, stresslets);
    }
    if (scene.cell) rheology.cell = cell_rheology(solver_, solution, rheology.stresslet, contacts);
  }
  if (!std::isnan(rheology.dissipation)) {
    rheology.dissipation += slip_power(flow.problem(), [&](const ComplexVector& nodes) {
      return solver_.derivatives(solution, nodes);
    });
  }
  if (has_free_uniform_velocity(flow.problem())) {
    rheology.uniform_velocity = solution.uniform_velocity;
  }
  if (empty_torque_) {
    const double factor = rotation_factor(scene, solution.instant.forcing);
    if (factor != 0.0) {
      rheology.torque_ratio = inner_torque(scene, solution) / (factor * *empty_torque_);
    }
  }
  return rheology;
}

}  // namespace stokesbook
