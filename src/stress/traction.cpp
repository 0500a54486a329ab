#include "stress/traction.hpp"

#include <stdexcept>
#include <string>

#include "stress/stress.hpp"

namespace stokesbook {

using Eigen::Index;

ComplexVector boundary_traction(const StokesProblem& problem,
                                const std::vector<FlowDerivatives>& at_nodes) {
  const Index n = node_offsets(problem).back();
  if (static_cast<Index>(at_nodes.size()) != n) {
    throw std::invalid_argument("traction wants derivatives at " + std::to_string(n) +
                                " nodes, not at " + std::to_string(at_nodes.size()));
  }
  ComplexVector result(n);
  Index i = 0;
  for (const Component& component : problem.components) {
    for (const Complex normal : normals(component.curve)) {
      result[i] = traction(at_nodes[static_cast<std::size_t>(i)], normal, problem.viscosity);
      ++i;
    }
  }
  return result;
}

std::vector<Load> integrated_loads(const StokesProblem& problem, const ComplexVector& traction) {
  std::vector<Load> loads;
  Index first = 0;
  for (const Component& component : problem.components) {
    const Eigen::VectorXd w = weights(component.curve);
    Load load;
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
