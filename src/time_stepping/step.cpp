// Interpolates the state within a step by Hermite's cubic and a quartic bubble (09.11).
#include "time_stepping/step.hpp"

namespace stokesbook {

using Eigen::VectorXd;

// [interpolate]
// (09.11) with s = theta
VectorXd interpolate(const Step& step, double t) {
  const double h = step.dt(), s = (t - step.start.t) / h, r = 1.0 - s;
  const VectorXd change = step.end.state - step.start.state;
  const VectorXd bend = r * (h * step.start.rate - change) - s * (h * step.end.rate - change);
  VectorXd state = step.start.state + s * change + s * r * bend;
  if (step.bubble.size() > 0) state += s * s * r * r * h * step.bubble;
  return state;
}
// [interpolate]

}  // namespace stokesbook
