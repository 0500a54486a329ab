// Exercise 09.2: what does not come back.
#include "chapters/exercise.hpp"

#include <cmath>
#include <functional>

#include <Eigen/Core>

using Eigen::VectorXd;
using stokesbook::exercise::not_done;

// f(q) of q' = f(q), and one step of a method: the state after the time h.
using Flow = std::function<VectorXd(const VectorXd& q)>;
using Method = std::function<VectorXd(const Flow& f, const VectorXd& q, double h)>;

// Task 1: |end - start| after M steps forward until t_end and M steps of the reversed flow.
double return_error(const Method& step, const Flow& f, const VectorXd& start, double t_end,
                    int steps) {
  //@ starter
  not_done(step, f, start, t_end, steps);  // your code instead of this line
  //@ solution
  const Flow reversed = [&](const VectorXd& q) -> VectorXd { return -f(q); };
  VectorXd q = start;
  for (int k = 0; k < steps; ++k) q = step(f, q, t_end / steps);
  for (int k = 0; k < steps; ++k) q = step(reversed, q, t_end / steps);
  return (q - start).norm();
  //@ wrong onwards: the flow has not been reversed
  VectorXd q = start;
  for (int k = 0; k < 2 * steps; ++k) q = step(f, q, t_end / steps);
  return (q - start).norm();
  //@ wrong half_way: this turns back at t_end/2
  const Flow reversed = [&](const VectorXd& q) -> VectorXd { return -f(q); };
  const double h = 0.5 * t_end / steps;
  VectorXd q = start;
  for (int k = 0; k < steps; ++k) q = step(f, q, h);
  for (int k = 0; k < steps; ++k) q = step(reversed, q, h);
  return (q - start).norm();
  //@ end
}

// Task 2: p of errors C M^-p.
double measured_order(const VectorXd& steps, const VectorXd& errors) {
  //@ starter
  not_done(steps, errors);  // your code instead of this line
  //@ solution
  const VectorXd x = steps.array().log(), y = errors.array().log();
  const VectorXd centred = x.array() - x.mean();
  return -centred.dot(y) / centred.squaredNorm();
  //@ wrong semi_logarithmic: this is a rate: steps need a logarithm too
  const VectorXd centred = steps.array() - steps.mean();
  return -centred.dot(errors.array().log().matrix()) / centred.squaredNorm();
  //@ end
}

// Task 3: the order of return_error for a Runge-Kutta method of order p.
int order_of_return(int p) {
  //@ starter
  not_done(p);  // your code instead of this line
  //@ solution
  return p % 2 == 0 ? p + 1 : p;
  //@ wrong unchanged: methods of even order gain one
  return p;
  //@ wrong other_parity: the errors of both ways add up where p is odd
  return p % 2 == 0 ? p : p + 1;
  //@ end
}

// Task 4: steps for a tolerance, not rounded, if M steps have an error and the order is p.
double steps_needed(double tolerance, double error, double steps, double p) {
  //@ starter
  not_done(tolerance, error, steps, p);  // your code instead of this line
  //@ solution
  return steps * std::pow(error / tolerance, 1.0 / p);
  //@ wrong power: the order is a root here
  return steps * std::pow(error / tolerance, p);
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
