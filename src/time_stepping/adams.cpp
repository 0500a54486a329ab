// Advances by one step of Adams-Bashforth 2 with variable step lengths (09.5), and estimates the
// error of any step by the implicit formula of Adams (09.8), without another evaluation of the
// rate.
#include "time_stepping/adams.hpp"

namespace stokesbook {

using Eigen::VectorXd;

// [step]
VectorXd adams_bashforth2_step(const TimePoint& start, double dt, const PreviousStep& previous) {
  const double half_ratio = 0.5 * dt / previous.dt;
  return start.state + dt * ((1.0 + half_ratio) * start.rate - half_ratio * previous.rate);
}
// [step]

// [error]
VectorXd adams_moulton_error(const Step& step, const std::optional<PreviousStep>& previous) {
  const auto& [start, end, bubble] = step;
  VectorXd mean_rate = 0.5 * (start.rate + end.rate);
  if (previous) {
    const double r = step.dt() / previous->dt;
    mean_rate -=
        r / (6.0 * (1.0 + r)) * (end.rate - start.rate - r * (start.rate - previous->rate));
  }
  return start.state + step.dt() * mean_rate - end.state;
}
// [error]

}  // namespace stokesbook
