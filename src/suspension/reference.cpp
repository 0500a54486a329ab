#include "suspension/reference.hpp"

#include "double_layer/double_layer.hpp"

namespace stokesbook {

std::shared_ptr<const Reference> ReferenceShelf::get(const Shape& shape, int n_nodes,
                                                     ComponentKind kind) {
  for (const auto& known : built_) {
    if (known->kind == kind && known->curve.size() == n_nodes && known->shape == shape) {
      return known;
    }
  }
  const Side side =
      kind == ComponentKind::enclosing_wall ? Side::fluid_inside : Side::fluid_outside;
  Reference reference{shape, kind, sample(shape, n_nodes, side), {}, 0.0, {}, {}, {}};
  reference.interpolant = std::make_shared<TrigonometricPolynomial>(reference.curve.x);
  reference.rigid_motion_residual = rigid_motion_residual(reference.curve);
  if (needs_.cauchy) reference.cauchy = std::make_shared<CauchyCurve>(reference.curve);
  if (needs_.interpolation_tolerance) {
    reference.interpolation = std::make_shared<InterpolationCurve>(
        reference.curve, InterpolationSettings::for_tolerance(*needs_.interpolation_tolerance));
  }
  if (needs_.inverse_block) {
    const Component alone{kind, reference.curve, {}, {}, 0.0, {}};
    reference.inverse_block =
        std::make_shared<Eigen::MatrixXd>(invert_block(self_block(alone, needs_.gauge_length)));
  }
  built_.push_back(std::make_shared<Reference>(std::move(reference)));
  return built_.back();
}

}  // namespace stokesbook
