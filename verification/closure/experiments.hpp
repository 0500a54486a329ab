#pragma once

#include <cmath>
#include <vector>

#include "study/study.hpp"
#include "support/mean_square.hpp"
#include "support/over_nodes.hpp"
#include "support/problems.hpp"
#include "support/spectra.hpp"

namespace stokesbook::verification::closure {

/// @name Experiments of the study
/// @{
study::Experiment loaded_ellipses();
study::Experiment sheared_ellipses();
study::Experiment closure_values();
study::Experiment symmetry();
study::Experiment spectrum();
study::Experiment condition_and_size();
study::Experiment condition_and_nodes();
study::Experiment condition_and_viscosity();
study::Experiment degenerate_scale();
study::Experiment near_degenerate_scale();
study::Experiment units();
study::Experiment gaps();
study::Experiment streams();
study::Experiment pair_units();
study::Experiment forms_at_work();
study::Experiment graded_pairs();
study::Experiment graded_tolerances();
study::Experiment lubrication();
study::Experiment nearly_touching_condition();
study::Experiment nearly_touching_rounding();
/// @}

/// Returns points from a to b that are equidistant on a logarithmic scale.
inline std::vector<double> log_points(double a, double b, int count) {
  std::vector<double> points;
  for (int k = 0; k < count; ++k) points.push_back(a * std::pow(b / a, k / (count - 1.0)));
  return points;
}

/// Returns even numbers of nodes from a to b, as points of an axis.
inline std::vector<double> node_counts(double a, double b, int count) {
  const std::vector<Eigen::Index> counts = test::even_counts(a, b, count - 1);
  return {counts.begin(), counts.end()};
}

/// Measures a number at each of the points; a quick study takes every second one.
/// @param  unknowns_a_node  unknowns for each node, if the points are numbers of nodes
template <class Number>
study::Measure at(const std::vector<double>& points, const Number& number,
                  double unknowns_a_node = study::unmeasured) {
  return [=](study::Size size) {
    std::vector<study::Measurement> measurements;
    const std::size_t step = size == study::Size::full ? 1 : 2;
    for (std::size_t i = 0; i < points.size(); i += step) {
      measurements.push_back(
          {.x = points[i], .error = number(points[i]), .unknowns = unknowns_a_node * points[i]});
    }
    return measurements;
  };
}

/// Returns the number of nodes of a point on the axis "nodes N".
inline Eigen::Index count(double x) {
  return static_cast<Eigen::Index>(x);
}

/// Returns P as a matrix on the nodes of free bodies whose centres are centroids. The border of the
/// scaled system yields P: minus the columns of U and a omega, times the rows of their means.
inline Eigen::MatrixXd projection_matrix(const StokesProblem& bodies) {
  const Eigen::MatrixXd system = assemble(bodies, ClosureForm::scaled_bordered).matrix;
  const Eigen::Index border = 3 * static_cast<Eigen::Index>(bodies.components.size());
  const Eigen::Index n = system.rows() - border;
  return -system.topRightCorner(n, border) * system.bottomLeftCorner(border, n);
}

/// Returns the undisturbed velocity of the shear flow (rate y, 0).
inline ComplexVector shear(const ComplexVector& x, double rate) {
  return rate * x.imag().cast<Complex>();
}

}  // namespace stokesbook::verification::closure
