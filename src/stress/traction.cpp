// Computes the traction at the nodes (07.5), and integrates it to forces and torques.
#include "stress/traction.hpp"

#include "stress/stress.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

ComplexVector traction_on(const Curve& curve, std::span<const FlowDerivatives> at_nodes,
                          double viscosity) {
  ComplexVector result = normals(curve);
  for (Index j = 0; j < result.size(); ++j) {
    result[j] = traction(at_nodes[static_cast<std::size_t>(j)], result[j], viscosity);
  }
  return result;
}

ComplexVector boundary_traction(const StokesProblem& problem,
                                const std::vector<FlowDerivatives>& at_nodes) {
  const Index n = node_offsets(problem).back();
  require(std::ssize(at_nodes) == n, "the traction requires derivatives at all ", n, " nodes, got ",
          at_nodes.size());
  ComplexVector result(n);
  Index first = 0;
  for (const Component& component : problem.components) {
    const Index size = component.curve.size();
    const auto own = std::span(at_nodes).subspan(static_cast<std::size_t>(first));
    result.segment(first, size) = traction_on(component.curve, own, problem.viscosity);
    first += size;
  }
  return result;
}

std::vector<Load> integrated_loads(const StokesProblem& problem, const ComplexVector& traction) {
  std::vector<Load> loads;
  Index first = 0;
  for (const Component& component : problem.components) {
    const Eigen::VectorXd w = weights(component.curve);
    Load load;
    // F = sum w_j (sigma n)_j, L = sum w_j (x_j - c) x (sigma n)_j
    for (Index j = 0; j < w.size(); ++j) {
      const Complex force = w[j] * traction[first + j];
      load.force += force;
      load.torque += cross(component.curve.x[j] - component.centre, force);
    }
    first += w.size();
    loads.push_back(load);
  }
  return loads;
}

}  // namespace stokesbook
