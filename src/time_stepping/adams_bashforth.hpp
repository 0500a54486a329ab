#pragma once

#include "time_stepping/rate.hpp"

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// The previous step, from which Adams-Bashforth 2 extrapolates.
struct PreviousStep {
  double dt = 0.0;       ///< length of the previous step, > 0
  Eigen::VectorXd rate;  ///< f at the beginning of the previous step, ordered as the state
};

/// Advances by Adams-Bashforth 2 with variable steps,
/// \f$ q + h \left[(1 + \tfrac{r}{2}) f_n - \tfrac{r}{2} f_{n-1}\right],\ r = h/h_{n-1} \f$ (09.5).
///
/// @param  start     start of the step, n numbers
/// @param  dt        h, length of the step, time
/// @param  previous  the previous step
/// @return           state at t + h
/// @par Accuracy  order 2, @ref claim_09_2
/// @par Cost      one evaluation of f a step, by the caller
/// @par Not for   the step after a jump of f: the extrapolation would reach across the jump
Eigen::VectorXd adams_bashforth2_step(const TimePoint& start, double dt,
                                      const PreviousStep& previous);

/// @}

}  // namespace stokesbook
