#pragma once

#include <functional>
#include <memory>

#include "motions.hpp"
#include "time_stepping/stepper.hpp"

namespace stokesbook::verification::time_stepping {

/// Wraps a right-hand side and counts its evaluations.
class Counted {
 public:
  /// Wraps a right-hand side.
  explicit Counted(Rate rate) : rate_(std::move(rate)) {}

  /// Returns the counting right-hand side; its copies share the count.
  Rate rate() const;

  /// Returns the number of evaluations so far.
  double evaluations() const { return static_cast<double>(*count_); }

 private:
  Rate rate_;
  std::shared_ptr<long long> count_ = std::make_shared<long long>(0);
};

/// Makes the rates of a step from a right-hand side, unchanged or with a planted defect.
using MakeRates = std::function<Rates(const Rate& rate, const TimePoint& start)>;

/// Returns the rates unchanged.
Rates same_rates(const Rate& rate, const TimePoint& start);

/// A planted defect: the stages use the state at the start of their step.
Rates frozen_stages(const Rate& rate, const TimePoint& start);

/// A planted defect: the rates are one per cent too small.
Rates slow_rates(const Rate& rate, const TimePoint& start);

/// Holds the result of a run.
struct RunResult {
  double error = 0.0;             ///< largest error at the times at which the solution is known
  double evaluations = 0.0;       ///< evaluations of the right-hand side
  Eigen::VectorXd state;          ///< state at the end
  Eigen::VectorXd estimate;       ///< sum of the error estimates of all steps
  Eigen::VectorXd last_estimate;  ///< error estimate of the last step
};

/// Returns the largest error of a state; 0 if the solution is not known at t.
double error_at(const Motion& motion, double t, const Eigen::VectorXd& state);

/// Runs any of the methods with equal steps.
RunResult run_equal_steps(const Motion& motion, SteppingMethod method, int steps,
                          const MakeRates& make_rates = same_rates);

/// Runs to a tolerance; each step has half of the tolerance, see stepping_settings(). Lengths and
/// angles count in units of `scale`.
RunResult run_to_tolerance(const Motion& motion, SteppingMethod method, double tolerance,
                           double scale = 1.0);

}  // namespace stokesbook::verification::time_stepping
