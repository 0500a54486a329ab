// Prepares once what all components of one shape share (chapter 12).
#include "suspension/bodies/reference.hpp"

#include <algorithm>

#include "closure/rigid_modes.hpp"
#include "double_layer/double_layer.hpp"
#include "suspension/bodies/components.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

namespace {

Reference build(const Shape& shape, const Resolution& resolution, ComponentKind kind,
                const ReferenceNeeds& needs) {
  const Side side = side_of(kind);
  const auto parameters = graded_parameters(resolution.grading, resolution.n_nodes);
  Reference reference{shape,
                      resolution,
                      kind,
                      parameters,
                      resolution.is_graded() ? sample(shape, parameters, side)
                                             : sample(shape, resolution.n_nodes, side),
                      std::make_shared<const Parametrisation>(parametrisation(shape)),
                      0.0,
                      0.0,
                      {},
                      {},
                      {}};
  reference.shape_residual = resolution.is_graded() ? rigid_motion_residual(reference.curve)
                                                    : shape_residual(shape, reference.curve);
  reference.gyration_radius = RigidModes(reference.curve, {}).gyration_radius();
  if (needs.cauchy) reference.cauchy = std::make_shared<CauchyCurve>(reference.curve);
  if (needs.interpolation_tolerance) {
    reference.interpolation = std::make_shared<InterpolationCurve>(
        reference.curve, InterpolationSettings::for_tolerance(*needs.interpolation_tolerance));
  }
  const Component alone{kind, reference.curve, {}, {}, 0.0, {}};
  reference.inverse_block = std::async(std::launch::deferred, [alone, needs] {
                              return std::make_shared<const Eigen::MatrixXd>(
                                  invert_block(self_block(alone, needs.gauge_length)));
                            }).share();
  return reference;
}

}  // namespace

double shape_residual(const Shape& shape, const Curve& curve) {
  const ComplexVector between = sample(shape, 2 * curve.size(), curve.side).x;
  const double distance = (resample(curve.x, between.size()) - between).cwiseAbs().maxCoeff();
  return std::max(rigid_motion_residual(curve), distance / between.cwiseAbs().maxCoeff());
}

double softest_mode_error(const Reference& reference) {
  constexpr double beyond_question = 1e-9;
  if (reference.shape_residual < beyond_question) return reference.shape_residual;
  try {
    const Eigen::MatrixXd& inverse = *reference.inverse_block.get();
    return reference.shape_residual * inverse.cwiseAbs().rowwise().sum().maxCoeff();
  } catch (const std::domain_error&) {
    return reference.shape_residual;  // no inverse at any number of nodes: solves are refused
  }
}

Resolutions resolutions_of(const References& references) {
  Resolutions resolutions;
  for (const auto& reference : references) resolutions.push_back(reference->resolution);
  return resolutions;
}

SmoothCurve smooth_curve(const Reference& reference, const Pose& pose) {
  SmoothCurve curve{place(reference.curve, pose.position, pose.orientation),
                    reference.parametrisation, pose.position, pose.orientation};
  if (reference.resolution.is_graded()) curve.parameters = reference.parameters;
  return curve;
}

std::shared_ptr<const Reference> ReferenceShelf::get(const Shape& shape,
                                                     const Resolution& resolution,
                                                     ComponentKind kind) {
  if (resolution.is_graded()) {
    return std::make_shared<Reference>(build(shape, resolution, kind, needs_));
  }
  const std::lock_guard lock(mutex_);
  ++calls_;
  std::erase_if(kept_, [&](const Kept& kept) { return kept.last_call + patience_ < calls_; });
  for (Kept& kept : kept_) {
    const Reference& known = *kept.reference;
    if (known.kind == kind && known.resolution == resolution && known.shape == shape) {
      kept.last_call = calls_;
      return kept.reference;
    }
  }
  kept_.push_back({std::make_shared<Reference>(build(shape, resolution, kind, needs_)), calls_});
  return kept_.back().reference;
}

}  // namespace stokesbook
