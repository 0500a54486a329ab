// Advances by one step of Adams-Bashforth 2 with variable step lengths (09.5).
#include "time_stepping/adams_bashforth.hpp"

namespace stokesbook {

using Eigen::VectorXd;

// [step]
VectorXd adams_bashforth2_step(const TimePoint& start, double dt, const PreviousStep& previous) {
  const double half_ratio = 0.5 * dt / previous.dt;
  return start.state + dt * ((1.0 + half_ratio) * start.rate - half_ratio * previous.rate);
}
// [step]

}  // namespace stokesbook
