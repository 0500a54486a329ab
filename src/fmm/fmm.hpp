#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "double_layer/stresslet_block.hpp"
#include "fmm/expansions.hpp"
#include "fmm/fmm_settings.hpp"
#include "fmm/interactions.hpp"
#include "fmm/quadtree.hpp"
#include "fmm/translations.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup fmm
/// @{

/// What the sources of an Fmm carry, a column each field: views, for the call of a function.
struct FmmStrengths {
  /// Gives the nodes densities, and the points nothing.
  /// @param  node_density  n x k, length / time
  template <class Density>
  FmmStrengths(const Eigen::MatrixBase<Density>& node_density)
      : density(node_density), force(Eigen::MatrixXcd()), torque(Eigen::MatrixXd()) {}

  /// Gives nodes densities, and points forces and torques on the fluid.
  ///
  /// @param  node_density  n x k, length / time
  /// @param  point_force   over the viscosity, m x k, length / time
  /// @param  point_torque  over the viscosity, m x k, length^2 / time
  template <class Density, class Force, class Torque>
  FmmStrengths(const Eigen::MatrixBase<Density>& node_density,
               const Eigen::MatrixBase<Force>& point_force,
               const Eigen::MatrixBase<Torque>& point_torque)
      : density(node_density), force(point_force), torque(point_torque) {}

  FmmStrengths(const FmmStrengths&) = delete;
  FmmStrengths& operator=(const FmmStrengths&) = delete;

  Eigen::Ref<const Eigen::MatrixXcd> density;  ///< of the nodes
  Eigen::Ref<const Eigen::MatrixXcd> force;    ///< of the points, or no rows for zeros
  Eigen::Ref<const Eigen::MatrixXd> torque;    ///< of the points, or no rows for zeros
};

class Fmm;

/// The memory of an Fmm's applications, and their results. One plan may be applied in several
/// threads, each with its own.
class FmmWorkspace {
  friend class Fmm;
  FmmWorkspace(const Fmm& plan, Eigen::Index fields);
  std::span<const PointForce> points(Range range, Eigen::Index field) const;

  Eigen::MatrixXd ex_, ey_;         // densities in the nodes' tree's order, a column a field
  std::vector<PointForce> points_;  // in their tree's order, field after field
  Expansions from_nodes_, from_points_, incoming_;
  Eigen::MatrixXcd velocity_;
  std::vector<FlowDerivatives> derivatives_;
};

/// The flow of a double layer's nodes and of point forces by the fast multipole method: planned
/// once, applied many times.
///
/// The nodes' sum is that of StressletSum, with the same bound on small distances; the points' that
/// of stokeslet() with gauge 1, and rotlet(). Another gauge \f$ \ell \f$ adds the uniform velocity
/// \f$ F\log\ell/4\pi\mu \f$.
///
/// @par Accuracy  the tolerance of FmmSettings::for_tolerance(), relative in the 2-norm
/// @par Cost      O(n) an application; the same bits for any number of threads
/// @sa source: Greengard and Rokhlin, J. Comput. Phys. 73 (1987), 325; Greengard, Kropinski, Mayo,
/// J. Comput. Phys. 125 (1996), 403
class Fmm {
 public:
  /// Plans the sum at the nodes themselves.
  ///
  /// @param  curves    n nodes in all, in this order
  /// @param  points    m places of forces and torques, length
  /// @param  settings  order and leaf size
  /// @throws std::invalid_argument when a node or point is not finite, a node is at a point, or a
  ///                   setting is out of range
  /// @par Cost         O(n log n)
  Fmm(const std::vector<Curve>& curves, const ComplexVector& points, const FmmSettings& settings);

  /// Plans the sum at other targets.
  ///
  /// @param  curves    n nodes in all, in this order
  /// @param  points    m places of forces and torques, length
  /// @param  targets   length
  /// @param  settings  order and leaf size
  /// @throws std::invalid_argument as above
  /// @par Cost         O(n log n) for n nodes and targets
  Fmm(const std::vector<Curve>& curves, const ComplexVector& points, const ComplexVector& targets,
      const FmmSettings& settings);

  /// Reserves the memory of applications.
  ///
  /// @param  fields  k, number of fields that are summed at once, >= 1
  /// @return         a workspace of this plan alone
  FmmWorkspace workspace(Eigen::Index fields = 1) const;

  /// Evaluates velocities, without allocation.
  ///
  /// @param  strengths  of nodes and points, k columns
  /// @param  workspace  of this plan, for k fields
  /// @return            a row a target, a column a field, length / time; overwritten by the next
  ///                    application with this workspace
  /// @throws std::invalid_argument when the strengths are not of the plan's and workspace's size
  const Eigen::MatrixXcd& velocity(const FmmStrengths& strengths, FmmWorkspace& workspace) const;

  /// Evaluates velocities.
  ///
  /// @param  strengths  of nodes and points, k columns
  /// @return            a row a target, a column a field, length / time
  Eigen::MatrixXcd velocity(const FmmStrengths& strengths) const;

  /// Evaluates pressure, vorticity and strain, without allocation from the second time on.
  ///
  /// @param  strengths  of nodes and points, k columns
  /// @param  workspace  of this plan, for k fields
  /// @return            at the targets, field after field, 1 / time; overwritten by the next
  ///                    application with this workspace
  /// @throws std::invalid_argument when the strengths are not of the plan's and workspace's size
  /// @par Accuracy      a hundred times the tolerance, relative in the 2-norm
  const std::vector<FlowDerivatives>& derivatives(const FmmStrengths& strengths,
                                                  FmmWorkspace& workspace) const;

  /// Evaluates pressure, vorticity and strain.
  ///
  /// @param  strengths  of nodes and points, k columns
  /// @return            at the targets, field after field, 1 / time
  /// @par Accuracy      a hundred times the tolerance, relative in the 2-norm
  std::vector<FlowDerivatives> derivatives(const FmmStrengths& strengths) const;

  /// Returns the order of the expansions.
  /// @return p
  int order() const { return translations_.order(); }

  /// Returns the tree of the nodes.
  /// @return boxes, and the order of the nodes
  const Quadtree& nodes() const { return nodes_; }

  /// Returns the tree of the points.
  /// @return boxes, and the order of the points
  const Quadtree& points() const { return points_; }

  /// Returns the tree of the targets.
  /// @return that of the nodes where they are the targets
  const Quadtree& targets() const { return targets_ ? *targets_ : nodes_; }

  /// Returns which boxes of nodes act on which boxes of targets.
  /// @return lists of the targets' boxes
  const Interactions& node_interactions() const { return node_interactions_; }

  /// Returns which boxes of points act on which boxes of targets.
  /// @return lists of the targets' boxes
  const Interactions& point_interactions() const { return point_interactions_; }

 private:
  struct Nodes;
  Fmm(const Nodes& nodes, const ComplexVector& points, const ComplexVector* targets,
      const FmmSettings& settings);

  void check(const FmmStrengths& strengths, const FmmWorkspace& work) const;
  void sum_far(const FmmStrengths& strengths, FmmWorkspace& work) const;
  StressletBlock block(Range nodes, Eigen::Index field, const FmmWorkspace& work) const;
  template <int fields>
  void sum_group(Eigen::Index box, Eigen::Index first, Eigen::Index field,
                 FmmWorkspace& work) const;
  FlowDerivatives derivatives_at(Eigen::Index box, Eigen::Index target, Eigen::Index field,
                                 const FmmWorkspace& work) const;

  Translations translations_;
  Quadtree nodes_, points_;
  std::optional<Quadtree> targets_;
  Interactions node_interactions_, point_interactions_;
  Eigen::VectorXd nx_, ny_;  // normal times weight over pi, in the tree's order
  Eigen::VectorXd least2_;   // squared half weight
};

/// @}

}  // namespace stokesbook
