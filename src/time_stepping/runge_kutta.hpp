#pragma once

#include "time_stepping/step.hpp"

namespace stokesbook {

/// Coefficients of an explicit Runge-Kutta scheme of s stages,
/// \f$ k_i = f\left(t + c_i h, q + h\sum_{j<i}a_{ij}k_j\right),\ c_i = \sum_ja_{ij} \f$, whose step
/// ends at \f$ q_1 = q + h\sum_jb_jk_j \f$ (09.6).
///
/// The last of the s + 1 weights of the estimate and of the bubble belongs to the rate at the end
/// of the step. The next step begins with this rate, so that the rate costs no additional
/// evaluation ("first same as last").
struct Tableau {
  Eigen::MatrixXd a;            ///< s x s, strictly lower triangular
  Eigen::VectorXd b;            ///< s weights of the end
  Eigen::VectorXd error = {};   ///< s + 1 weights of the estimate; empty: no estimate
  Eigen::VectorXd bubble = {};  ///< s + 1 weights of the bubble in Step; empty: no bubble
};

/// Returns the explicit Euler scheme: order 1, one stage.
const Tableau& euler();

/// Returns Heun's scheme, the trapezoid rule with an Euler step as predictor (09.4): order 2, two
/// stages.
const Tableau& heun();

/// Returns the classical Runge-Kutta scheme: order 4 with an estimate of order 3, four stages.
///
/// The estimate is the difference between the end and another end of order 3, in which the rate at
/// the end replaces the last stage. GSL's scheme has the same stages, but repeats every step by two
/// halves for its estimate, which takes three times as many evaluations.
const Tableau& runge_kutta4();

/// Returns the pair of Bogacki and Shampine: order 3 with an estimate of order 2, three stages.
///
/// @sa source: Bogacki, Shampine, Appl. Math. Lett. 2 (1989), 321
const Tableau& bogacki_shampine32();

/// Returns the pair of Dormand and Prince with the interpolant of order 4: order 5 with an estimate
/// of order 4, six stages. GSL has neither this pair nor an interpolant for any pair.
///
/// @sa source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.5 and II.6
const Tableau& dormand_prince54();

/// Evaluates the s stages (09.6) of a step of length h = dt.
///
/// @param  start  start of the step, n numbers; its rate is the first stage
/// @return        n x s rates, one stage per column
/// @par Cost      s - 1 evaluations of f
Eigen::MatrixXd runge_kutta_stages(const Tableau& tableau, const Rate& f, const TimePoint& start,
                                   double dt);

/// The end of a step, and an estimate of its error.
struct EstimatedEnd {
  Eigen::VectorXd end;    ///< state at t + h
  Eigen::VectorXd error;  ///< estimate of the step's error, ordered as the state
};

/// Advances by a step dt of the pair 8(7) of Prince and Dormand, for tight tolerances.
///
/// The thirteen stages are those of GSL's `rk8pd`, called for one step at a time. GSL's own step
/// control is not used: its norm does not distinguish bodies, its state cannot be saved and
/// restored, it stops at the first state for which the rate is not defined, and no GSL method
/// interpolates.
/// @param  f      right-hand side; exceptions of f are passed on to the caller
/// @par Accuracy  order 8, @ref claim_09_7; the estimate is a fifth of GSL's estimate, which is the
///                error of the lower order alone, of order h^8, @ref claim_09_19
/// @par Cost      12 evaluations of f
/// @sa source: Prince, Dormand, J. Comput. Appl. Math. 7 (1981), 67
EstimatedEnd prince_dormand87_step(const Rate& f, const TimePoint& start, double dt);

}  // namespace stokesbook
