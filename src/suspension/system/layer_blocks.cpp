// Assembles the double layer (02.6) of one component at the nodes of another, for preconditioners;
// at near nodes a scheme of close evaluation replaces the trapezoid rule (06.17).
#include "suspension/system/layer_blocks.hpp"

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "near_singular/near_field.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// Assembles the double layer of a curve at targets: rows of near targets by the scheme of close
// evaluation, all others by the trapezoid rule.
MatrixXd layer_matrix(const Curve& source, const PlacedCurve* placed, const ComplexVector& targets,
                      double tolerance) {
  MatrixXd matrix = StressletSum({source}).matrix(targets);
  if (placed == nullptr) return matrix;
  const double reach = near_reach(source, tolerance);
  std::vector<Index> near;
  for (Index i = 0; i < targets.size(); ++i) {
    if ((source.x.array() - targets[i]).abs2().minCoeff() < reach * reach &&
        is_near(source, targets[i], tolerance)) {
      near.push_back(i);
    }
  }
  if (near.empty()) return matrix;
  // Rows of the scheme are in the frame of the curve: R rows R^T in the plane, with the rotation R.
  const Complex turn = std::polar(1.0, placed->orientation);
  const ComplexVector local = (targets(near).array() - placed->position) / turn;
  const MatrixXd rows =
      std::visit([&](const auto& scheme) { return scheme->velocity_rows(local); }, placed->scheme);
  Eigen::Matrix2d rotation;
  rotation << turn.real(), -turn.imag(), turn.imag(), turn.real();
  for (std::size_t k = 0; k < near.size(); ++k) {
    for (Index j = 0; j < source.size(); ++j) {
      matrix.block<2, 2>(2 * near[k], 2 * j) =
          rotation * rows.block<2, 2>(2 * static_cast<Index>(k), 2 * j) * rotation.transpose();
    }
  }
  return matrix;
}

}  // namespace

LayerBlock layer_blocks(const StokesProblem& problem, const std::vector<PlacedCurve>& placed,
                        double tolerance) {
  return [&, tolerance](std::size_t target, std::size_t source) {
    return layer_matrix(problem.components[source].curve,
                        placed.empty() ? nullptr : &placed[source],
                        problem.components[target].curve.x, tolerance);
  };
}

}  // namespace stokesbook
