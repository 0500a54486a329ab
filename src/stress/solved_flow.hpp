#pragma once

#include <functional>
#include <vector>

#include "closure/closure.hpp"
#include "double_layer/flow_derivatives.hpp"
#include "near_singular/near_targets.hpp"

namespace stokesbook {

/// @addtogroup stress
/// @{

class SolvedFlow;

/// Sums the trapezoid rule's layer and the singularities of a solution at m targets.
struct PlainSum {
  /// Velocities, without the uniform one, length / time.
  std::function<ComplexVector(const SolvedFlow&, const ComplexVector& targets)> velocity;
  /// Pressure, vorticity and strain, 1 / time.
  std::function<std::vector<FlowDerivatives>(const SolvedFlow&, const ComplexVector& targets)>
      derivatives;
};

/// Returns the sum over all nodes and loads, one after the other.
/// @return m n kernel evaluations for n nodes
PlainSum direct_sum();

/// How a SolvedFlow is evaluated.
struct FlowSettings {
  double tolerance = 1e-14;     ///< relative to the densities, > 0; decides what is near
  PlainSum sum = direct_sum();  ///< beside near corrections
};

/// The flow of a solved boundary value problem, without its background.
///
/// \f[ u = D[(I-P)\eta] + \sum_k (S_kF_k + R_kL_k) + u_c. \f]
/// The background is the caller's to add; derivatives superpose.
/// @par Accuracy  derivatives 1e-11 relative at any distance from the boundary and on its nodes,
/// once the densities are resolved, @ref claim_07_9; geometric in the nodes, @ref claim_07_16
/// @par Not for   points inside bodies, or outside the enclosing wall
class SolvedFlow {
 public:
  /// Prepares a solution for evaluation.
  ///
  /// @param  problem   components with their data, n nodes in all
  /// @param  placed    the same components for evaluation near them; derivatives want the Cauchy
  ///                   scheme; empty: the trapezoid rule everywhere, velocities only
  /// @param  density   solution of the system of Closure, at all n nodes, length / time
  /// @param  settings  what is near, and how the rest is summed
  /// @throws std::invalid_argument when Closure refuses the problem
  SolvedFlow(const StokesProblem& problem, std::vector<PlacedCurve> placed,
             const ComplexVector& density, FlowSettings settings = {});

  /// Evaluates the velocity.
  ///
  /// @param  targets  m points of the fluid or its boundary, length
  /// @return          m velocities, length / time
  /// @par Cost        that of the sum, and of NearCorrection
  ComplexVector velocity(const ComplexVector& targets) const;

  /// Evaluates pressure, vorticity and strain; on a node they are the limits from the fluid.
  ///
  /// The pressure vanishes at infinity; in an enclosed fluid it has a datum that means nothing.
  /// @param  targets  m points of the fluid or its boundary, length
  /// @return          m values, 1 / time
  /// @throws std::invalid_argument when a component has no Cauchy scheme
  /// @par Cost        that of the sum, and of near_derivative_corrections()
  std::vector<FlowDerivatives> derivatives(const ComplexVector& targets) const;

  /// Returns all nodes, component by component.
  /// @return n points, length
  ComplexVector nodes() const;

  /// Returns the velocity of the boundary: rigid motions of free bodies, else what is prescribed.
  /// @return whole velocities at all n nodes, the background included, length / time
  ComplexVector boundary_velocity() const;

  /// Returns the problem.
  /// @return the problem that was solved
  const StokesProblem& problem() const { return problem_; }

  /// Returns what the double layer is evaluated with.
  /// @return \f$ (I-P)\eta \f$ at all n nodes, length / time
  const ComplexVector& density() const { return density_; }

  /// Returns the closure of the problem.
  /// @return what ties motions and loads to the density
  const Closure& closure() const { return closure_; }

  /// Returns motions and loads.
  /// @return what the density says about the problem
  const Completion& completion() const { return completion_; }

 private:
  StokesProblem problem_;
  std::vector<PlacedCurve> placed_;
  Closure closure_;
  ComplexVector density_;
  Completion completion_;
  FlowSettings settings_;
};

/// Prepares curves that are already in the plane for evaluation near them, by the Cauchy scheme.
///
/// @param  problem  its components
/// @return          one entry a component
/// @par Cost        that of CauchyCurve a component
/// @par Not for     many components of one shape, which can share a CauchyCurve
std::vector<PlacedCurve> cauchy_curves(const StokesProblem& problem);

/// @}

}  // namespace stokesbook
