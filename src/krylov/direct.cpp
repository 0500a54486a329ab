// Assembles the matrix of the whole reduced system (03.11) from layers and rigid motions, and
// solves by its LU factorisation (chapter 05, "Direct factorisation").
#include "krylov/direct.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Assembles L = -1/2 + D + N_0 between all nodes, in the order of the densities.
MatrixXd layer_of_all(const StokesProblem& problem, const LayerBlock& layer) {
  const std::vector<Index> offsets = node_offsets(problem);
  const std::size_t count = problem.components.size();
  MatrixXd matrix(2 * offsets.back(), 2 * offsets.back());
#pragma omp parallel for collapse(2) schedule(dynamic)
  for (std::size_t target = 0; target < count; ++target) {
    for (std::size_t source = 0; source < count; ++source) {
      const Component& own = problem.components[source];
      matrix.block(2 * offsets[target], 2 * offsets[source],
                   2 * problem.components[target].curve.size(), 2 * own.curve.size()) =
          target == source ? own_layer(own) : layer(problem.components[target].curve.x, source);
    }
  }
  return matrix;
}

// L + (C K - L K) Pi, one inner component after the other.
MatrixXd system_matrix(const StokesProblem& problem, const LayerBlock& layer) {
  const std::vector<Index> offsets = node_offsets(problem);
  const Closure closure(problem);
  MatrixXd matrix = layer_of_all(problem, layer);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& own = problem.components[k];
    if (!is_inner(own)) continue;
    const RigidModeMatrices rigid = rigid_mode_matrices(own.curve, own.centre);
    auto columns = matrix.middleCols(2 * offsets[k], 2 * own.curve.size());
    const MatrixXd closed = closed_modes(closure, rigid.modes, offsets[k], offsets.back());
    columns += (closed - columns * rigid.modes) * rigid.projection;
  }
  return matrix;
}

}  // namespace

DirectPreconditioner::DirectPreconditioner(const StokesProblem& problem, const LayerBlock& layer)
    : factors_(system_matrix(problem, layer)) {}

VectorXd DirectPreconditioner::operator()(const VectorXd& v) const {
  return factors_.solve(v);
}

}  // namespace stokesbook
