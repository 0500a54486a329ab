// Exercise 11.3: forces that cannot be taken back, and forces that pull.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Core>

using Eigen::Vector2d;
using stokesbook::exercise::not_done;

using Function = std::function<double(double)>;

// Task 1: the velocity after iterations for the total force.
double total_loop(const Function& gap, const Function& slope, double u_free, int iterations) {
  //@ starter
  not_done(gap, slope, u_free, iterations);  // your code instead of this line
  //@ solution
  double u = u_free;
  for (int k = 0; k < iterations; ++k) {
    const double s = slope(u), without = gap(u) + s * (u_free - u);
    u = u_free + s * std::max(0.0, -without / (s * s));
  }
  return u;
  //@ wrong stale: the gap is linearised at u, not at u_free
  double u = u_free;
  for (int k = 0; k < iterations; ++k) {
    const double s = slope(u);
    u = u_free + s * std::max(0.0, -gap(u) / (s * s));
  }
  return u;
  //@ end
}

// Task 2: the same for increments of the force.
double increment_loop(const Function& gap, const Function& slope, double u_free, int iterations) {
  //@ starter
  not_done(gap, slope, u_free, iterations);  // your code instead of this line
  //@ solution
  double u = u_free;
  for (int k = 0; k < iterations; ++k) {
    const double s = slope(u);
    u += s * std::max(0.0, -gap(u) / (s * s));
  }
  return u;
  //@ wrong pulls: this increment may be negative
  double u = u_free;
  for (int k = 0; k < iterations; ++k) u -= gap(u) / slope(u);
  return u;
  //@ end
}

// Task 3: u_free for which an increment leaves this gap; the gap is e^u - 1/2.
double breaking_velocity(double left) {
  //@ starter
  not_done(left);  // your code instead of this line
  //@ solution
  double low = -20.0, high = std::log(0.5);
  for (int bisection = 0; bisection < 100; ++bisection) {
    const double u = 0.5 * (low + high), next = u - (std::exp(u) - 0.5) * std::exp(-u);
    (std::exp(next) - 0.5 > left ? low : high) = u;
  }
  return low;
  //@ wrong depth: this is how deep the free motion goes, not what is left after the increment
  return std::log(0.5 - left);
  //@ end
}

// Task 4: q for which the naive answer violates the first gap by 1.
Vector2d naive_pull() {
  //@ starter
  not_done();  // your code instead of this line
  //@ solution
  return {-3.0, 3.0};  // M z = -q has z = (1, -1)
  //@ wrong harmless: the naive answer is right here
  return {-2.0, -2.0};
  //@ end
}
