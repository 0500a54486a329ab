// Computes the flow between concentric circles; the errors of the rule are powers of the ratio of
// the radii.
#include <cmath>

#include "experiments.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;

namespace {

constexpr Complex shared_centre{0.3, -0.2};

/// Describes turning circles of radii 1 and R. The speed is u = A r + B / r.
struct CouetteCell {
  double radius, inner_omega, outer_omega, viscosity;

  StokesProblem problem(Index n) const {
    return {{test::held_body(Circle{1.0}, n, {shared_centre}, {0.0, inner_omega}),
             test::enclosing_wall(Circle{radius}, n, {shared_centre}, {0.0, outer_omega})},
            viscosity,
            {},
            {}};
  }
  double b() const {
    const double r2 = radius * radius;
    return (inner_omega - outer_omega) * r2 / (r2 - 1.0);
  }
  double a() const { return inner_omega - b(); }
  double torque() const { return 4.0 * std::numbers::pi * viscosity * b(); }
  double speed(double r) const { return a() * r + b() / r; }
};

const CouetteCell wide{2.5, 0.4, -0.7, 1.3}, narrow{1.25, -2.0, 0.3, 0.02};

ErrorOfNodes torque_error(const CouetteCell& cell, AnnulusMatrix matrix) {
  return [=](Index n) {
    const StokesProblem problem = cell.problem(n);
    const Load load = solve_annulus(problem, matrix(problem)).load;
    return std::abs(load.torque / cell.torque() - 1.0);
  };
}

/// A planted defect: the problem is solved without its viscosity.
ErrorOfNodes torque_error_without_viscosity(const CouetteCell& cell) {
  return [=](Index n) {
    StokesProblem problem = cell.problem(n);
    problem.viscosity = 1.0;
    const Load load = solve_annulus(problem, right_matrix(problem)).load;
    return std::abs(load.torque / cell.torque() - 1.0);
  };
}

constexpr double profile_radius = 1.7;

ErrorOfNodes profile_error(const CouetteCell& cell, bool rotlet) {
  return [=](Index n) {
    const StokesProblem problem = cell.problem(n);
    AnnulusSolution solution = solve_annulus(problem, right_matrix(problem));
    if (!rotlet) solution.load = {};
    // The directions lie at various places between the nodes.
    ComplexVector directions(5);
    for (Index k = 0; k < 5; ++k)
      directions[k] = std::polar(1.0, 0.3 + 1.1 * static_cast<double>(k));
    const ComplexVector points = (shared_centre + profile_radius * directions.array()).matrix();
    const ComplexVector exact = imaginary * cell.speed(profile_radius) * directions;
    const ComplexVector error = velocity_at(problem, solution, points) - exact;
    return error.cwiseAbs().maxCoeff() / std::abs(cell.speed(profile_radius));
  };
}

}  // namespace

Experiment couette() {
  const double wide_rate = std::log(wide.radius), narrow_rate = std::log(narrow.radius);
  const double profile_rate = std::log(wide.radius / profile_radius);
  return {
      .key = "couette",
      .title = "Couette flow between concentric circles",
      .x = "nodes N",
      .error = "relative error of the inner circle's torque, of the velocity",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "wide",
           .label = "torque, radii 1 and 2.5, viscosity 1.3",
           .measure = over_nodes(wide_rate, 5.0, 34.0, torque_error(wide, right_matrix)),
           .claim = Claim{.id = "04_1",
                          .statement = "The torque between concentric circles with equally many "
                                       "nodes converges as N (R_1 / R_2)^N.",
                          .law = Geometric{wide_rate, 0.02, 1.0},
                          .window = {.from = 7.0 / wide_rate, .floor = 1e-15},
                          .reason = "the wall's density e^{it} aliases to e^{i(1 +- N)t}, whose "
                                    "flow has the size N (R_1 / R_2)^N on the inner circle",
                          .api = {"stokesbook::assemble", "stokesbook::null_space_matrix"}},
           .control = Control{"the wall's normal into the fluid",
                              over_nodes(wide_rate, 5.0, 34.0,
                                         torque_error(wide, matrix_with_turned_wall))}},
          {.key = "narrow",
           .label = "torque, radii 1 and 1.25, viscosity 0.02",
           .measure = over_nodes(narrow_rate, 5.0, 34.0, torque_error(narrow, right_matrix)),
           .claim =
               Claim{.id = "04_2",
                     .statement = "The same holds in a narrow gap and at any viscosity: four "
                                  "times as many nodes for a rate four times as small.",
                     .law = Geometric{narrow_rate, 0.02, 1.0},
                     .window = {.from = 7.0 / narrow_rate, .floor = 1e-15},
                     .reason = "log(R_2 / R_1), and the matrix does not depend on the viscosity",
                     .api = {"stokesbook::complete_dense"}},
           .control =
               Control{"a fluid of viscosity 1",
                       over_nodes(narrow_rate, 5.0, 34.0, torque_error_without_viscosity(narrow))}},
          {.key = "profile",
           .label = "velocity at r = 1.7 between 1 and 2.5",
           .measure = over_nodes(profile_rate, 5.0, 34.0, profile_error(wide, true)),
           .claim = Claim{.id = "04_3",
                          .statement = "The velocity at a point in the gap converges slower than "
                                       "the torque: at the rate of its distance from the wall.",
                          .law = Geometric{profile_rate, 0.02, 1.0},
                          .window = {.from = 7.0 / profile_rate, .floor = 1e-15},
                          .reason = "the aliases of the wall's density have the size N (r / R_2)^N",
                          .api = {"stokesbook::StressletSum", "stokesbook::Closure"}},
           .control = Control{"the flow without its rotlet",
                              over_nodes(profile_rate, 5.0, 34.0, profile_error(wide, false))}}}};
}

}  // namespace stokesbook::verification::null_space
