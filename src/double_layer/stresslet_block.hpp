#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

/// The nodes of several curves, one after another, in the layout that the kernels read.
struct StressletNodes {
  explicit StressletNodes(const std::vector<Curve>& curves);  ///< copies the nodes of the curves
  Eigen::Index size() const { return x.size(); }              ///< returns the number of nodes

  Eigen::VectorXd x;       ///< first coordinates of the nodes, length
  Eigen::VectorXd y;       ///< second coordinates, length
  Eigen::VectorXd nx;      ///< first components of the normals times w / pi, length
  Eigen::VectorXd ny;      ///< second components, length
  Eigen::VectorXd least2;  ///< squared half weights (w / 2)^2, length^2
};

/// Consecutive nodes with the densities of one or several fields.
///
/// Blocks feed the innermost loops of StressletSum, and the near fields of faster sums.
struct StressletBlock {
  const double* x;          ///< first coordinates of the nodes, length
  const double* y;          ///< second coordinates, length
  const double* nx;         ///< first components of the normals times w / pi, length
  const double* ny;         ///< second components, length
  const double* least2;     ///< lower bounds (w / 2)^2 of the squared distances, length^2
  Eigen::Index size;        ///< number of nodes
  const double* ex;         ///< first components of the first field's densities, length / time
  const double* ey;         ///< second components, length / time
  Eigen::Index stride = 0;  ///< offset of the densities of the next field
};

/// Sixteen points or vectors of the plane, with their components in separate arrays: a kernel works
/// on one group at a time.
struct VectorGroup {
  static constexpr int size = 16;               ///< number of vectors
  alignas(64) std::array<double, size> x = {};  ///< first components
  alignas(64) std::array<double, size> y = {};  ///< second components
};

/// Returns the vectors with the components x and y from `first` on as a group. If the vectors
/// before `last` do not fill the group, then the last of them is repeated.
VectorGroup group_of(const Eigen::VectorXd& x, const Eigen::VectorXd& y, Eigen::Index first,
                     Eigen::Index last);

/// Adds the velocities of a block at a group of targets, with the bounded kernel of StressletSum.
///
/// @tparam fields  number of densities: 1, 2 or 4
/// @param  sum     velocities of each field at the targets, length / time; the block's are added
/// @par Cost       one kernel evaluation per pair; the fields share two thirds of its work
template <int fields>
void add_velocities(const StressletBlock& block, const VectorGroup& targets,
                    std::array<VectorGroup, fields>& sum);

/// Adds pressure, vorticity and strain of a block's first field at a target, 1 / time, with the
/// bounded kernel.
void add_derivatives(const StressletBlock& block, Complex target, FlowDerivatives& sum);

}  // namespace stokesbook
