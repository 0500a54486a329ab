// Solves the system without N_0 densely: the digits of the load look right, the density has an
// arbitrary part, and the flow is wrong if the data have a net flux.
#include <cmath>

#include "experiments.hpp"
#include "support/spectra.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;

namespace {

const test::EccentricAnnulus half_gap_annulus = eccentric_annulus(0.5);

StokesProblem problem_at(Index n) {
  return annulus_problem(half_gap_annulus, 1.0, n, n);
}

Measure at_counts(const std::function<double(const StokesProblem&)>& error) {
  return over_nodes({16, 24, 32, 40, 48, 64, 80, 96, 112},
                    [=](Index n) { return error(problem_at(n)); });
}

Measure least_singular_value(AnnulusMatrix matrix) {
  return at_counts([=](const StokesProblem& problem) {
    // The least singular value is computed as the reciprocal of the inverse's largest one; for a
    // singular matrix the result is at the level of rounding.
    return 1.0 / test::singular_values(test::inverse(matrix(problem)))[0];
  });
}

Measure density_flux(AnnulusMatrix matrix) {
  return at_counts([=](const StokesProblem& problem) {
    const Curve& wall = problem.components[1].curve;
    const AnnulusSolution solution = solve_annulus(problem, matrix(problem));
    return std::abs(flux_through(wall, solution.outer)) / flux_scale(problem);
  });
}

/// Measures the error of the load if the data of the wall have a net flux of `leak` times
/// flux_scale(). The load is compared with the exact load without net flux.
Measure load_error(AnnulusMatrix matrix, double leak) {
  return at_counts([=](const StokesProblem& problem) {
    StokesProblem leaking = problem;
    Component& wall = leaking.components[1];
    wall.velocity += leak * flux_scale(problem) / perimeter(wall.curve) * normals(wall.curve);
    const Load load = solve_annulus(leaking, matrix(leaking)).load;
    return relative_difference(load, inner_load(half_gap_annulus, 1.0));
  });
}

}  // namespace

Experiment without() {
  return {
      .key = "without",
      .title = "Eccentric circles solved with N_0 and without",
      .x = "nodes N",
      .error = "singular value, flux of the density, error of the load (relative)",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "singular",
           .label = "least singular value, without",
           .measure = least_singular_value(matrix_without_n0),
           .claim = Claim{.id = "04_6",
                          .statement = "Without N_0 the matrix is singular to rounding.",
                          .law = Identity{1e-14},
                          .window = {.from = 80.0},
                          .reason = "n ds from the left gives zero, but for rounding and the "
                                    "rule's error",
                          .api = {"stokesbook::assemble"}},
           .control = Control{"with N_0", least_singular_value(right_matrix)}},
          {.key = "flux",
           .label = "flux of the wall's density, with",
           .measure = density_flux(right_matrix),
           .claim =
               Claim{.id = "04_7",
                     .statement = "With N_0 the density that belongs to compatible data has "
                                  "no flux through the wall.",
                     .law = Identity{1e-13},
                     .window = {.from = 80.0},
                     .reason = "n from the left turns the system into -integral of n . eta = 0",
                     .api = {"stokesbook::null_space_velocity"}},
           .control = Control{"without N_0", density_flux(matrix_without_n0)}},
          {.key = "arbitrary",
           .label = "flux of the wall's density, without",
           .measure = density_flux(matrix_without_n0)},
          {.key = "load",
           .label = "load, without",
           .measure = load_error(matrix_without_n0, 0.0),
           .claim = Claim{.id = "04_8",
                          .statement = "The load from the singular system is right to rounding, "
                                       "as long as the data are compatible.",
                          .law = Identity{1e-13},
                          .window = {.from = 80.0},
                          .reason = "the arbitrary part of the density makes no flow",
                          .api = {"stokesbook::assemble"}},
           .control = Control{"data with a net flux of a thousandth",
                              load_error(matrix_without_n0, 1e-3)}},
          {.key = "leaking",
           .label = "load, without, net flux of a thousandth",
           .measure = load_error(matrix_without_n0, 1e-3)},
          {.key = "leaking_with",
           .label = "load, with, net flux of a thousandth",
           .measure = load_error(right_matrix, 1e-3)}}};
}

}  // namespace stokesbook::verification::null_space
