#pragma once

#include <memory>
#include <vector>

#include "near_singular/cauchy.hpp"

namespace stokesbook {

/// @addtogroup near_singular
/// @{

/// A curve placed in the plane: the shared reference and where it is.
struct PlacedCauchyCurve {
  std::shared_ptr<const CauchyCurve> reference;  ///< shared by all curves of one shape
  Complex position;                              ///< of the reference's origin, length
  double orientation = 0.0;                      ///< radians, counter-clockwise
};

/// Whose nodes the targets of a near correction are.
enum class Targets {
  own_nodes,  ///< all nodes of the curves themselves, in order; a curve is not corrected on itself
  points      ///< points of the fluid
};

/// The near correction of a trapezoid sum: replaces it by the Cauchy scheme at the targets
/// where the rule is too coarse. Planned once per geometry, applied many times.
///
/// @par Accuracy  1e-13 relative once the density is resolved, at any gap
/// @par Cost      12 N^2 real multiplications a curve with near targets, 50 N operations a near
/// target; O(1) memory a pair
class NearCorrection {
 public:
  /// Finds the near targets of every curve.
  ///
  /// @param  curves     placed curves, in the order of the densities
  /// @param  targets    m points, length
  /// @param  kind       what the targets are
  /// @param  tolerance  of velocities relative to densities, > 0; decides which targets are near
  /// @par Cost          a bounding-circle test a target and curve, O(N) for a target inside it
  NearCorrection(std::vector<PlacedCauchyCurve> curves, const ComplexVector& targets, Targets kind,
                 double tolerance);

  /// Evaluates Cauchy value minus trapezoid value, summed over the near curves of each
  /// target.
  ///
  /// @param  density  at all nodes, in the curves' order, length / time
  /// @return          velocities at the m targets, length / time
  ComplexVector operator()(const ComplexVector& density) const;

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct NearTargets {
    std::vector<Eigen::Index> index;  // which targets
    ComplexVector local;              // in the source's frame
  };
  /// @endcond
  NearTargets find_targets(std::size_t source, const ComplexVector& targets, Targets kind,
                           double tolerance) const;

  std::vector<PlacedCauchyCurve> curves_;
  std::vector<Eigen::Index> offsets_;             // first node of each curve, and the total
  std::vector<NearTargets> near_;                 // of each curve
  std::vector<std::vector<std::size_t>> groups_;  // curves with near targets, by reference
  Eigen::Index target_count_;
};

/// @}

}  // namespace stokesbook
