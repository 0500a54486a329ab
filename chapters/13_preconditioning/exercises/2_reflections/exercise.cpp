// Exercise 13.2: the method of reflections, and how fast it is.
#include "chapters/exercise.hpp"

#include <cmath>

#include "krylov/gmres.hpp"

using stokesbook::LinearMap;
using stokesbook::exercise::not_done;

// Task 1: x after so many rounds, starting from zero.
Eigen::VectorXd reflected(const LinearMap& apply, const LinearMap& solve_blocks,
                          const Eigen::VectorXd& b, int rounds) {
  //@ starter
  not_done(apply, solve_blocks, b, rounds);  // your code instead of this line
  //@ solution
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  for (int round = 0; round < rounds; ++round) x += solve_blocks(b - apply(x));
  return x;
  //@ wrong without_blocks: the blocks are not solved for
  static_cast<void>(solve_blocks);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  for (int round = 0; round < rounds; ++round) x += b - apply(x);
  return x;
  //@ wrong forgetful: a round adds to x, it does not replace it
  Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
  for (int round = 0; round < rounds; ++round) x = solve_blocks(b - apply(x));
  return x;
  //@ end
}

// Task 2: factor of the error a round, in the long run, for two unit circles.
double contraction(double gap) {
  //@ starter
  not_done(gap);  // your code instead of this line
  //@ solution
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  return std::exp(-4.0 * alpha + std::asinh(2.0 * std::sinh(2.0 * alpha)));
  //@ wrong two_rounds: this is the factor of two rounds
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  return std::exp(2.0 * (-4.0 * alpha + std::asinh(2.0 * std::sinh(2.0 * alpha))));
  //@ wrong cluster: this is how the eigenvalues fall from mode to mode
  return std::exp(-2.0 * std::acosh(1.0 + 0.5 * gap));
  //@ end
}

// Task 3: least number of rounds with contraction^rounds <= tolerance.
int rounds_needed(double gap, double tolerance) {
  //@ starter
  not_done(gap, tolerance);  // your code instead of this line
  //@ solution
  return static_cast<int>(std::ceil(std::log(tolerance) / std::log(contraction(gap))));
  //@ wrong decades: a logarithm to the base 10 over a natural one
  return static_cast<int>(std::ceil(std::log10(tolerance) / std::log(contraction(gap))));
  //@ end
}

// Task 4 is an experiment with these functions. You find it in the book's check.cpp.
