#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "closure/closure.hpp"
#include "fmm/fmm.hpp"
#include "stress/solved_flow.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// Evaluates the double layer and the singularities of a problem with n nodes by the fast multipole
/// method; in a periodic cell, with all their images.
///
/// The applications of one object share scratch memory: they must not run in two threads at a time.
/// @par Accuracy  the tolerance, relative in the 2-norm of velocities, @ref claim_08_15
class FastSum {
 public:
  /// Plans the sum at m targets, none of them the centre of a loaded component.
  ///
  /// @param  targets  empty: the nodes themselves
  /// @par Cost        O(n log n + m log m)
  FastSum(const StokesProblem& problem, double tolerance, const ComplexVector& targets = {});

  /// Evaluates the velocity that a density at all n nodes, length / time, and loads of all
  /// components cause at the targets, by O(n + m) operations.
  ComplexVector velocity(const ComplexVector& density, const std::vector<Load>& loads) const;

  /// Returns the vectors of the near images in a periodic cell, length; empty without a cell.
  std::vector<Complex> near_images() const;

  /// Evaluates pressure, vorticity and strain of the same flow, 1 / time. In a periodic cell, the
  /// constant of the pressure is that of SolvedFlow.
  ///
  /// @par Accuracy  a hundred times the tolerance, @ref claim_08_18
  std::vector<FlowDerivatives> derivatives(const ComplexVector& density,
                                           const std::vector<Load>& loads) const;

 private:
  // Returns forces and torques of the loaded components, over the viscosity.
  std::pair<ComplexVector, Eigen::VectorXd> strengths(const std::vector<Load>& loads) const;

  std::vector<std::size_t> loaded_;  // components that may have singularities
  std::vector<double> log_gauges_;   // logarithms of the gauge lengths of their Stokeslets
  double viscosity_;
  ComplexVector centres_;  // of the loaded components
  std::optional<PeriodicCell> cell_;
  Fmm fmm_;
  mutable FmmWorkspace workspace_;
};

/// Returns a sum that evaluates a SolvedFlow at targets by a FastSum or directly, whichever the
/// plan expects to be faster for their number. Every call plans anew.
FlowSum planned_sum(const Plan& plan);

}  // namespace stokesbook
