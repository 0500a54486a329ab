// Exercise 09.1: two steps of the second order.
#include "chapters/exercise.hpp"

#include <functional>
#include <vector>

#include <Eigen/Core>

using Eigen::Vector2d;
using Eigen::VectorXd;
using stokesbook::exercise::not_done;

using Rate = std::function<VectorXd(double t, const VectorXd& q)>;

// Task 1: (w_1, w_0) with q_2 = q_1 + w_1 f_1 + w_0 f_0, after a step h_0 for a step h_1.
Vector2d weights(double h_0, double h_1) {
  //@ starter
  not_done(h_0, h_1);  // your code instead of this line
  //@ solution
  const double bend = 0.5 * h_1 * h_1 / h_0;
  return {h_1 + bend, -bend};
  //@ wrong equal_steps: these are the weights of equal steps
  static_cast<void>(h_0);
  return {1.5 * h_1, -0.5 * h_1};
  //@ wrong inverted: the ratio is h_1/h_0, not h_0/h_1
  const double bend = 0.5 * h_0;
  return {h_1 + bend, -bend};
  //@ end
}

// Task 2: the state at t + h; f_0 is the rate at (t, q), which the caller has.
VectorXd heun(const Rate& f, double t, const VectorXd& q, const VectorXd& f_0, double h) {
  //@ starter
  not_done(f, t, q, f_0, h);  // your code instead of this line
  //@ solution
  return q + 0.5 * h * (f_0 + f(t + h, q + h * f_0));
  //@ wrong stopped_clock: the second rate belongs to the time t + h
  return q + 0.5 * h * (f_0 + f(t, q + h * f_0));
  //@ wrong midpoint: this is the midpoint rule
  return q + h * f(t + 0.5 * h, q + 0.5 * h * f_0);
  //@ end
}

// Task 3: the states at all times, the first of which is the start.
std::vector<VectorXd> march(const Rate& f, const std::vector<double>& times,
                            const VectorXd& start) {
  //@ starter
  not_done(f, times, start);  // your code instead of this line
  //@ solution
  std::vector<VectorXd> states{start};
  VectorXd before, now = f(times[0], start);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const VectorXd& q = states.back();
    const double h = times[k + 1] - times[k];
    if (k == 0) {
      states.push_back(heun(f, times[0], q, now, h));
    } else {
      const Vector2d w = weights(times[k] - times[k - 1], h);
      states.push_back(q + w[0] * now + w[1] * before);
    }
    before = now;
    if (k + 2 < times.size()) now = f(times[k + 1], states.back());
  }
  return states;
  //@ wrong forgetful: the rate of the step before is computed again
  std::vector<VectorXd> states{start};
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const VectorXd& q = states.back();
    const double h = times[k + 1] - times[k];
    const VectorXd now = f(times[k], q);
    if (k == 0) {
      states.push_back(heun(f, times[0], q, now, h));
    } else {
      const Vector2d w = weights(times[k] - times[k - 1], h);
      states.push_back(q + w[0] * now + w[1] * f(times[k - 1], states[k - 1]));
    }
  }
  return states;
  //@ wrong begun_by_euler: the first step is an Euler step
  std::vector<VectorXd> states{start};
  VectorXd before, now = f(times[0], start);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const VectorXd& q = states.back();
    const double h = times[k + 1] - times[k];
    if (k == 0) {
      states.push_back(q + h * now);
    } else {
      const Vector2d w = weights(times[k] - times[k - 1], h);
      states.push_back(q + w[0] * now + w[1] * before);
    }
    before = now;
    if (k + 2 < times.size()) now = f(times[k + 1], states.back());
  }
  return states;
  //@ end
}
