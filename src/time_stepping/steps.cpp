#include "time_stepping/steps.hpp"

namespace stokesbook {

using Eigen::VectorXd;

VectorXd euler_step(const VectorXd& q, double dt, const VectorXd& rate) {
  return q + dt * rate;
}

VectorXd adams_bashforth2_step(const VectorXd& q, double dt, const VectorXd& rate,
                               const PreviousStep& previous) {
  const double half_ratio = 0.5 * dt / previous.dt;
  return q + dt * ((1.0 + half_ratio) * rate - half_ratio * previous.rate);
}

VectorXd runge_kutta4_step(const Rate& f, double t, const VectorXd& q, double dt,
                           const VectorXd& rate) {
  const VectorXd k2 = f(t + 0.5 * dt, q + 0.5 * dt * rate);
  const VectorXd k3 = f(t + 0.5 * dt, q + 0.5 * dt * k2);
  const VectorXd k4 = f(t + dt, q + dt * k3);
  return q + dt / 6.0 * (rate + 2.0 * k2 + 2.0 * k3 + k4);
}

}  // namespace stokesbook
