#pragma once

#include "time_stepping/rate.hpp"

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// What an error of each number is measured against.
struct ErrorBound {
  double tolerance = 0.0;  ///< error allowed, in units of the scale, > 0
  Eigen::VectorXd scale;   ///< n numbers > 0: what counts as one

  /// Measures an error.
  /// @param  error  n numbers
  /// @return        the largest |error_i| / scale_i
  double in_units_of_scale(const Eigen::VectorXd& error) const;

  /// Measures an error against what is allowed.
  /// @param  error  n numbers
  /// @return        the largest |error_i| / (tolerance scale_i)
  double operator()(const Eigen::VectorXd& error) const {
    return in_units_of_scale(error) / tolerance;
  }
};

/// Chooses by how much the next step is longer, in proportion to the error and to its history:
/// \f$ 0.9\,e_n^{-0.7/k}\,e_{n-1}^{0.4/k} \f$, at least 1/5 and at most 5.
///
/// The power of the error before damps the swing between steps too long and too short.
/// @param  error     e_n, the scaled error of the last step
/// @param  previous  e_{n-1}, that of the step before it, <= 1; less than 1e-4 counts as 1e-4
/// @param  order     k: a step's estimate is of order h^k
/// @return           factor of the step's length; < 0.9 where e_n > 1
/// @sa source: Gustafsson, ACM Trans. Math. Softw. 17 (1991), 533; Hairer, Wanner, Solving Ordinary
///             Differential Equations II, IV.2
double step_factor(double error, double previous, int order);

/// Chooses the first step. A trial step by Euler, a hundredth of the time in which q changes by its
/// scale, shows the second derivative; from that comes the step whose error is a hundredth of what
/// is allowed, but no longer than a hundred trial steps.
///
/// @param  f      right-hand side
/// @param  start  n numbers
/// @param  bound  of a step's error
/// @param  order  k: a step's estimate is of order h^k
/// @return        h > 0, time; infinite where the state does not move; the trial step where it
///                meets an InadmissibleState
/// @par Cost      one evaluation of f
/// @sa source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.4
double first_step(const Rate& f, const TimePoint& start, const ErrorBound& bound, int order);

/// @}

}  // namespace stokesbook
