// Measures the effect of the null space and of N_0 on GMRES, for data with and without a net flux.
#include "krylov/gmres.hpp"

#include <cmath>
#include <stdexcept>

#include "experiments.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Describes the eccentric annulus in a unit of length, with c N_0 on the wall of length |Gamma_0|.
/// A net flux of `leak` times flux_scale() leaves mainly where the wall is farthest from the inner
/// circle.
struct Cell {
  double unit = 1.0;
  double leak = 0.0;
  Factor factor = [](double) { return 1.0; };

  StokesProblem problem() const {
    test::EccentricAnnulus annulus = eccentric_annulus(0.5);
    for (double* radius : {&annulus.inner_radius, &annulus.outer_radius}) *radius *= unit;
    for (Complex* centre : {&annulus.inner_centre, &annulus.outer_centre}) *centre *= unit;
    for (RigidMotion* motion : {&annulus.inner, &annulus.outer}) motion->velocity *= unit;
    StokesProblem cell = annulus_problem(annulus, 1.0, 96, 96);
    Component& wall = cell.components[1];
    const ComplexVector normal = normals(wall.curve);
    const Complex away = annulus.outer_centre - annulus.inner_centre;
    const VectorXd profile = 1.0 + (normal.array() * std::conj(away)).real() / std::abs(away);
    wall.velocity += leak * flux_scale(cell) / perimeter(wall.curve) * normal.cwiseProduct(profile);
    return cell;
  }

  GmresResult solve(double tolerance, int most) const {
    const StokesProblem data = problem();
    const double c = factor(perimeter(data.components[1].curve));
    const MatrixXd matrix = test::assemble_bounded(data, ClosureForm::reduced, c).matrix;
    const ComplexVector rhs = Closure(data).right_hand_side();
    return gmres([&](const VectorXd& x) -> VectorXd { return matrix * x; }, {}, interleaved(rhs),
                 {tolerance, most});
  }

  /// Returns n Q / |Gamma_0| on the wall relative to the right-hand side, in the norm of vectors of
  /// node values (04.8).
  double left_over() const {
    const StokesProblem data = problem();
    const Curve& wall = data.components[1].curve;
    return std::abs(net_flux(data)) / perimeter(wall) * normals(wall).norm() /
           Closure(data).right_hand_side().norm();
  }
};

double other_sign(double) {
  return -1.0;
}

Measure history(const Cell& cell) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double residual : cell.solve(1e-13, 34).history) {
      measurements.push_back({.x = static_cast<double>(measurements.size()), .error = residual});
    }
    return measurements;
  };
}

Measure counts(Factor factor) {
  return over({1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6}, [=](double unit) {
    constexpr int most = 100;
    try {
      return Cell{.unit = unit, .factor = factor}.solve(1e-10, most).iterations;
    } catch (const std::domain_error&) {  // GMRES: the recursive residual differs from the true one
      return most;
    }
  });
}

}  // namespace

Experiment residuals() {
  const Cell right, bare{.factor = zero_factor}, leaking{.leak = 1e-4, .factor = zero_factor};
  return {
      .key = "residuals",
      .title = "Residuals of GMRES in an eccentric annulus",
      .x = "iterations k",
      .error = "residual relative to the right-hand side",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "with", .label = "with N_0", .measure = history(right)},
          {.key = "without", .label = "without", .measure = history(bare)},
          {.key = "leaking",
           .label = "without, net flux of a ten thousandth",
           .measure = history(leaking),
           .claim = Claim{.id = "04_13",
                          .statement =
                              "Without N_0 the residual falls to n Q / |Gamma_0|, and no further.",
                          .law = Floor{leaking.left_over(), 1.1},
                          .window = {.from = 25.0},
                          .reason = "polynomials p(A) with p(0) = 1 leave the right null "
                                    "vector as it is; on a circle it is n",
                          .api = {"stokesbook::net_flux", "stokesbook::gmres"}},
           .control = Control{"with N_0", history({.leak = 1e-4})}},
          {.key = "leaking_with",
           .label = "with N_0, net flux of a ten thousandth",
           .measure = history({.leak = 1e-4})}}};
}

Experiment iterations() {
  return {
      .key = "iterations",
      .title = "Iterations of GMRES in any unit of length",
      .x = "inner radius R₁",
      .error = "iterations to a residual of 1e-10, at most 100",
      .axes = Axes::log_log,
      .lines = {
          {.key = "scaled",
           .label = "N_0 over the wall's length",
           .measure = counts([](double) { return 1.0; }),
           .claim = Claim{.id = "04_14",
                          .statement = "The number of iterations does not depend on the "
                                       "unit of length.",
                          .law = Algebraic{0.0, 0.002},
                          .reason = "the matrix does not: it has no dimension",
                          .api = {"stokesbook::gmres", "stokesbook::null_space_matrix"}},
           .control = Control{"N_0 that is not scaled", counts(unscaled_factor)}},
          {.key = "sign", .label = "the same with the other sign", .measure = counts(other_sign)},
          {.key = "unscaled",
           .label = "N_0 that is not scaled",
           .measure = counts(unscaled_factor)}}};
}

}  // namespace stokesbook::verification::null_space
