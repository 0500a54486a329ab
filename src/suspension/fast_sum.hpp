#pragma once

#include <vector>

#include "closure/closure.hpp"
#include "fmm/fmm.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Double layer and singularities of a problem at its nodes by the fast multipole method.
///
/// Applications share scratch memory: not in two threads at a time.
class FastSum {
 public:
  /// Plans the sum.
  ///
  /// @param  problem    components with their nodes, n in all
  /// @param  tolerance  of velocities, relative in the 2-norm, > 0
  /// @par Cost          O(n log n)
  FastSum(const StokesProblem& problem, double tolerance);

  /// Evaluates the velocity of layer and singularities.
  ///
  /// @param  density  of the layer at all n nodes, length / time
  /// @param  loads    of every component
  /// @return          velocities at all n nodes, length / time
  /// @par Cost        O(n)
  ComplexVector operator()(const ComplexVector& density, const std::vector<Load>& loads) const;

 private:
  std::vector<std::size_t> loaded_;  // components that may have singularities
  std::vector<double> log_gauges_;   // of their Stokeslets
  double viscosity_;
  Fmm fmm_;
  mutable FmmWorkspace workspace_;
};

/// @}

}  // namespace stokesbook
