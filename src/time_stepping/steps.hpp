#pragma once

#include <functional>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// Right-hand side of \f$ \dot q = f(t, q) \f$: the rate of change, ordered as q.
using Rate = std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& q)>;

/// The step before, which Adams-Bashforth 2 extrapolates from.
struct PreviousStep {
  double dt = 0.0;       ///< length of the step before, > 0
  Eigen::VectorXd rate;  ///< f at its beginning, ordered as the state
};

/// Advances by explicit Euler, \f$ q + h f \f$.
///
/// GSL's steppers are not used for fixed steps: they have no Adams-Bashforth of fixed order, and
/// their Runge-Kutta 4 doubles every step for an error estimate, three times the evaluations.
/// @param  q     state at t, n numbers
/// @param  dt    h, the step, time
/// @param  rate  f(t, q), n numbers
/// @return       state at t + h
/// @par Accuracy  order 1
/// @par Cost      one evaluation of f, by the caller
Eigen::VectorXd euler_step(const Eigen::VectorXd& q, double dt, const Eigen::VectorXd& rate);

/// Advances by Adams-Bashforth 2 with variable steps,
/// \f$ q + h \left[(1 + \tfrac{r}{2}) f_n - \tfrac{r}{2} f_{n-1}\right],\ r = h/h_{n-1} \f$.
///
/// @param  q         state at t, n numbers
/// @param  dt        h, the step, time
/// @param  rate      f(t, q), n numbers
/// @param  previous  the step before; start with runge_kutta4_step() where there is none
/// @return           state at t + h
/// @par Accuracy  order 2
/// @par Cost      one evaluation of f, by the caller
/// @par Not for   the step after f has jumped: the extrapolation would reach across
Eigen::VectorXd adams_bashforth2_step(const Eigen::VectorXd& q, double dt,
                                      const Eigen::VectorXd& rate, const PreviousStep& previous);

/// Advances by the classical Runge-Kutta scheme.
///
/// @param  f     right-hand side, evaluated at two stages in the middle and one at the end
/// @param  t     time
/// @param  q     state at t, n numbers
/// @param  dt    h, the step, time
/// @param  rate  f(t, q), n numbers
/// @return       state at t + h
/// @par Accuracy  order 4
/// @par Cost      four evaluations of f, the first by the caller
Eigen::VectorXd runge_kutta4_step(const Rate& f, double t, const Eigen::VectorXd& q, double dt,
                                  const Eigen::VectorXd& rate);

/// @}

}  // namespace stokesbook
