#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "study/study.hpp"

namespace stokesbook::test {

/// Returns even numbers of nodes from first to last, as equidistant as possible. Numbers below 4
/// are left out.
inline std::vector<Eigen::Index> even_counts(double first, double last, int steps) {
  std::vector<Eigen::Index> counts;
  for (int k = 0; k <= steps; ++k) {
    const Eigen::Index n = 2 * std::lround(0.5 * (first + (last - first) * k / steps));
    if (n >= 4 && (counts.empty() || n > counts.back())) counts.push_back(n);
  }
  return counts;
}

/// Measures an error, a function of the number of nodes, at given numbers of nodes.
template <class Error>
std::vector<study::Measurement> errors_at(const std::vector<Eigen::Index>& counts,
                                          const Error& error, double unknowns_a_node) {
  std::vector<study::Measurement> measurements;
  for (const Eigen::Index n : counts) {
    const double x = static_cast<double>(n);
    measurements.push_back({.x = x, .error = error(n), .unknowns = unknowns_a_node * x});
  }
  return measurements;
}

/// Measures an error, a function of the number of nodes, at `steps` numbers of nodes from first to
/// last. A quick study takes half as many steps.
template <class Error>
study::Measure over_nodes(double first, double last, int steps, const Error& error,
                          double unknowns_a_node) {
  return [=](study::Size size) {
    const int taken = size == study::Size::full ? steps : steps / 2;
    return errors_at(even_counts(first, last, taken), error, unknowns_a_node);
  };
}

}  // namespace stokesbook::test
