// Exercise 11.2: how many sweeps a row of contacts takes.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

using Eigen::MatrixXd;
using Eigen::VectorXd;
using stokesbook::exercise::not_done;

// Task 1: the forces after a sweep.
VectorXd sweep(const MatrixXd& matrix, const VectorXd& q, const VectorXd& z) {
  //@ starter
  not_done(matrix, q, z);  // your code instead of this line
  //@ solution
  VectorXd latest = z;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const double w = q[i] + matrix.row(i).dot(latest);
    latest[i] = std::max(0.0, latest[i] - w / matrix(i, i));
  }
  return latest;
  //@ wrong jacobi: this takes the forces before the sweep
  const VectorXd w = q + matrix * z;
  return (z - w.cwiseQuotient(matrix.diagonal())).cwiseMax(0.0);
  //@ wrong pulls: forces may not be negative
  VectorXd latest = z;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    latest[i] -= (q[i] + matrix.row(i).dot(latest)) / matrix(i, i);
  }
  return latest;
  //@ end
}

// Task 2: the part of the slowest mode's error that a sweep leaves, for a chain of m contacts.
double left_by_sweep(int m) {
  //@ starter
  not_done(m);  // your code instead of this line
  //@ solution
  const double c = std::cos(std::numbers::pi / (m + 1));
  return c * c;
  //@ wrong root: this is the part that Jacobi's sweep leaves
  return std::cos(std::numbers::pi / (m + 1));
  //@ wrong clamped: the mode vanishes at 0 and at m + 1
  const double c = std::cos(std::numbers::pi / m);
  return c * c;
  //@ end
}

// Task 3: sweeps until an error is this part of what it was, not rounded.
double sweeps_needed(int m, double part) {
  //@ starter
  not_done(m, part);  // your code instead of this line
  //@ solution
  return std::log(part) / std::log(left_by_sweep(m));
  //@ wrong digits: the logarithms must have one base
  return std::log10(part) / std::log(left_by_sweep(m));
  //@ end
}

// Task 4 is an experiment with these functions. You find it in the book's check.cpp.
