#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "near_singular/cauchy.hpp"
#include "near_singular/interpolation.hpp"

namespace stokesbook {

/// A scheme of close evaluation for one curve. Both schemes evaluate `velocity(data(densities),
/// column, targets)` and `velocity_rows(targets)`; only CauchyCurve evaluates pressure and strain.
using CloseScheme =
    std::variant<std::shared_ptr<const CauchyCurve>, std::shared_ptr<const InterpolationCurve>>;

/// A curve placed in the plane: the scheme in the curve's own frame, and the pose of this frame.
struct PlacedCurve {
  CloseScheme scheme;        ///< shared by all curves of one shape
  Complex position;          ///< origin of the curve's frame in the plane, length
  double orientation = 0.0;  ///< radians, counter-clockwise

  /// Returns the nodes, in the curve's own frame.
  const Curve& curve() const {
    return std::visit([](const auto& s) -> const Curve& { return s->curve(); }, scheme);
  }
};

/// Kinds of targets of a near correction.
enum class Targets {
  own_nodes,  ///< all nodes of the curves, in order; no curve is corrected at its own nodes
  points      ///< points of the fluid or of its boundary
};

/// The targets that are near one curve.
struct NearTargets {
  /// Indices of these targets, ascending; with images, those of each image follow one another, and
  /// a target may be near several images.
  std::vector<Eigen::Index> index;
  /// Positions of these targets in the frame of the curve, or of its image, length.
  ComplexVector local;
};

/// Finds for each curve the targets at which its trapezoid rule is too coarse, by is_near().
///
/// @param  images  vectors by which images of all curves are moved, length; an image is near the
///                 nodes of its own curve, too
/// @throws std::invalid_argument when a target is not finite
/// @par Cost  a search in a RectangleIndex per curve and image, and O(N) per target within
/// near_reach(); the search excludes most targets only if consecutive points are neighbours, as on
/// a grid
std::vector<NearTargets> find_near_targets(const std::vector<PlacedCurve>& curves,
                                           const ComplexVector& targets, Targets kind,
                                           double tolerance,
                                           const std::vector<Complex>& images = {});

/// Returns the position of each curve's first node in the vector of all nodes, and in a last entry
/// the number of all nodes.
std::vector<Eigen::Index> node_offsets(const std::vector<PlacedCurve>& curves);

}  // namespace stokesbook
