#pragma once

#include <span>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"

namespace stokesbook {

/// @addtogroup double_layer
/// @{

/// Consecutive nodes with their densities, for the innermost loops of StressletSum and of faster
/// sums that take their near fields from it.
struct StressletBlock {
  const double *x, *y;    ///< nodes, length
  const double *nx, *ny;  ///< normal times weight over pi, length
  const double *ex, *ey;  ///< densities, length / time
  const double* least2;  ///< squared half weights, by which squared distances are bounded, length^2
  Eigen::Index size;     ///< number of nodes
};

/// Adds the velocities of a block at some targets, with the bounded kernel of StressletSum.
///
/// @param  block    nodes
/// @param  targets  all targets, length
/// @param  first    first of those that are summed
/// @param  last     one beyond the last of them
/// @param  sum      velocities at all targets, length / time, to which is added
/// @par Cost        a kernel evaluation a pair, two targets at a time
void add_velocities(const StressletBlock& block, const ComplexVector& targets, Eigen::Index first,
                    Eigen::Index last, ComplexVector& sum);

/// Adds pressure, vorticity and strain of a block at a target, with the bounded kernel.
///
/// @param  block   nodes
/// @param  target  length
/// @param  sum     1 / time, to which is added
/// @par Cost       a kernel evaluation a node
void add_derivatives(const StressletBlock& block, Complex target, FlowDerivatives& sum);

/// @}

}  // namespace stokesbook
