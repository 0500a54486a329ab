#pragma once

#include <vector>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "fmm/expansions.hpp"
#include "fmm/interactions.hpp"
#include "fmm/quadtree.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup fmm
/// @{

/// What an FMM is planned with.
struct FmmSettings {
  int order = 0;               ///< p, highest power of the expansions
  Eigen::Index leaf_size = 0;  ///< most points of a box that is not divided

  /// Chooses order and leaf size for a tolerance: \f$ p = \lceil 3.03\log_{10}(1/\varepsilon) - 2.6
  /// \rceil \f$, leaves of 2 p + 15 points.
  ///
  /// @param  tolerance  of velocities in the 2-norm over all targets, relative, > 0
  /// @return            settings
  static FmmSettings for_tolerance(double tolerance);
};

/// The trapezoid sum of the double layer over all nodes of several curves, as StressletSum
/// evaluates it, by the fast multipole method: planned once, applied many times.
///
/// @par Accuracy  the tolerance of FmmSettings::for_tolerance(), relative in the 2-norm
/// @par Cost      O(n) an application, about n (0.15 + 0.01 p) microseconds on one core; results do
/// not depend on the number of threads
/// @sa source: Greengard and Rokhlin, J. Comput. Phys. 73 (1987), 325; Greengard, Kropinski, Mayo,
/// J. Comput. Phys. 125 (1996), 403
class StressletFmm {
 public:
  /// Plans the sum at the nodes themselves.
  ///
  /// @param  curves    n nodes in all, in this order
  /// @param  settings  order and leaf size
  /// @par Cost         O(n log n), about half an application at 1e-6
  StressletFmm(const std::vector<Curve>& curves, const FmmSettings& settings);

  /// Plans the sum at other targets.
  ///
  /// @param  curves    n nodes in all, in this order
  /// @param  targets   m points, length
  /// @param  settings  order and leaf size
  /// @par Cost         O(n log n + m log m)
  StressletFmm(const std::vector<Curve>& curves, const ComplexVector& targets,
               const FmmSettings& settings);

  /// Evaluates the velocity.
  ///
  /// @param  density  at all nodes, in the curves' order, length / time
  /// @return          velocities at the targets, length / time
  ComplexVector operator()(const ComplexVector& density) const;

  /// Evaluates pressure, vorticity and strain.
  ///
  /// @param  density  at all nodes, in the curves' order, length / time
  /// @return          at the targets, 1 / time
  /// @par Accuracy    a hundred times the tolerance, relative in the 2-norm
  std::vector<FlowDerivatives> derivatives(const ComplexVector& density) const;

  /// Returns the tree of the sources.
  /// @return boxes, and the order of the nodes
  const Quadtree& sources() const { return sources_; }

  /// Returns who interacts with whom.
  /// @return lists of the targets' boxes
  const Interactions& interactions() const { return interactions_; }

 private:
  StressletSources strengths(const ComplexVector& density) const;
  Expansion outgoing(const StressletSources& sources) const;
  Expansion incoming(const Expansion& outgoing) const;

  Translations translations_;
  Quadtree sources_, targets_;
  Interactions interactions_;
  ComplexVector weighted_normal_;  // n w, in the tree's order
  Eigen::VectorXd x_, y_;          // nodes, in the tree's order
  Eigen::VectorXd nx_, ny_;        // normal times weight over pi
  Eigen::VectorXd least2_;         // squared half weight
};

/// @}

}  // namespace stokesbook
