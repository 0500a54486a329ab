// Assembles and inverts the own blocks of components, and applies the inverses as a preconditioner,
// which solves for every component as if it were alone (05.10).
#include "krylov/block_diagonal.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include <Eigen/LU>

#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd own_layer(const Component& component) {
  // -1/2 + D, and N_0 (04.6) on an enclosing wall.
  MatrixXd layer = double_layer_matrix(component.curve);
  layer.diagonal().array() -= 0.5;
  if (!is_inner(component)) layer += null_space_matrix(component.curve);
  return layer;
}

MatrixXd closed_modes(const Closure& closure, const MatrixXd& modes, Index first, Index n) {
  MatrixXd closed(2 * n, modes.cols());
  for (Index mode = 0; mode < modes.cols(); ++mode) {
    ComplexVector density = ComplexVector::Zero(n);
    density.segment(first, modes.rows() / 2) = deinterleaved(modes.col(mode));
    closed.col(mode) = interleaved(closure.velocity(density));
  }
  return closed;
}

MatrixXd self_block(const Component& component, std::optional<double> gauge) {
  const Index n = component.curve.size();
  const MatrixXd layer = own_layer(component);
  if (!is_inner(component)) return layer;
  // The closure C of the component alone, in a fluid of this gauge, acts on the component as it
  // does among other components. The block is L (I - P) + C P = L + (C K - L K) Pi, P = K Pi.
  const RigidModeMatrices rigid = rigid_mode_matrices(component.curve, component.centre);
  const double own_gauge = std::sqrt(std::numbers::e) * rigid.radius;
  StokesProblem alone{{component}, 1.0, {}, gauge.value_or(own_gauge)};
  alone.components[0].velocity = ComplexVector::Zero(n);
  return layer +
         (closed_modes(Closure(alone), rigid.modes, 0, n) - layer * rigid.modes) * rigid.projection;
}

MatrixXd invert_block(const MatrixXd& block) {
  const Eigen::PartialPivLU<MatrixXd> lu(block);
  const double rcond = lu.rcond();
  require<std::domain_error>(
      rcond > 1e-14, "a diagonal block is singular (reciprocal condition number ", rcond, ")");
  return lu.inverse();
}

BlockDiagonalPreconditioner::BlockDiagonalPreconditioner(std::vector<Member> members)
    : members_(std::move(members)) {
  std::map<const MatrixXd*, std::size_t> group_of;
  Index first = 0;
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const MatrixXd* inverse = members_[k].inverse.get();
    offsets_.push_back(first);
    first += inverse ? inverse->rows() / 2 : members_[k].n_nodes;
    if (!inverse) continue;
    const auto [entry, is_new] = group_of.try_emplace(inverse, users_.size());
    if (is_new) users_.emplace_back();
    users_[entry->second].push_back(k);
  }
}

VectorXd BlockDiagonalPreconditioner::operator()(const VectorXd& v) const {
  VectorXd result = -2.0 * v;  // the result of members without an inverse
  // There are few blocks, of different sizes; threads share the columns of one block. A column is
  // the vector of a component, turned into the frame of the block and back (05.11).
  constexpr Index columns_at_once = 16;
  for (const std::vector<std::size_t>& users : users_) {
    const MatrixXd& inverse = *members_[users.front()].inverse;
    const Index rows = inverse.rows();
    const auto count = static_cast<Index>(users.size());
#pragma omp parallel for schedule(static)
    for (Index first = 0; first < count; first += columns_at_once) {
      const Index columns = std::min(columns_at_once, count - first);
      MatrixXd turned(rows, columns);
      for (Index c = 0; c < columns; ++c) {
        const std::size_t k = users[static_cast<std::size_t>(first + c)];
        turned.col(c) = interleaved(std::polar(1.0, -members_[k].orientation) *
                                    deinterleaved(v.segment(2 * offsets_[k], rows)));
      }
      const MatrixXd solved = inverse * turned;
      for (Index c = 0; c < columns; ++c) {
        const std::size_t k = users[static_cast<std::size_t>(first + c)];
        result.segment(2 * offsets_[k], rows) =
            interleaved(std::polar(1.0, members_[k].orientation) * deinterleaved(solved.col(c)));
      }
    }
  }
  return result;
}

}  // namespace stokesbook
