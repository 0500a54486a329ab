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

/// What all components of one shape, resolution and kind share, in the shape's own frame.
struct Reference {
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

/// What a reference is to hold beside its nodes.
struct ReferenceNeeds {
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
/// @param  reference  of a component
/// @return            its shape_residual times the norm of its inverse block; where it is above a
///                    tenth, a solution may be wrong whatever tails and residuals say
/// @par Cost          inverse_block, unless the errors are so small that no shape needs less
double softest_mode_error(const Reference& reference);

/// The shared reference of each component.
using References = std::vector<std::shared_ptr<const Reference>>;

/// Returns the resolution of each reference.
///
/// @param  references  of each component
/// @return             in the same order
Resolutions resolutions_of(const References& references);

/// Places a component.
///
/// @param  reference  shared nodes, in the shape's own frame
/// @param  pose       where they are
/// @return            its nodes and its curve in the plane
SmoothCurve smooth_curve(const Reference& reference, const Pose& pose);

/// Keeps the references that are in use, each built once.
///
/// Resolutions may change from solve to solve: what has not been asked for lately is dropped, and
/// built anew, equal to the last bit, should it be asked for again. Graded nodes belong to one
/// configuration and are not kept. Safe to use from several threads at once.
class ReferenceShelf {
 public:
  /// Starts with an empty shelf.
  /// @param  needs     what each reference is to hold
  /// @param  patience  calls of get() for which a reference is kept that none of them asks for
  ReferenceShelf(const ReferenceNeeds& needs, std::size_t patience)
      : needs_(needs), patience_(patience) {}

  /// Returns the reference of a shape, resolution and kind; builds it when it is not there.
  ///
  /// @param  shape       in its own frame
  /// @param  resolution  N nodes, even, >= 4
  /// @param  kind        of the component
  /// @return             the one that all such components share
  /// @throws std::invalid_argument when N is odd or too small
  /// @par Cost        O(N^2 log N) for a new one, O(N^2) without near corrections
  std::shared_ptr<const Reference> get(const Shape& shape, const Resolution& resolution,
                                       ComponentKind kind);

  /// Counts what is kept.
  /// @return number of references
  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return kept_.size();
  }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct Kept {
    std::shared_ptr<const Reference> reference;
    std::size_t last_call;
  };
  /// @endcond

  ReferenceNeeds needs_;
  std::size_t patience_, calls_ = 0;
  std::vector<Kept> kept_;
  mutable std::mutex mutex_;
};

/// @}

}  // namespace stokesbook
