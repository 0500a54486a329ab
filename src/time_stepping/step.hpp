#pragma once

#include "time_stepping/rate.hpp"

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// A step that was taken, with what its interpolant needs.
struct Step {
  TimePoint start;              ///< n numbers
  TimePoint end;                ///< later than the start
  Eigen::VectorXd bubble = {};  ///< rate beyond the cubic, n numbers; empty: none

  /// Returns the length of the step.
  /// @return h > 0, time
  double dt() const { return end.t - start.t; }
};

/// Evaluates the solution within a step: the cubic through states and rates at both ends, and
/// \f$ \theta^2(1 - \theta)^2\,h \f$ times the bubble at \f$ \theta = (t - t_0)/h \f$.
///
/// @param  step  that contains t
/// @param  t     time
/// @return       state, n numbers
/// @par Accuracy  within one step of order h^4, of order h^5 with the bubble of Dormand and Prince:
///                as the step itself and one less; @ref claim_09_15, @ref claim_09_16
/// @par Cost      no evaluation of f
/// @par Not for   steps by prince_dormand87_step(), which are far more accurate
/// @sa source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.6
Eigen::VectorXd interpolate(const Step& step, double t);

/// @}

}  // namespace stokesbook
