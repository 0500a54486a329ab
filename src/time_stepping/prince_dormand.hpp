#pragma once

#include "time_stepping/step.hpp"

namespace stokesbook {

/// The end of a step, and an estimate of its error.
struct EstimatedEnd {
  Eigen::VectorXd end;    ///< state at t + h
  Eigen::VectorXd error;  ///< estimate of the step's error, ordered as the state
};

/// Advances by the pair 8(7) of Prince and Dormand, for tight tolerances.
///
/// The thirteen stages are those of GSL's `rk8pd`, called for one step at a time. GSL's own step
/// control is not used: its norm does not distinguish bodies, its state cannot be saved and
/// restored, it stops at the first state for which the rate is not defined, and no GSL method
/// interpolates.
/// @param  f      right-hand side; exceptions of f are passed on to the caller
/// @param  start  start of the step, n numbers
/// @param  dt     h, length of the step, time
/// @par Accuracy  order 8, @ref claim_09_7; the estimate is a fifth of GSL's estimate, which is the
///                error of the lower order alone, of order h^8, @ref claim_09_19
/// @par Cost      12 evaluations of f
/// @sa source: Prince, Dormand, J. Comput. Appl. Math. 7 (1981), 67
EstimatedEnd prince_dormand87_step(const Rate& f, const TimePoint& start, double dt);

}  // namespace stokesbook
