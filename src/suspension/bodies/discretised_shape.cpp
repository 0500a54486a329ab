// Samples a shape, and prepares the data that all components of this shape share: the schemes of
// close evaluation (chapter 06) and the inverse of the own block (05.11). Estimates how well the
// nodes resolve the shape and its softest mode (chapter 12, section "Nodes").
#include "suspension/bodies/discretised_shape.hpp"

#include <algorithm>

#include "closure/rigid_modes.hpp"
#include "double_layer/double_layer.hpp"
#include "suspension/bodies/components.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

namespace {

std::vector<GradedParameter> parameters_of(const Resolution& resolution) {
  return graded_parameters(resolution.grading, resolution.n_nodes);
}

Curve nodes_of(const Shape& shape, const Resolution& resolution,
               const std::vector<GradedParameter>& parameters, Side side) {
  return resolution.is_graded() ? sample(shape, parameters, side)
                                : sample(shape, resolution.n_nodes, side);
}

DiscretisedShape build(const Shape& shape, const Resolution& resolution, ComponentKind kind,
                       const DiscretisationNeeds& needs) {
  const auto parameters = parameters_of(resolution);
  const Curve curve = nodes_of(shape, resolution, parameters, side_of(kind));
  DiscretisedShape discretised{shape, resolution, kind, parameters, curve, {}};
  discretised.parametrisation = std::make_shared<const Parametrisation>(parametrisation(shape));
  discretised.shape_residual =
      resolution.is_graded() ? rigid_motion_residual(curve) : shape_residual(shape, curve);
  discretised.gyration_radius = RigidModes(curve, {}).gyration_radius();
  if (needs.cauchy) {
    // Graded nodes suit one body in one configuration: no other body shares its matrices.
    discretised.cauchy = std::make_shared<CauchyCurve>(
        curve, resolution.is_graded() ? KernelStorage::streamed : KernelStorage::stored);
  }
  if (needs.interpolation_tolerance) {
    discretised.interpolation = std::make_shared<InterpolationCurve>(
        curve, InterpolationSettings::for_tolerance(*needs.interpolation_tolerance));
  }
  // Most blocks are never inverted, so this waits without a copy of the nodes.
  discretised.inverse_block =
      std::async(std::launch::deferred, [shape, resolution, kind, gauge = needs.gauge_length] {
        const Curve nodes = nodes_of(shape, resolution, parameters_of(resolution), side_of(kind));
        const Component alone{kind, nodes, {}, {}, 0.0, {}};
        return std::make_shared<const Eigen::MatrixXd>(invert_block(self_block(alone, gauge)));
      }).share();
  return discretised;
}

}  // namespace

double shape_residual(const Shape& shape, const Curve& curve) {
  // The interpolant is exact at the nodes; it differs from the shape halfway between them.
  const ComplexVector between = sample(shape, 2 * curve.size(), curve.side).x;
  const double distance = (resample(curve.x, between.size()) - between).cwiseAbs().maxCoeff();
  return std::max(rigid_motion_residual(curve), distance / between.cwiseAbs().maxCoeff());
}

double softest_mode_error(const DiscretisedShape& discretised) {
  // A residual below this suffices for every shape: the inverse block is not computed.
  constexpr double beyond_question = 1e-9;
  if (discretised.shape_residual < beyond_question) return discretised.shape_residual;
  try {
    const Eigen::MatrixXd& inverse = *discretised.inverse_block.get();
    // delta ||M^{-1}|| of chapter 12, in the maximum norm.
    return discretised.shape_residual * inverse.cwiseAbs().rowwise().sum().maxCoeff();
  } catch (const std::domain_error&) {
    return discretised.shape_residual;  // singular for any number of nodes: solves are refused
  }
}

Resolutions resolutions_of(const Discretisation& discretisation) {
  Resolutions resolutions;
  for (const auto& discretised : discretisation) resolutions.push_back(discretised->resolution);
  return resolutions;
}

SmoothCurve smooth_curve(const DiscretisedShape& discretised, const Pose& pose) {
  SmoothCurve curve{place(discretised.curve, pose.position, pose.orientation),
                    discretised.parametrisation, pose.position, pose.orientation};
  if (discretised.resolution.is_graded()) curve.parameters = discretised.parameters;
  return curve;
}

std::shared_ptr<const DiscretisedShape> DiscretisationCache::get(const Shape& shape,
                                                                 const Resolution& resolution,
                                                                 ComponentKind kind) {
  if (resolution.is_graded()) {
    return std::make_shared<DiscretisedShape>(build(shape, resolution, kind, needs_));
  }
  const std::lock_guard lock(mutex_);
  const auto known = std::ranges::find_if(kept_, [&](const auto& kept) {
    return kept->kind == kind && kept->resolution == resolution && kept->shape == shape;
  });
  if (known != kept_.end()) {
    std::rotate(known, known + 1, kept_.end());
  } else {
    if (kept_.size() == most_) kept_.erase(kept_.begin());
    kept_.push_back(
        std::make_shared<const DiscretisedShape>(build(shape, resolution, kind, needs_)));
  }
  return kept_.back();
}

}  // namespace stokesbook
