#include "stress/dissipation.hpp"

#include "stress/stress.hpp"
#include "stress/traction.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

double power(const Curve& curve, const ComplexVector& velocity, const ComplexVector& traction) {
  return weights(curve).dot(velocity.conjugate().cwiseProduct(traction).real());
}

}  // namespace

std::vector<double> boundary_power(const SolvedFlow& flow, const ComplexVector& traction) {
  const ComplexVector velocity = flow.boundary_velocity();
  std::vector<double> powers;
  Index first = 0;
  for (const Component& component : flow.problem().components) {
    const Index n = component.curve.size();
    powers.push_back(
        power(component.curve, velocity.segment(first, n), traction.segment(first, n)));
    first += n;
  }
  return powers;
}

std::vector<double> power_of_loads(const SolvedFlow& flow) {
  const ComplexVector velocity = flow.boundary_velocity();
  const std::vector<Component>& components = flow.problem().components;
  std::vector<double> powers;
  Index first = 0;
  for (std::size_t k = 0; k < components.size(); ++k) {
    const Curve& curve = components[k].curve;
    const ComplexVector own = velocity.segment(first, curve.size());
    first += curve.size();
    const RigidModes modes(curve, components[k].centre);
    const RigidMotion rigid = modes.project(own);
    const ComplexVector rest = own - modes.at_nodes(rigid);
    const Load& load = flow.completion().loads[k];
    double sum = dot(rigid.velocity, load.force) + rigid.omega * load.torque;
    constexpr double rounding = 1e-13;
    if (rest.cwiseAbs().maxCoeff() > rounding * own.cwiseAbs().maxCoeff()) {
      const double mu = flow.problem().viscosity;
      sum += power(curve, rest, traction_on(curve, flow.derivatives(curve.x), mu));
    }
    powers.push_back(sum);
  }
  return powers;
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
