#pragma once

#include <functional>
#include <memory>

#include "motions.hpp"
#include "time_stepping/stepper.hpp"

namespace stokesbook::verification::time_stepping {

/// A right-hand side that counts its evaluations.
class Counted {
 public:
  /// Takes the right-hand side.
  explicit Counted(Rate rate) : rate_(std::move(rate)) {}

  /// Evaluates it; copies of the result share the count.
  Rate rate() const;

  /// Evaluations so far.
  double evaluations() const { return static_cast<double>(*count_); }

 private:
  Rate rate_;
  std::shared_ptr<long long> count_ = std::make_shared<long long>(0);
};

/// Makes the rates of a step, right or with a planted defect, of a right-hand side.
using MakeRates = std::function<Rates(const Rate& rate, const TimePoint& start)>;

/// As they are.
Rates same_rates(const Rate& rate, const TimePoint& start);

/// Stages see the state at the start of their step.
Rates frozen_stages(const Rate& rate, const TimePoint& start);

/// One per cent too slow.
Rates slow_rates(const Rate& rate, const TimePoint& start);

/// What a run has come to.
struct RunResult {
  double error = 0.0;             ///< largest where the solution is known
  double evaluations = 0.0;       ///< of the right-hand side
  Eigen::VectorXd state;          ///< at the end
  Eigen::VectorXd estimate;       ///< of the errors of all steps, added up
  Eigen::VectorXd last_estimate;  ///< of the last step's error
};

/// Largest error of a state; 0 where the solution is not known.
double error_at(const Motion& motion, double t, const Eigen::VectorXd& state);

/// Runs with equal steps, whatever the method.
RunResult run_equal_steps(const Motion& motion, SteppingMethod method, int steps,
                          const MakeRates& make_rates = same_rates);

/// Runs to a tolerance, half of it for each step as stepping_settings() has it; lengths and angles
/// count in units of `scale`.
RunResult run_to_tolerance(const Motion& motion, SteppingMethod method, double tolerance,
                           double scale = 1.0);

}  // namespace stokesbook::verification::time_stepping
