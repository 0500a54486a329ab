#pragma once

#include <vector>

#include "double_layer/flow_derivatives.hpp"
#include "fmm/fmm.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook::verification::fmm {

/// Nodes with a random density, and what the direct sum makes of it.
struct Summed {
  explicit Summed(const std::vector<Curve>& of);

  /// Sums directly, after the density was changed.
  void evaluate();

  std::vector<Curve> curves;
  ComplexVector density, velocity;           ///< at the nodes
  ComplexVector elsewhere;                   ///< 300 points beside nodes
  std::vector<FlowDerivatives> derivatives;  ///< there
};

/// @name About n nodes that fill the plane differently
/// @{
std::vector<Curve> square(Eigen::Index n);    ///< uniform in a square
std::vector<Curve> ellipses(Eigen::Index n);  ///< on ellipses 2:1, 64 each, in a square array
std::vector<Curve> crowd(Eigen::Index n);     ///< towards one point, over eight decades
/// @}

/// Points as nodes, which weigh next to nothing.
std::vector<Curve> as_nodes(const ComplexVector& points);

/// @name Sums of some 5000 nodes, made once
/// @{
const Summed& summed_square();
const Summed& summed_ellipses();
const Summed& summed_crowd();
const Summed& summed_slender_body();  ///< 1:100, with a wavy density: few boxes, whose errors are
                                      ///< alike
/// @}

/// Error of the velocities at the nodes in the 2-norm, relative.
double velocity_error(const Summed& exact, const FmmSettings& settings);

/// Error of pressure, vorticity and strain beside the nodes in the 2-norm, relative.
double derivative_error(const Summed& exact, const FmmSettings& settings);

/// Error of the velocities beside the nodes in the 2-norm, relative, with a Stokeslet and a rotlet
/// at every node instead of the layer.
double point_force_error(const Summed& exact, const FmmSettings& settings);

/// Settings of an order, with leaves as for the tolerance that asks for it.
FmmSettings of_order(int order);

/// Operations of an application in kernel evaluations.
///
/// Each is taken for eight multiplications. Pairs of the near lists count one, a conversion counts
/// p^2/2, an expansion that moves a level up or down p^2/4, a node's part in a multipole expansion
/// and its velocity by a local one 3p together.
double operations(const Fmm& plan, int order);

}  // namespace stokesbook::verification::fmm
