#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "near_singular/cauchy.hpp"
#include "near_singular/interpolation.hpp"

namespace stokesbook {

/// @addtogroup near_singular
/// @{

/// A scheme of close evaluation of one curve. Both evaluate `velocity(data(densities), column,
/// targets)` and `velocity_rows(targets)`; pressure and strain are CauchyCurve's alone.
using CloseScheme =
    std::variant<std::shared_ptr<const CauchyCurve>, std::shared_ptr<const InterpolationCurve>>;

/// A curve placed in the plane: the scheme in its own frame, and where it is.
struct PlacedCurve {
  CloseScheme scheme;        ///< shared by all curves of one shape
  Complex position;          ///< of the scheme's frame, length
  double orientation = 0.0;  ///< radians, counter-clockwise

  /// Returns the nodes.
  /// @return N nodes, in the curve's own frame
  const Curve& curve() const {
    return std::visit([](const auto& s) -> const Curve& { return s->curve(); }, scheme);
  }
};

/// Whose nodes the targets of a near correction are.
enum class Targets {
  own_nodes,  ///< all nodes of the curves themselves, in order; a curve is not corrected on itself
  points      ///< points of the fluid or of its boundary
};

/// The targets that are near one curve.
struct NearTargets {
  std::vector<Eigen::Index> index;  ///< which, ascending
  ComplexVector local;              ///< the same in the curve's own frame, length
};

/// Finds the targets at which each curve's trapezoid rule is too coarse, by is_near().
///
/// @param  curves     placed curves, in the order of the densities
/// @param  targets    m points, length
/// @param  kind       what the targets are
/// @param  tolerance  of is_near(), > 0
/// @return            one entry a curve
/// @throws std::invalid_argument when a target is not finite
/// @par Cost          a search in a RectangleIndex a curve, O(N) for a target inside its circle of
/// reach; for points that neighbour each other in their order, as on a grid
std::vector<NearTargets> find_near_targets(const std::vector<PlacedCurve>& curves,
                                           const ComplexVector& targets, Targets kind,
                                           double tolerance);

/// Returns the position of each curve's first node in the vector of all nodes.
///
/// @param  curves  in the order of the densities
/// @return         one entry a curve, and one more with the number of all nodes
std::vector<Eigen::Index> node_offsets(const std::vector<PlacedCurve>& curves);

/// @}

}  // namespace stokesbook
