#pragma once

#include <cstddef>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "krylov/block_diagonal.hpp"
#include "near_singular/closest_points.hpp"
#include "near_singular/near_targets.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/resolution.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// A shape with its nodes, in its own frame: all that components of one shape, resolution and kind
/// share.
struct DiscretisedShape {
  Shape shape;                                             ///< what was sampled
  Resolution resolution;                                   ///< how finely
  ComponentKind kind;                                      ///< sets the side of the curve
  std::vector<GradedParameter> parameters;                 ///< of the shape at the nodes
  Curve curve;                                             ///< nodes
  std::shared_ptr<const Parametrisation> parametrisation;  ///< of the shape
  double shape_residual;                                   ///< by the function of this name
  double gyration_radius;                     ///< of the curve about its centroid, length
  std::shared_ptr<const CauchyCurve> cauchy;  ///< none unless near corrections are planned
  std::shared_ptr<const InterpolationCurve>
      interpolation;  ///< none unless velocities are to be interpolated
  std::shared_future<std::shared_ptr<const Eigen::MatrixXd>>
      inverse_block;  ///< of the preconditioner; found when first it is asked for, at O(N^3)
};

/// What a discretised shape holds beside its nodes.
struct DiscretisationNeeds {
  bool cauchy = false;                            ///< matrices of the near corrections
  std::optional<double> interpolation_tolerance;  ///< of velocities by interpolation, if wanted
  std::optional<double> gauge_length;  ///< of Stokeslets in an unbounded fluid, see self_block()
};

/// Measures how well equidistant nodes resolve a shape.
///
/// @param  shape  in its own frame
/// @param  curve  sampled from it
/// @return        the larger of rigid_motion_residual() and of the distance between the shape and
///                the curve through the nodes, halfway between them, over the shape's size
/// @par Cost      O(N^2)
double shape_residual(const Shape& shape, const Curve& curve);

/// Compares what the nodes of a component leave undone with the softest mode of its own block.
///
/// Slender bodies have densities that almost nothing comes of: the block has eigenvalues near zero,
/// a hundredth for an ellipse 10:1 and a hundred-thousandth for 65:1. Where errors of the block are
/// as large, such modes come out at any size, and so do the motions of neighbours that excite them;
/// a few nodes more change little, since these do not see them either.
/// @param  discretised  shape of a component
/// @return              its shape_residual times the norm of its inverse block; where it is above a
///                      tenth, a solution may be wrong whatever tails and residuals say
/// @par Cost          inverse_block, unless the errors are so small that no shape needs less
double softest_mode_error(const DiscretisedShape& discretised);

/// The discretised shape of each component: bodies, then walls, in the scene's order.
using Discretisation = std::vector<std::shared_ptr<const DiscretisedShape>>;

/// Returns the resolution of each component.
///
/// @param  discretisation  of each component
/// @return                 in the same order
Resolutions resolutions_of(const Discretisation& discretisation);

/// Places a component.
///
/// @param  discretised  shape of the component
/// @param  pose         where the component is
/// @return              its nodes and its curve in the plane
SmoothCurve smooth_curve(const DiscretisedShape& discretised, const Pose& pose);

/// Shares the discretised shapes of a scene's components, each built once.
///
/// Node numbers may change from solve to solve. The cache keeps the shapes that were used last; a
/// shape that was dropped is built again, equal to the last bit. Shapes with graded nodes belong to
/// one configuration and are not kept. Several threads may use the cache at once.
class DiscretisationCache {
 public:
  /// Starts empty.
  /// @param  needs  what a discretised shape holds beside its nodes
  /// @param  most   number of shapes that are kept
  DiscretisationCache(const DiscretisationNeeds& needs, std::size_t most)
      : needs_(needs), most_(most) {}

  /// Returns the discretised shape of a shape, resolution and kind; builds it if it is not kept.
  ///
  /// @param  shape       in its own frame
  /// @param  resolution  N nodes, even, >= 4
  /// @param  kind        of the component
  /// @return             the object that all such components share
  /// @throws std::invalid_argument when N is odd or too small
  /// @par Cost        O(N^2 log N) for a new one, O(N^2) without near corrections
  std::shared_ptr<const DiscretisedShape> get(const Shape& shape, const Resolution& resolution,
                                              ComponentKind kind);

  /// Counts the shapes that are kept.
  /// @return their number
  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return kept_.size();
  }

 private:
  DiscretisationNeeds needs_;
  std::size_t most_;
  Discretisation kept_;  // the latest used last
  mutable std::mutex mutex_;
};

/// @}

}  // namespace stokesbook
