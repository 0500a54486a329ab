#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup double_layer
/// @{

/// The nodes of several curves as the kernel reads them, one after another.
struct StressletNodes {
  /// Copies the curves' nodes.
  /// @param  curves  n nodes in all
  explicit StressletNodes(const std::vector<Curve>& curves);

  /// Counts the nodes.
  /// @return n
  Eigen::Index size() const { return x.size(); }

  Eigen::VectorXd x;       ///< first coordinates of the nodes, length
  Eigen::VectorXd y;       ///< second coordinates, length
  Eigen::VectorXd nx;      ///< first components of normal times weight over pi, length
  Eigen::VectorXd ny;      ///< second components, length
  Eigen::VectorXd least2;  ///< squared half weights, length^2
};

/// Consecutive nodes with the densities of one or several fields, for the innermost loops of
/// StressletSum and of faster sums that take their near fields from it.
struct StressletBlock {
  const double* x;       ///< first coordinates of the nodes, length
  const double* y;       ///< second coordinates, length
  const double* nx;      ///< first components of normal times weight over pi, length
  const double* ny;      ///< second components, length
  const double* least2;  ///< squared half weights, by which squared distances are bounded, length^2
  Eigen::Index size;     ///< number of nodes
  const double* ex;      ///< first components of the first field's densities, length / time
  const double* ey;      ///< second components, length / time
  Eigen::Index stride = 0;  ///< from a field's densities to the next field's
};

/// Sixteen points or vectors of the plane, their components apart: what a kernel works on at once.
struct VectorGroup {
  static constexpr int size = 16;               ///< number of vectors
  alignas(64) std::array<double, size> x = {};  ///< first components
  alignas(64) std::array<double, size> y = {};  ///< second components
};

/// Adds the velocities of a block at a group of targets, with the bounded kernel of StressletSum.
///
/// @tparam fields   number of densities: 1, 2 or 4
/// @param  block    nodes
/// @param  targets  length
/// @param  sum      velocities of each field at the targets, length / time, to which is added
/// @par Cost        a kernel evaluation a pair, of which fields share two thirds
template <int fields>
void add_velocities(const StressletBlock& block, const VectorGroup& targets,
                    std::array<VectorGroup, fields>& sum);

/// Adds pressure, vorticity and strain of a block at a target, with the bounded kernel.
///
/// @param  block   nodes, of which the first field is taken
/// @param  target  length
/// @param  sum     1 / time, to which is added
/// @par Cost       a kernel evaluation a node
void add_derivatives(const StressletBlock& block, Complex target, FlowDerivatives& sum);

/// @}

}  // namespace stokesbook
