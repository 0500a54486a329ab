// Exercise 08.3: when the fast method is faster.
#include "chapters/exercise.hpp"

#include <cmath>

#include "fmm/fmm.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::not_done;

// Task 1: operations of an application of a plan of order p.
double operations(const Fmm& plan, int p) {
  //@ starter
  not_done(plan, p);  // your code instead of this line
  //@ solution
  const std::vector<Box>& boxes = plan.sources().boxes;
  const double p2 = p * p;
  double count = 3.0 * p * static_cast<double>(plan.sources().size()) +
                 0.5 * p2 * static_cast<double>(boxes.size() - 1);
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    count += 0.5 * p2 * static_cast<double>(plan.interactions().far[b].size());
    for (const Range range : plan.interactions().near[b]) {
      count += static_cast<double>(boxes[b].size() * (range.last - range.first));
    }
  }
  return count;
  //@ wrong one_way: expansions move up and down
  const std::vector<Box>& boxes = plan.sources().boxes;
  const double p2 = p * p;
  double count = 3.0 * p * static_cast<double>(plan.sources().size()) +
                 0.25 * p2 * static_cast<double>(boxes.size() - 1);
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    count += 0.5 * p2 * static_cast<double>(plan.interactions().far[b].size());
    for (const Range range : plan.interactions().near[b]) {
      count += static_cast<double>(boxes[b].size() * (range.last - range.first));
    }
  }
  return count;
  //@ wrong ranges: a range counts its nodes times those of the box
  const std::vector<Box>& boxes = plan.sources().boxes;
  const double p2 = p * p;
  double count = 3.0 * p * static_cast<double>(plan.sources().size()) +
                 0.5 * p2 * static_cast<double>(boxes.size() - 1);
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    count += 0.5 * p2 * static_cast<double>(plan.interactions().far[b].size());
    for (const Range range : plan.interactions().near[b]) {
      count += static_cast<double>(range.last - range.first);
    }
  }
  return count;
  //@ end
}

// Task 2: the least n, for c operations a node and application, q a node for the plan, and m
// applications.
Index least_nodes(double c, double q, int m) {
  //@ starter
  not_done(c, q, m);  // your code instead of this line
  //@ solution
  return static_cast<Index>(std::floor(c + q / m)) + 1;
  //@ wrong free_plan: the plan is not free
  static_cast<void>(q);
  static_cast<void>(m);
  return static_cast<Index>(std::floor(c)) + 1;
  //@ wrong every_time: the plan is made once
  static_cast<void>(m);
  return static_cast<Index>(std::floor(c + q)) + 1;
  //@ end
}

// Task 3: the s of least operations.
double best_leaf(int p) {
  //@ starter
  not_done(p);  // your code instead of this line
  //@ solution
  return p * std::sqrt(2.0);
  //@ wrong whole_square: a conversion counts p^2/2
  return 2.0 * p;
  //@ end
}

// Task 4: n places that leaves of 50 nodes cannot take apart.
ComplexVector slow_places(Index n) {
  //@ starter
  not_done(n);  // your code instead of this line
  //@ solution
  ComplexVector places = ComplexVector::Constant(n, {0.3, 0.7});
  for (Index i = 0; i < n / 3; ++i) places[i] = std::polar(1.0, static_cast<double>(i));
  return places;
  //@ wrong line: leaves are small on a line too
  return Eigen::VectorXd::LinSpaced(n, 0.0, 1.0).cast<Complex>();
  //@ wrong close: boxes are divided at any length
  return 1e-12 * Eigen::VectorXd::LinSpaced(n, 0.0, 1.0).cast<Complex>();
  //@ end
}
