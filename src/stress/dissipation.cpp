// Computes the power that boundaries put into the fluid, from tractions and from loads, and the
// dissipation in the fluid (07.11).
#include "stress/dissipation.hpp"

#include <optional>

#include "stress/stress.hpp"
#include "stress/traction.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Integrates u . sigma n over a curve by the trapezoid rule.
double power(const Curve& curve, const ComplexVector& velocity, const ComplexVector& traction) {
  return weights(curve).dot(velocity.conjugate().cwiseProduct(traction).real());
}

// Subtracts the rigid motion from the velocity at the nodes of a wall. Returns nothing if the
// difference is due to the rounding of the nodes' positions, which grows with their distance from
// the origin.
std::optional<ComplexVector> deformation(const Curve& curve, const RigidModes& modes,
                                         const RigidMotion& rigid, const ComplexVector& velocity) {
  ComplexVector difference = velocity - modes.at_nodes(rigid);
  constexpr double rounding = 1e-13;
  const double distance = curve.x.cwiseAbs().maxCoeff() / modes.gyration_radius();
  const double largest = velocity.cwiseAbs().maxCoeff();
  if (difference.cwiseAbs().maxCoeff() <= rounding * (1.0 + distance) * largest) return {};
  return difference;
}

}  // namespace

std::vector<double> boundary_power(const SolvedFlow& flow, const ComplexVector& traction) {
  const std::vector<Component>& components = flow.problem().components;
  std::vector<double> powers;
  Index first = 0;
  for (std::size_t k = 0; k < components.size(); ++k) {
    const Component& component = components[k];
    const Curve& curve = component.curve;
    ComplexVector velocity = component.velocity;
    if (component.kind == ComponentKind::free_body) {
      const ComplexVector rigid =
          RigidModes(curve, component.centre).at_nodes(flow.completion().motions[k]);
      velocity = has_slip(component) ? ComplexVector(rigid + velocity) : rigid;
    }
    powers.push_back(power(curve, velocity, traction.segment(first, curve.size())));
    first += curve.size();
  }
  return powers;
}

std::vector<double> power_of_loads(const SolvedFlow& flow) {
  const StokesProblem& problem = flow.problem();
  std::vector<double> powers;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    const Load& load = flow.completion().loads[k];
    // U . F + omega L
    const auto power_of = [&](const RigidMotion& motion) {
      return dot(motion.velocity, load.force) + motion.omega * load.torque;
    };
    if (component.kind == ComponentKind::free_body) {
      powers.push_back(power_of(flow.completion().motions[k]));
      continue;
    }
    const Curve& curve = component.curve;
    const RigidModes modes(curve, component.centre);
    const RigidMotion rigid = modes.project(component.velocity);
    double sum = power_of(rigid);
    if (const auto deformed = deformation(curve, modes, rigid, component.velocity)) {
      sum +=
          power(curve, *deformed, traction_on(curve, flow.derivatives(curve.x), problem.viscosity));
    }
    powers.push_back(sum);
  }
  return powers;
}

double slip_power(
    const StokesProblem& problem,
    const std::function<std::vector<FlowDerivatives>(const ComplexVector&)>& derivatives) {
  std::vector<Curve> curves;
  std::vector<const ComplexVector*> slips;
  for (const Component& component : problem.components) {
    if (!has_slip(component)) continue;
    curves.push_back(component.curve);
    slips.push_back(&component.velocity);
  }
  if (curves.empty()) return 0.0;
  const std::vector<FlowDerivatives> at_nodes = derivatives(all_nodes(curves));
  double sum = 0.0;
  auto first = at_nodes.begin();
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const auto last = first + curves[k].size();
    sum += power(curves[k], *slips[k], traction_on(curves[k], {first, last}, problem.viscosity));
    first = last;
  }
  return sum;
}

double volume_dissipation(const FluidQuadrature& rule,
                          const std::vector<FlowDerivatives>& at_points, double mu) {
  double sum = 0.0;
  for (std::size_t i = 0; i < at_points.size(); ++i) {
    sum += rule.weights[static_cast<Index>(i)] * dissipation_density(at_points[i], mu);
  }
  return sum;
}

}  // namespace stokesbook
