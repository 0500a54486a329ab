#pragma once

#include <functional>
#include <stdexcept>

#include <Eigen/Core>

namespace stokesbook {

/// Right-hand side of \f$ \dot q = f(t, q) \f$ (09.1): the rate of change, ordered as q.
using Rate = std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& q)>;

/// Thrown by a rate at a state for which the rate is not defined, for example if bodies overlap. A
/// step that meets such a state is repeated with half of its length.
class InadmissibleState : public std::runtime_error {
 public:
  /// Stores the message.
  using std::runtime_error::runtime_error;
};

/// A state at a time, with its rate of change.
struct TimePoint {
  double t = 0.0;         ///< time
  Eigen::VectorXd state;  ///< q, n numbers
  Eigen::VectorXd rate;   ///< f(t, q), n numbers
};

/// A step that was taken, with the data of its interpolant.
struct Step {
  TimePoint start;              ///< n numbers
  TimePoint end;                ///< later than the start
  Eigen::VectorXd bubble = {};  ///< beta of (09.11), n numbers; empty: no bubble

  double dt() const { return end.t - start.t; }  ///< returns the length h > 0 of the step, time
};

/// Evaluates the solution at a time t within a step: the cubic through states and rates at both
/// ends, plus \f$ \theta^2(1 - \theta)^2\,h \f$ times the bubble at
/// \f$ \theta = (t - t_0)/h \f$ (09.11).
///
/// @par Accuracy  the error within one step is of order h^4 for the cubic, as the error of a step
///                by Bogacki and Shampine: @ref claim_09_15; of order h^5 with the bubble of
///                Dormand and Prince, one order less than the error of their step: @ref claim_09_16
/// @par Cost      no evaluation of f
/// @par Not for   steps by prince_dormand87_step(), which are far more accurate
/// @sa source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.6
Eigen::VectorXd interpolate(const Step& step, double t);

}  // namespace stokesbook
