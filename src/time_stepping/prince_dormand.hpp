#pragma once

#include "time_stepping/rate.hpp"

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// End of a step, and how far off it may be.
struct EstimatedEnd {
  Eigen::VectorXd end;    ///< state at t + h
  Eigen::VectorXd error;  ///< estimate of the step's error, ordered as the state
};

/// Advances by the pair 8(7) of Prince and Dormand, for tight tolerances.
///
/// The thirteen stages are those of GSL's `rk8pd`, called for one step at a time. GSL's own control
/// of steps is not used: its norm knows no bodies, its state cannot be resumed, it gives up at the
/// first state without a rate, and no method of it interpolates.
/// @param  f      right-hand side; what it throws is thrown on
/// @param  start  of the step, n numbers
/// @param  dt     h, the step, time
/// @return        state at t + h and the estimate of its error
/// @par Accuracy  order 8, @ref claim_09_7; the estimate is a fifth of GSL's, which is the error of
///                the lower order alone, of order h^8, @ref claim_09_19
/// @par Cost      12 evaluations of f
/// @sa source: Prince, Dormand, J. Comput. Appl. Math. 7 (1981), 67
EstimatedEnd prince_dormand87_step(const Rate& f, const TimePoint& start, double dt);

/// @}

}  // namespace stokesbook
