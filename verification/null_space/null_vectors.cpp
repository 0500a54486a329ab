// Tests the two null vectors of an enclosing wall, without and with bodies: the left null vector is
// n on the whole boundary (04.3); the right null vector is n |x'| on an elliptic wall and zero on
// the bodies (04.4).
#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments.hpp"
#include "support/vectors.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;

namespace {

const Pose pose{{0.4, -0.3}, 0.7};

/// @name Walls, with n nodes on every curve
/// @{

constexpr Ellipse slender{3.0, 1.0};

StokesProblem wall_alone(Index n) {
  return {{test::enclosing_wall(slender, n, pose)}, 1.0, {}, {}};
}

constexpr Ellipse roomy{3.0, 2.0};
constexpr Circle swimmer{0.5};
constexpr Complex swimmer_place{1.0, 0.5};  // in the frame of the wall

StokesProblem wall_with_bodies(Index n) {
  const auto in_wall = [](Complex z) {
    return pose.position + std::polar(1.0, pose.orientation) * z;
  };
  return {{test::free_body(swimmer, n, {in_wall(swimmer_place)}),
           test::held_body(Ellipse{0.6, 0.4}, n, {in_wall({-1.1, -0.2}), 1.1}, {}),
           test::enclosing_wall(roomy, n, pose)},
          1.0,
          {},
          {}};
}

/// @}
/// @name Vectors at all nodes of a problem
/// @{

/// Concatenates a vector of each curve.
ComplexVector stacked(const StokesProblem& problem, ComplexVector (*of_curve)(const Curve&)) {
  ComplexVector result(node_offsets(problem).back());
  Index first = 0;
  for (const Component& component : problem.components) {
    result.segment(first, component.curve.size()) = of_curve(component.curve);
    first += component.curve.size();
  }
  return result;
}

/// Sets the vector to zero on the bodies; the wall is the last component.
ComplexVector without_bodies(const StokesProblem& problem, ComplexVector v) {
  v.head(v.size() - problem.components.back().curve.size()).setZero();
  return v;
}

ComplexVector normals_everywhere(const StokesProblem& problem) {
  return stacked(problem, normals);
}

ComplexVector normals_of_wall(const StokesProblem& problem) {
  return without_bodies(problem, normals_everywhere(problem));
}

/// Returns n |x'|, the velocity of ellipses that a pressure inside enlarges; they remain ellipses.
ComplexVector all_blown_up(const StokesProblem& problem) {
  return stacked(problem, [](const Curve& curve) -> ComplexVector {
    return normals(curve).cwiseProduct(curve.dx.cwiseAbs());
  });
}

ComplexVector wall_blown_up(const StokesProblem& problem) {
  return without_bodies(problem, all_blown_up(problem));
}

Eigen::VectorXd all_weights(const StokesProblem& problem) {
  return stacked(problem,
                 [](const Curve& curve) -> ComplexVector { return weights(curve).cast<Complex>(); })
      .real();
}

/// @}

/// Returns the largest entry of v^T W A divided by its weight, relative to v. A is without N_0; W
/// contains the weights.
double left_residual(const StokesProblem& problem, const ComplexVector& v) {
  const Eigen::VectorXd w = all_weights(problem);
  const ComplexVector weighted = v.cwiseProduct(w);
  const Eigen::VectorXd image = matrix_without_n0(problem).transpose() * interleaved(weighted);
  return test::largest(deinterleaved(image).cwiseQuotient(w)) / test::largest(v);
}

/// Returns |A v| relative to v.
double right_residual(const StokesProblem& problem, const ComplexVector& v) {
  const Eigen::VectorXd image = matrix_without_n0(problem) * interleaved(v);
  return test::largest(deinterleaved(image)) / test::largest(v);
}

using Residual = double (*)(const StokesProblem&, const ComplexVector&);
using NodeVector = ComplexVector (*)(const StokesProblem&);

Measure alone(Residual residual, NodeVector vector) {
  std::vector<Index> counts;
  for (Index n = 8; n <= 60; n += 4) counts.push_back(n);
  return over_nodes(
      counts, [=](Index n) { return residual(wall_alone(n), vector(wall_alone(n))); }, 1);
}

/// Returns the imaginary part of the parameter at which an ellipse, continued to complex
/// parameters, passes through a point of its frame: w = e^{it} solves (a + b) w^2 - 2 z w + a - b =
/// 0.
double preimage_distance(const Ellipse& ellipse, Complex z) {
  const auto [a, b] = ellipse;
  const Complex root = std::sqrt(z * z - a * a + b * b);
  return std::min(std::abs(std::log(std::abs((z + root) / (a + b)))),
                  std::abs(std::log(std::abs((z - root) / (a + b)))));
}

/// Returns the rate for the swimmer's point nearest to the wall.
double rate_with_bodies() {
  const ComplexVector points = sample(swimmer, 720, Side::fluid_outside).x;
  double least = std::numeric_limits<double>::infinity();
  for (const Complex z : points) {
    least = std::min(least, preimage_distance(roomy, swimmer_place + z));
  }
  return least;
}

Measure with_bodies(Residual residual, NodeVector vector) {
  return over_nodes(
      rate_with_bodies(), 7.0, 28.0,
      [=](Index n) { return residual(wall_with_bodies(n), vector(wall_with_bodies(n))); }, 3);
}

}  // namespace

Experiment null_vectors() {
  const double rate = std::log((slender.a + slender.b) / (slender.a - slender.b));
  return {
      .key = "vectors",
      .title = "Null vectors of -1/2 + D on an elliptic wall 3:1",
      .x = "nodes N",
      .error = "largest residual, relative to the vector",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "left",
           .label = "n from the left",
           .measure = alone(left_residual, normals_everywhere),
           .claim = Claim{.id = "04_4",
                          .statement = "The normal is the left null vector of -1/2 + D, up to the "
                                       "rule's error N m^N, m = (a - b) / (a + b).",
                          .law = Geometric{rate, 0.02, 1.0},
                          .window = {.from = 16.0, .floor = 1e-15},
                          .reason = "double layers carry no flux; the kernel's modes k m^(k-1) "
                                    "alias by N",
                          .api = {"stokesbook::null_space_velocity", "stokesbook::normals"}},
           .control = Control{"n |x'| from the left", alone(left_residual, wall_blown_up)}},
          {.key = "right",
           .label = "n |x'| from the right",
           .measure = alone(right_residual, wall_blown_up),
           .claim = Claim{.id = "04_5",
                          .statement = "The right null vector of an ellipse is n |x'|: as the "
                                       "ellipse would grow if a pressure inside blew it up.",
                          .law = Geometric{rate, 0.02, 1.0},
                          .window = {.from = 16.0, .floor = 1e-15},
                          .reason = "the spectrum of the ellipse: modes +-1 of eigenvalue 1/2",
                          .api = {"stokesbook::double_layer_matrix"}},
           .control = Control{"n from the right", alone(right_residual, normals_everywhere)}},
          {.key = "normal",
           .label = "n from the right",
           .measure = alone(right_residual, normals_everywhere)}}};
}

Experiment bodies_in_wall() {
  const double rate = rate_with_bodies();
  return {
      .key = "bodies",
      .title = "Null vectors with a free body and a held one in an elliptic wall 3:2",
      .x = "nodes N",
      .error = "largest residual, relative to the vector",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "left",
           .label = "n on wall and bodies, from the left",
           .measure = with_bodies(left_residual, normals_everywhere),
           .claim = Claim{.id = "04_26",
                          .statement = "With bodies in the wall the left null vector is n on all "
                                       "of the boundary: only the total flux is missed.",
                          .law = Geometric{rate, 0.03, 1.0},
                          .window = {.from = 10.0 / rate, .floor = 1e-15},
                          .reason = "the flow has no divergence; the wall's rule errs as N e^{-dN} "
                                    "at the nearest body, d by its preimage",
                          .api = {"stokesbook::assemble", "stokesbook::net_flux"}},
           .control = Control{"n on the wall alone", with_bodies(left_residual, normals_of_wall)}},
          {.key = "wall_left",
           .label = "n on the wall alone, from the left",
           .measure = with_bodies(left_residual, normals_of_wall)},
          {.key = "right",
           .label = "n |x'| on the wall alone, from the right",
           .measure = with_bodies(right_residual, wall_blown_up),
           .claim = Claim{.id = "04_27",
                          .statement = "The right null vector is that of the wall without bodies, "
                                       "and nothing on them.",
                          .law = Geometric{rate, 0.03, 1.0},
                          .window = {.from = 10.0 / rate, .floor = 1e-15},
                          .reason = "it makes no flow inside the wall, where the bodies are",
                          .api = {"stokesbook::assemble", "stokesbook::null_space_matrix"}},
           .control =
               Control{"n |x'| on the bodies too", with_bodies(right_residual, all_blown_up)}},
          {.key = "all_right",
           .label = "n |x'| on wall and bodies, from the right",
           .measure = with_bodies(right_residual, all_blown_up)}}};
}

}  // namespace stokesbook::verification::null_space
