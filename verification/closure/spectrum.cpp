// Computes the spectrum of the reduced system. On a circle the spectrum is only -1 and -1/2; on an
// ellipse the spectrum is that of -1/2 + D with the eigenvalues of the rigid motions moved from 0
// to -1.
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/spectra.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;

namespace {

StokesProblem body(const Shape& shape, double x) {
  return {{free_body(shape, count(x), {{0.3, 0.1}, 0.4})}, 1.3, {}, {}};
}

Eigen::MatrixXd reduced(const StokesProblem& problem) {
  return assemble(problem, ClosureForm::reduced).matrix;
}

/// A planted defect: P has the opposite sign.
Eigen::MatrixXd with_projection_added(const StokesProblem& problem) {
  return reduced(problem) + 2.0 * projection_matrix(problem);
}

/// A planted defect: P contains integrals instead of means.
Eigen::MatrixXd with_integrals(const StokesProblem& problem) {
  const double length = perimeter(problem.components[0].curve);
  return reduced(problem) + (1.0 - length) * projection_matrix(problem);
}

/// Returns the eigenvalues of -1/2 + D, with those of the three rigid motions moved from 0 to -1.
Eigen::VectorXd known_spectrum(const Ellipse& ellipse, double x) {
  Eigen::VectorXd values = ellipse_spectrum(ellipse, Side::fluid_outside, count(x)).array() - 0.5;
  values.tail(3).setConstant(-1.0);
  return values;
}

/// Returns the largest error of all eigenvalues.
double circle_error(const Eigen::MatrixXd& matrix, double x) {
  return spectrum_distance(eigenvalues(matrix), known_spectrum({1.0, 1.0}, x));
}

/// Returns the largest error of the nine smallest and the nine largest eigenvalues.
double ellipse_error(const Eigen::MatrixXd& matrix, const Ellipse& ellipse, double x) {
  return spectrum_distance(eigenvalues(matrix), known_spectrum(ellipse, x), 9);
}

}  // namespace

Experiment spectrum() {
  constexpr double aspect = 3.0, m = (aspect - 1.0) / (aspect + 1.0);
  const double rate = -std::log(m);
  const Ellipse ellipse{aspect, 1.0};
  const std::vector<double> circle_nodes = node_counts(8, 56, 13);
  const std::vector<double> nodes = node_counts(12.0 / rate, 42.0 / rate, 15);
  return {
      .key = "spectrum",
      .title = "Spectrum of the reduced system",
      .x = "nodes N",
      .error = "largest error of the eigenvalues",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "circle",
           .label = "circle",
           .measure = at(
               circle_nodes,
               [](double x) { return circle_error(reduced(body(Circle{0.7}, x)), x); }, 2.0),
           .claim = Claim{.id = "03_13",
                          .statement = "On a circle the reduced system has the eigenvalues -1 and "
                                       "-1/2, and no others.",
                          .law = Identity{1e-14},
                          .reason = "D maps the rigid motions to their half, the normal to minus "
                                    "its half, and all else to 0",
                          .api = {"stokesbook::Closure"}},
           .control = Control{"the projection added, not subtracted",
                              at(circle_nodes,
                                 [](double x) {
                                   return circle_error(with_projection_added(body(Circle{0.7}, x)),
                                                       x);
                                 })}},
          {.key = "ellipse",
           .label = "ellipse 3:1",
           .measure = at(
               nodes,
               [=](double x) { return ellipse_error(reduced(body(ellipse, x)), ellipse, x); }, 2.0),
           .claim = Claim{.id = "03_14",
                          .statement = "On an ellipse the reduced system has the eigenvalues of "
                                       "-1/2 + D, those of the rigid motions moved to -1.",
                          .law = Geometric{rate, 0.02, 1.0},
                          .window = {.from = 20.0 / rate, .floor = 1e-15},
                          .reason = "the kernel's modes k m^(k-1) alias by N, as in chapter 01",
                          .api = {"stokesbook::Closure"}},
           .control =
               Control{"integrals instead of means in the projection", at(nodes, [=](double x) {
                         return ellipse_error(with_integrals(body(ellipse, x)), ellipse, x);
                       })}}}};
}

}  // namespace stokesbook::verification::closure
