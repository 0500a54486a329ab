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
#include "trapezoid/grading.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// The number of nodes of a component, and their grading.
struct Resolution {
  int n_nodes = 0;    ///< collocation nodes, even
  Grading grading{};  ///< clusters of nodes; without clusters the nodes are equidistant

  /// Returns whether nodes crowd anywhere.
  bool is_graded() const { return !grading.clusters.empty(); }

  /// Compares all members.
  bool operator==(const Resolution&) const = default;
};

/// The resolution of each component: bodies, then walls, in the scene's order.
using Resolutions = std::vector<Resolution>;

/// A shape with its nodes, in its own frame: the data that all components of one shape, resolution
/// and kind share.
struct DiscretisedShape {
  Shape shape;                                             ///< the shape that was sampled
  Resolution resolution;                                   ///< number and grading of the nodes
  ComponentKind kind;                                      ///< determines the side of the fluid
  std::vector<GradedParameter> parameters;                 ///< parameters of the nodes
  Curve curve;                                             ///< nodes
  std::shared_ptr<const Parametrisation> parametrisation;  ///< parametrisation of the shape
  /// From shape_residual(); for graded nodes from rigid_motion_residual().
  double shape_residual = 0.0;
  double gyration_radius = 0.0;  ///< gyration radius of the curve about its centroid, length
  /// Null unless near corrections are planned.
  std::shared_ptr<const CauchyCurve> cauchy{};
  /// Null unless the scene selects the interpolation scheme.
  std::shared_ptr<const InterpolationCurve> interpolation{};
  /// Inverse of the component's own block, computed at the first access, O(N^3).
  std::shared_future<std::shared_ptr<const Eigen::MatrixXd>> inverse_block{};
};

/// Returns true for bodies and inner walls, false for an enclosing wall.
inline bool is_inner(const DiscretisedShape& discretised) {
  return discretised.kind != ComponentKind::enclosing_wall;
}

/// The data that a discretised shape holds in addition to its nodes.
struct DiscretisationNeeds {
  bool cauchy = false;                            ///< the Cauchy scheme of near corrections
  std::optional<double> interpolation_tolerance;  ///< none: no interpolation scheme
  std::optional<double> gauge_length;  ///< gauge length in an unbounded fluid, see self_block()
};

/// Measures how well the equidistant nodes of a curve, by sample(), resolve its shape.
///
/// @return  the larger of rigid_motion_residual() and of the distance, halfway between nodes, of
///          the shape from the trigonometric interpolant of the nodes; the distance is divided by
///          the largest distance of the shape from its origin
double shape_residual(const Shape& shape, const Curve& curve);

/// Estimates the relative error that the nodes of a component cause in the softest mode of its own
/// block M: \f$ \delta\,\|M^{-1}\| \f$ with the shape residual \f$ \delta \f$ (chapter 12, section
/// "Nodes").
///
/// Slender bodies have densities that cause almost no flow: the block has eigenvalues near zero. If
/// the errors of the block are as large as such an eigenvalue, the solution may contain the mode
/// with any amplitude, and the motions of neighbours that excite the mode are wrong, too. An error
/// estimate on a few more nodes does not detect this error, because these nodes do not resolve the
/// mode either.
/// @return  the estimate, in the maximum norm; the residual alone if it is below 1e-9, which
///          suffices for every shape, or if the block is singular. Above a tenth, a solution may be
///          wrong even if its tails and residuals are small
double softest_mode_error(const DiscretisedShape& discretised);

/// The discretised shape of each component: bodies, then walls, in the scene's order.
using Discretisation = std::vector<std::shared_ptr<const DiscretisedShape>>;

/// Returns the resolution of each component.
Resolutions resolutions_of(const Discretisation& discretisation);

/// Places nodes and parametrisation of a component in the plane.
SmoothCurve smooth_curve(const DiscretisedShape& discretised, const Pose& pose);

/// Shares the discretised shapes of a scene's components, each built once.
///
/// Node numbers may change from solve to solve. The cache keeps the shapes that were used last. A
/// shape that was dropped is built again, and is then equal to the last bit. Shapes with graded
/// nodes belong to one configuration and are not kept. Several threads may use the cache at once.
class DiscretisationCache {
 public:
  /// Creates a cache for `most` shapes with the data `needs`.
  DiscretisationCache(const DiscretisationNeeds& needs, std::size_t most)
      : needs_(needs), most_(most) {}

  /// Returns the object that all components of a shape, resolution and kind share; builds it if it
  /// is not kept.
  ///
  /// @throws std::invalid_argument when the number of nodes is odd or less than 4
  std::shared_ptr<const DiscretisedShape> get(const Shape& shape, const Resolution& resolution,
                                              ComponentKind kind);

  /// Counts the shapes that are kept.
  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return kept_.size();
  }

 private:
  DiscretisationNeeds needs_;
  std::size_t most_;
  Discretisation kept_;  // in the order of their latest use
  mutable std::mutex mutex_;
};

}  // namespace stokesbook
