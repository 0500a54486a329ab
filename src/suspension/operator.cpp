#include "suspension/operator.hpp"

#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"

namespace stokesbook {

using Eigen::Index;

SuspensionOperator::SuspensionOperator(const StokesProblem& problem,
                                       const std::vector<PlacedCurve>& placed, const Plan& plan)
    : curves_(curves_of(problem)),
      offsets_(node_offsets(problem)),
      closure_(problem),
      sum_(curves_, StressletSum::automatic_storage(offsets_.back())) {
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    if (problem.components[k].kind == ComponentKind::enclosing_wall) enclosing_wall_ = k;
  }
  if (!placed.empty()) {
    near_.emplace(placed, all_nodes(curves_), Targets::own_nodes,
                  NearSettings{plan.near_tolerance});
  }
}

ComplexVector SuspensionOperator::operator()(const ComplexVector& density) const {
  const ComplexVector rest = closure_.without_rigid_part(density);
  ComplexVector velocity = sum_(rest) - 0.5 * rest + closure_.velocity(density);
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

}  // namespace stokesbook
