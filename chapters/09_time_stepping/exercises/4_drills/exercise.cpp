// Exercise 09.4: five drills on steps and their errors.
#include "chapters/exercise.hpp"

#include <cmath>

#include <Eigen/Core>

using Eigen::VectorXd;
using stokesbook::exercise::not_done;

// Task 1: the end of Euler's step minus the exact state, to leading order.
double euler_error(double h, double rate, double derivative_of_rate) {
  //@ starter
  not_done(h, rate, derivative_of_rate);  // your code instead of this line
  //@ solution
  return -0.5 * h * h * derivative_of_rate * rate;
  //@ wrong other_sign: this is exact minus Euler
  return 0.5 * h * h * derivative_of_rate * rate;
  //@ wrong no_half: Taylor's formula has a half here
  return -h * h * derivative_of_rate * rate;
  //@ wrong no_chain: the chain rule gives a factor f
  (void)rate;
  return -0.5 * h * h * derivative_of_rate;
  //@ end
}

// Task 2: the weight of the second of two stages, at the time c h, for the order two.
double second_weight(double c) {
  //@ starter
  not_done(c);  // your code instead of this line
  //@ solution
  return 0.5 / c;
  //@ wrong always_heun: this is the weight for c = 1
  (void)c;
  return 0.5;
  //@ wrong product: divide by c
  return 0.5 * c;
  //@ end
}

// Task 3: the length of the step with the scaled error 1, from a step that has the error e.
double length_allowed(double h, double error, int m) {
  //@ starter
  not_done(h, error, m);  // your code instead of this line
  //@ solution
  return h * std::pow(error, -1.0 / m);
  //@ wrong longer: an error above 1 makes the step shorter
  return h * std::pow(error, 1.0 / m);
  //@ wrong in_proportion: as if errors fell in proportion to h
  (void)m;
  return h / error;
  //@ end
}

// Task 4: the factor by which the number of steps grows, for a number of digits.
double more_steps(int order, double digits) {
  //@ starter
  not_done(order, digits);  // your code instead of this line
  //@ solution
  return std::pow(10.0, digits / order);
  //@ wrong one_step: the order of the error of one step
  return std::pow(10.0, digits / (order + 1));
  //@ wrong euler: as if the order were one
  (void)order;
  return std::pow(10.0, digits);
  //@ end
}

// Task 5: the weights of the last densities in the guess of the next one, the newest first.
VectorXd guess_weights(int count) {
  //@ starter
  not_done(count);  // your code instead of this line
  //@ solution
  VectorXd weights(count);
  weights[0] = count;
  for (int j = 1; j < count; ++j) weights[j] = -weights[j - 1] * (count - j) / (j + 1.0);
  return weights;
  //@ wrong oldest_first: the newest density comes first
  VectorXd weights(count);
  weights[0] = count;
  for (int j = 1; j < count; ++j) weights[j] = -weights[j - 1] * (count - j) / (j + 1.0);
  return weights.reverse();
  //@ wrong no_signs: the signs alternate
  VectorXd weights(count);
  weights[0] = count;
  for (int j = 1; j < count; ++j) weights[j] = weights[j - 1] * (count - j) / (j + 1.0);
  return weights;
  //@ wrong mean: the mean does not extrapolate
  return VectorXd::Constant(count, 1.0 / count);
  //@ end
}
