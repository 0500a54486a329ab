#pragma once

#include <optional>

#include "time_stepping/step.hpp"

namespace stokesbook {

/// The previous step, from which the formulas of Adams extrapolate.
struct PreviousStep {
  double dt = 0.0;       ///< length of the previous step, > 0
  Eigen::VectorXd rate;  ///< f at the beginning of the previous step, ordered as the state
};

/// Advances by Adams-Bashforth 2 with variable steps,
/// \f$ q + h \left[(1 + \tfrac{r}{2}) f_n - \tfrac{r}{2} f_{n-1}\right],\ r = h/h_{n-1} \f$ (09.5).
///
/// @return        state at t + h, where h = dt
/// @par Accuracy  order 2, @ref claim_09_2
/// @par Cost      one evaluation of f a step, by the caller
/// @par Not for   the step after a jump of f: the extrapolation would reach across the jump
Eigen::VectorXd adams_bashforth2_step(const TimePoint& start, double dt,
                                      const PreviousStep& previous);

/// Estimates the error of a step by the implicit formula of Adams: integrates the parabola through
/// the rates at both ends of the step and at the beginning of the previous step,
/// \f$ q_0 + h\left[\tfrac12(f_0 + f_1) - \tfrac16d\right] - q_1 \f$ with
/// \f$ d = \frac{r}{1+r}\left[f_1 - f_0 - r(f_0 - f_{-1})\right],\ r = h/h_{-1} \f$ (09.8).
///
/// @param  previous  none: the rate is interpolated by a straight line, d = 0
/// @return           corrected end minus end of the step
/// @par Accuracy  up to terms of the next order, the error of the step for methods of order 1 and,
///                with a previous step, of order 2: @ref claim_09_36 to @ref claim_09_38
/// @par Cost      no evaluation of f
/// @par Not for   the step after a jump of f, together with the previous step
/// @sa source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, III.1 and III.5
Eigen::VectorXd adams_moulton_error(const Step& step, const std::optional<PreviousStep>& previous);

}  // namespace stokesbook
