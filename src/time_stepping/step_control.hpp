#pragma once

#include "time_stepping/step.hpp"

namespace stokesbook {

/// The largest error that is allowed for each number of a state.
struct ErrorBound {
  double tolerance = 0.0;  ///< error allowed, in units of the scale, > 0
  Eigen::VectorXd scale;   ///< n numbers > 0: the unit of each number's error

  /// Returns the largest |error_i| / scale_i.
  double in_units_of_scale(const Eigen::VectorXd& error) const;

  /// Returns the error over the error that is allowed (09.9): the largest
  /// |error_i| / (tolerance scale_i).
  double operator()(const Eigen::VectorXd& error) const {
    return in_units_of_scale(error) / tolerance;
  }
};

/// Computes the ratio of the next step's length to the last one's from the errors of two steps:
/// \f$ 0.9\,e_n^{-0.7/m}\,e_{n-1}^{0.4/m} \f$ (09.10), at least 1/5 and at most 5.
///
/// The power of \f$ e_{n-1} \f$ damps the alternation of steps that are too long and too short.
/// @param  error     e_n, the scaled error of the last step
/// @param  previous  e_{n-1} of the step before the last, <= 1; less than 1e-4 counts as 1e-4
/// @param  order     m: a step's estimate is of order h^m
/// @return           < 0.9 if e_n > 1
/// @sa source: Gustafsson, ACM Trans. Math. Softw. 17 (1991), 533; Hairer, Wanner, Solving Ordinary
///             Differential Equations II, IV.2
double step_factor(double error, double previous, int order);

/// Chooses the length of the first step.
///
/// A trial step by Euler's scheme yields the second derivative of q. The length of this trial step
/// is a hundredth of the time in which q changes by its scale. The first step is the step whose
/// estimated error is a hundredth of the error allowed, but at most a hundred trial steps.
/// @param  order  m: a step's estimate is of order h^m
/// @return        h > 0, time; infinite if the rate is zero; the trial step if this step meets an
///                InadmissibleState
/// @par Cost      one evaluation of f
/// @sa source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.4
double first_step(const Rate& f, const TimePoint& start, const ErrorBound& bound, int order);

}  // namespace stokesbook
