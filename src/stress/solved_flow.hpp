#pragma once

#include <functional>
#include <vector>

#include "closure/closure.hpp"
#include "double_layer/flow_derivatives.hpp"
#include "near_singular/near_targets.hpp"

namespace stokesbook {

class SolvedFlow;

/// Functions that sum a solution's double layer, by the trapezoid rule, and its Stokeslets and
/// rotlets at m targets.
struct FlowSum {
  /// Evaluates velocities without the uniform velocity, length / time.
  std::function<ComplexVector(const SolvedFlow&, const ComplexVector& targets)> velocity;
  /// Evaluates pressure, vorticity and strain, 1 / time.
  std::function<std::vector<FlowDerivatives>(const SolvedFlow&, const ComplexVector& targets)>
      derivatives;
  /// Finds the vectors of the images in a periodic cell to which targets may be near; empty: none.
  std::function<std::vector<Complex>(const SolvedFlow&, const ComplexVector& targets)> images = {};
};

/// Returns the direct sum over all n nodes and all loads, with m n kernel evaluations; not for
/// problems in a periodic cell.
FlowSum direct_sum();

/// Parameters of a SolvedFlow.
struct FlowSettings {
  double tolerance = 1e-14;    ///< relative to the densities, > 0; decides which targets are near
  FlowSum sum = direct_sum();  ///< sum to which the near corrections are added
};

/// The flow of a solved boundary value problem, without its background.
///
/// \f[ u = D[(I-P)\eta] + \sum_k (S_kF_k + R_kL_k) + u_c. \f]
/// The caller adds velocities and derivatives of the background to those of this flow.
/// @par Accuracy  derivatives 1e-11 relative at any distance from the boundary and on its nodes,
/// once the densities are resolved, @ref claim_07_9; geometric in the nodes, @ref claim_07_16
/// @par Not for   points inside bodies, or outside the enclosing wall
class SolvedFlow {
 public:
  /// Prepares the solution of a problem with n nodes for evaluation.
  ///
  /// @param  placed    the same components with schemes of close evaluation; derivatives require
  ///                   the Cauchy scheme; empty: velocities only, by the trapezoid rule everywhere
  /// @param  density   solution of the system of Closure, at all n nodes, length / time
  /// @throws std::invalid_argument when Closure rejects the problem
  SolvedFlow(const StokesProblem& problem, std::vector<PlacedCurve> placed,
             const ComplexVector& density, FlowSettings settings = {});

  /// Evaluates the velocity at points of the fluid or its boundary, length / time.
  ///
  /// @par Cost  that of the sum, and of NearCorrection
  ComplexVector velocity(const ComplexVector& targets) const;

  /// Evaluates pressure, vorticity and strain at points of the fluid or its boundary, 1 / time; on
  /// a node they are the limits from the fluid.
  ///
  /// In an unbounded fluid the pressure vanishes at infinity. In an enclosed fluid only differences
  /// of pressures have a meaning. In a periodic cell, the pressure of each force and of the double
  /// layer consists of a periodic part with the mean zero, and of \f$ F\cdot z/V \f$.
  /// @throws std::invalid_argument when a component has no Cauchy scheme
  /// @par Cost  that of the sum, and of near_derivative_corrections()
  std::vector<FlowDerivatives> derivatives(const ComplexVector& targets) const;

  ComplexVector nodes() const;  ///< returns all n nodes, component by component

  /// Returns the density of the double layer at all n nodes, without its rigid part on bodies:
  /// \f$ (I-P)\eta \f$, length / time.
  const ComplexVector& density() const { return density_; }

  /// Returns the problem that was solved.
  const StokesProblem& problem() const { return problem_; }
  const Closure& closure() const { return closure_; }  ///< returns the problem's closure
  /// Returns the motions and loads of all components, computed from the density.
  const Completion& completion() const { return completion_; }

 private:
  std::vector<Complex> images(const ComplexVector& targets) const;

  StokesProblem problem_;
  std::vector<PlacedCurve> placed_;
  Closure closure_;
  ComplexVector density_;
  Completion completion_;
  FlowSettings settings_;
};

/// Prepares the curves of a problem for evaluation near them, by one CauchyCurve per component.
///
/// @par Not for   many components of one shape, which can share a CauchyCurve
std::vector<PlacedCurve> cauchy_curves(const StokesProblem& problem);

}  // namespace stokesbook
