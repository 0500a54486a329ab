// Exercise 06.2: a finer rule, and a polynomial in the distance.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "double_layer/stresslet_sum.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: velocities at targets by sigma fine nodes a node. The density is given at the n nodes.
ComplexVector fine_velocity(const Shape& shape, Side side, const ComplexVector& density, int sigma,
                            const ComplexVector& targets) {
  //@ starter
  not_done(shape, side, density, sigma, targets);  // your code instead of this line
  //@ solution
  const Eigen::Index n = sigma * density.size();
  return StressletSum({sample(shape, n, side)})(targets, resample(density, n));
  //@ wrong repeated: the density is repeated
  const Eigen::Index n = sigma * density.size();
  const ComplexVector steps =
      ComplexVector::NullaryExpr(n, [&](Eigen::Index j) { return density[j / sigma]; });
  return StressletSum({sample(shape, n, side)})(targets, steps);
  //@ wrong coarse: this is the rule with the coarse nodes
  static_cast<void>(sigma);
  return StressletSum({sample(shape, density.size(), side)})(targets, density);
  //@ end
}

// Task 2: the distance in coarse spacings with 200 exp(-2 pi sigma d) = tolerance.
double reach(int sigma, double tolerance) {
  //@ starter
  not_done(sigma, tolerance);  // your code instead of this line
  //@ solution
  return std::log(200.0 / tolerance) / (2.0 * pi * sigma);
  //@ wrong fine_spacings: this counts spacings of the fine nodes
  static_cast<void>(sigma);
  return std::log(200.0 / tolerance) / (2.0 * pi);
  //@ end
}

// Task 3: weights of the values at 0, 1, ..., degree in the value at a point.
std::vector<double> lagrange(int degree, double point) {
  //@ starter
  not_done(degree, point);  // your code instead of this line
  //@ solution
  std::vector<double> weights;
  for (int j = 0; j <= degree; ++j) {
    double weight = 1.0;
    for (int k = 0; k <= degree; ++k) {
      if (k != j) weight *= (point - k) / (j - k);
    }
    weights.push_back(weight);
  }
  return weights;
  //@ wrong from_one: the first node is 0
  std::vector<double> weights;
  for (int j = 1; j <= degree + 1; ++j) {
    double weight = 1.0;
    for (int k = 1; k <= degree + 1; ++k) {
      if (k != j) weight *= (point - k) / (j - k);
    }
    weights.push_back(weight);
  }
  return weights;
  //@ end
}

// Task 4: velocity at a distance in spacings, from the density and the layer's integral at the
// foot, and the velocities at 1, 2, ... spacings.
Complex close_velocity(Complex density_at_foot, Complex layer_at_foot,
                       const std::vector<Complex>& farther, double distance) {
  //@ starter
  not_done(density_at_foot, layer_at_foot, farther, distance);  // your code instead of this line
  //@ solution
  const std::vector<double> weights = lagrange(static_cast<int>(farther.size()), distance);
  Complex velocity = weights.front() * (layer_at_foot - 0.5 * density_at_foot);
  for (std::size_t j = 0; j < farther.size(); ++j) velocity += weights[j + 1] * farther[j];
  return velocity;
  //@ wrong no_jump: the jump is missing
  static_cast<void>(density_at_foot);
  const std::vector<double> weights = lagrange(static_cast<int>(farther.size()), distance);
  Complex velocity = weights.front() * layer_at_foot;
  for (std::size_t j = 0; j < farther.size(); ++j) velocity += weights[j + 1] * farther[j];
  return velocity;
  //@ wrong other_side: this is the limit on the other side
  const std::vector<double> weights = lagrange(static_cast<int>(farther.size()), distance);
  Complex velocity = weights.front() * (layer_at_foot + 0.5 * density_at_foot);
  for (std::size_t j = 0; j < farther.size(); ++j) velocity += weights[j + 1] * farther[j];
  return velocity;
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
