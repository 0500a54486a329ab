// Applies the operator (12.1) of one configuration to a density, without a matrix. Each line adds
// the result of one chapter.
#include "suspension/system/operator.hpp"

#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

std::variant<StressletSum, FastSum> make_sum(const StokesProblem& problem,
                                             const std::vector<Curve>& curves, const Plan& plan) {
  const Index n = node_offsets(problem).back();
  switch (plan.sum_method(n)) {
    case SumMethod::stored:
      return StressletSum(curves, KernelStorage::stored);
    case SumMethod::streamed:
      return StressletSum(curves, KernelStorage::streamed);
    case SumMethod::fast:
      break;
  }
  return FastSum(problem, plan.sum_tolerance);
}

}  // namespace

SuspensionOperator::SuspensionOperator(const StokesProblem& problem,
                                       const std::vector<PlacedCurve>& placed, const Plan& plan)
    : curves_(curves_of(problem)),
      offsets_(node_offsets(problem)),
      closure_(problem),
      sum_(make_sum(problem, curves_, plan)) {
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    if (problem.components[k].kind == ComponentKind::enclosing_wall) enclosing_wall_ = k;
  }
  if (!placed.empty()) {
    near_.emplace(placed, all_nodes(curves_), Targets::own_nodes,
                  NearSettings{plan.near_tolerance});
  }
}

// The terms of (12.1), in this order: the sum D and the singularities of the loads, the jump -1/2,
// the smooth velocities of the closure, near corrections (06.17), diagonals (02.9), N_0 (04.6).
// [operator]
ComplexVector SuspensionOperator::operator()(const ComplexVector& density) const {
  const ComplexVector rest = closure_.without_rigid_part(density);
  ComplexVector velocity = plain_velocity(rest, closure_.density_loads(density)) - 0.5 * rest +
                           closure_.smooth_velocity(density);
  if (near_) velocity += (*near_)(rest);
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    velocity.segment(offsets_[k], curves_[k].size()) +=
        diagonal_velocity(curves_[k], rest.segment(offsets_[k], curves_[k].size()));
  }
  if (enclosing_wall_) {
    const Curve& wall = curves_[*enclosing_wall_];
    const Index first = offsets_[*enclosing_wall_];
    velocity.segment(first, wall.size()) +=
        null_space_velocity(wall, rest.segment(first, wall.size()));
  }
  return velocity;
}
// [operator]

ComplexVector SuspensionOperator::right_hand_side() const {
  const auto* fast = std::get_if<FastSum>(&sum_);
  if (fast == nullptr) return closure_.right_hand_side();
  // g_k - u_inf - sum_p (S_p F_p + R_p L_p) as in (03.10).
  return closure_.boundary_data() -
         fast->velocity(ComplexVector::Zero(offsets_.back()), closure_.given_loads());
}

ComplexVector SuspensionOperator::plain_velocity(const ComplexVector& density,
                                                 const std::vector<Load>& loads) const {
  if (const auto* fast = std::get_if<FastSum>(&sum_)) return fast->velocity(density, loads);
  return std::get<StressletSum>(sum_)(density) +
         closure_.singular_velocity(loads, all_nodes(curves_));
}

}  // namespace stokesbook
