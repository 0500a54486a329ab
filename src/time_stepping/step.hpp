#pragma once

#include "time_stepping/rate.hpp"

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// A step that was taken, with the data of its interpolant.
struct Step {
  TimePoint start;              ///< n numbers
  TimePoint end;                ///< later than the start
  Eigen::VectorXd bubble = {};  ///< beta of (09.10), n numbers; empty: no bubble

  /// Returns the length of the step.
  /// @return h > 0, time
  double dt() const { return end.t - start.t; }
};

/// Evaluates the solution within a step: the cubic through states and rates at both ends, plus
/// \f$ \theta^2(1 - \theta)^2\,h \f$ times the bubble at \f$ \theta = (t - t_0)/h \f$ (09.10).
///
/// @param  step  step that contains t
/// @param  t     time
/// @return       state, n numbers
/// @par Accuracy  the error within one step is of order h^4 for the cubic, as the error of a step
///                by Bogacki and Shampine: @ref claim_09_15; of order h^5 with the bubble of
///                Dormand and Prince, one order less than the error of their step: @ref claim_09_16
/// @par Cost      no evaluation of f
/// @par Not for   steps by prince_dormand87_step(), which are far more accurate
/// @sa source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.6
Eigen::VectorXd interpolate(const Step& step, double t);

/// @}

}  // namespace stokesbook
