#pragma once

#include <vector>

#include "double_layer/flow_derivatives.hpp"
#include "fmm/fmm.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::verification::fmm {

/// Holds nodes with a random density, and the results of the direct sum.
struct Summed {
  explicit Summed(const std::vector<Curve>& of);

  /// Evaluates the direct sums anew after a change of the density.
  void evaluate();

  std::vector<Curve> curves;
  ComplexVector density, velocity;           ///< values at the nodes
  ComplexVector elsewhere;                   ///< 300 points near nodes
  std::vector<FlowDerivatives> derivatives;  ///< derivatives at these points
};

/// @name Sets of about n nodes
/// @{
std::vector<Curve> square(Eigen::Index n);    ///< uniform in a square
std::vector<Curve> ellipses(Eigen::Index n);  ///< on ellipses 2:1 of 64 nodes, in a square array
std::vector<Curve> crowd(Eigen::Index n);     ///< accumulating at one point, over eight decades
/// @}

/// Makes points into nodes with very small weights.
std::vector<Curve> as_nodes(const ComplexVector& points);

/// @name Sums of some 5000 nodes, made once
/// @{
const Summed& summed_square();
const Summed& summed_ellipses();
const Summed& summed_crowd();
const Summed& summed_slender_body();  ///< 1:100, wavy density: few boxes, with similar errors
/// @}

/// Returns the relative error of the velocities at the nodes in the 2-norm.
double velocity_error(const Summed& exact, const FmmSettings& settings);

/// Returns the relative error of pressure, vorticity and strain near the nodes in the 2-norm.
double derivative_error(const Summed& exact, const FmmSettings& settings);

/// Returns the relative error of the velocities near the nodes in the 2-norm. Every node has a
/// Stokeslet and a rotlet instead of the layer.
double point_force_error(const Summed& exact, const FmmSettings& settings);

/// Returns settings with a given order. The leaf size is that of a tolerance with this order.
FmmSettings of_order(int order);

/// Counts the operations of an application in units of kernel evaluations.
///
/// An evaluation counts eight multiplications. Each pair of the near lists costs 1, a conversion
/// (M2L) costs p^2/2, and a translation of an expansion by one level (M2M, L2L) costs p^2/4. For
/// each node, P2M and L2P together cost 3p.
double operations(const Fmm& plan, int order);

}  // namespace stokesbook::verification::fmm
