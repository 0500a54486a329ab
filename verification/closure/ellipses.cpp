// Compares ellipses under loads, and ellipses in shear, with closed forms; the rates of convergence
// are predicted from the ellipse's shape.
#include <functional>
#include <limits>
#include <numbers>

#include "experiments.hpp"
#include "support/closed_forms.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;

namespace {

constexpr double viscosity = 1.3, gauge_length = 7.0, ellipse_orientation = 0.4;

/// Changes a problem before its solution, for planted defects.
using Change = std::function<void(StokesProblem&)>;

/// A planted defect: U and omega have the opposite sign in the system, a mistake that is easily made.
RigidMotion solve_with_motions_reversed(const StokesProblem& problem) {
  DenseSystem system = assemble(problem, ClosureForm::scaled_bordered);
  system.matrix.rightCols(3) *= -1.0;
  return complete_dense(problem, ClosureForm::scaled_bordered, solve(system)).motions[0];
}

/// A planted defect: the double layer lacks its diagonal.
RigidMotion solve_without_diagonal(const StokesProblem& problem) {
  DenseSystem system = assemble(problem, ClosureForm::scaled_bordered);
  for (Eigen::Index row = 0; row + 3 < system.matrix.rows(); row += 2) {
    system.matrix.block<2, 2>(row, row) = -0.5 * Eigen::Matrix2d::Identity();
  }
  return complete_dense(problem, ClosureForm::scaled_bordered, solve(system)).motions[0];
}

RigidMotion solve_reduced(const StokesProblem& problem) {
  return solve_dense(problem, ClosureForm::reduced).motions[0];
}

using Solve = RigidMotion (*)(const StokesProblem&);

void no_change(StokesProblem&) {}

/// Returns the relative error of the motion of an ellipse (aspect, 1) under a force and a torque.
double error_under_load(double aspect, double x, const Solve& solve, const Change& change) {
  const Ellipse ellipse{aspect, 1.0};
  const Load load{{0.3, -1.1}, 0.6};
  StokesProblem problem{{free_body(ellipse, count(x), {{3.0, -2.0}, ellipse_orientation}, load)},
                        viscosity,
                        {},
                        gauge_length};
  change(problem);
  const RigidMotion exact =
      loaded_ellipse(ellipse, ellipse_orientation, load, viscosity, gauge_length);
  return distance(solve(problem), exact) / std::abs(exact.velocity);
}

/// Returns the error of the angular velocity of a free ellipse (aspect, 1) in shear, relative to
/// the shear rate.
double error_in_shear(double aspect, double x, const Solve& solve, const Change& change) {
  constexpr double rate = 1.4;
  const Ellipse ellipse{aspect, 1.0};
  const Component body = free_body(ellipse, count(x), {{3.0, -2.0}, ellipse_orientation});
  StokesProblem problem{{body}, viscosity, shear(body.curve.x, rate), {}};
  change(problem);
  const RigidMotion exact{-2.0 * rate,
                          free_ellipse_omega(ellipse, ellipse_orientation, -rate, 0.0, 0.5 * rate)};
  return distance(solve(problem), exact) / rate;
}

double ratio(double aspect) {
  return (aspect - 1.0) / (aspect + 1.0);
}

/// Returns the level of rounding errors. The level is proportional to the condition number, which
/// grows as the square of the aspect ratio.
double rounding(double aspect) {
  return aspect * aspect * std::numeric_limits<double>::epsilon();
}

void opposite_loads(StokesProblem& problem) {
  problem.components[0].force *= -1.0;
  problem.components[0].torque *= -1.0;
}

void strengths_without_scale(StokesProblem& problem) {
  const double missing = 4.0 * std::numbers::pi * problem.viscosity;
  problem.components[0].force *= missing;
  problem.components[0].torque *= missing;
}

void opposite_background(StokesProblem& problem) {
  problem.background *= -1.0;
}

void opposite_normals(StokesProblem& problem) {
  problem.components[0].curve.side = Side::fluid_inside;
}

using EllipseError = double (*)(double aspect, double x, const Solve&, const Change&);

struct Defect {
  std::string name;
  Solve solve;
  Change change;
};

Line ellipse_line(const std::string& key, double aspect, const EllipseError& error,
                  const Claim& claim, double rate, const Defect& defect) {
  const std::vector<double> nodes = node_counts(4.0 / rate, 36.0 / rate, 15);
  return {.key = key,
          .label = "ellipse " + std::to_string(static_cast<int>(aspect)) + ":1",
          .measure = at(
              nodes, [=](double x) { return error(aspect, x, solve_reduced, no_change); }, 2.0),
          .claim = claim,
          .control = Control{defect.name, at(nodes, [=](double x) {
                               return error(aspect, x, defect.solve, defect.change);
                             })}};
}

Line loaded_line(const std::string& key, const std::string& id, double aspect,
                 const Defect& defect) {
  const double rate = -0.5 * std::log(ratio(aspect));
  return ellipse_line(
      key, aspect, error_under_load,
      {.id = id,
       .statement = "The motion of a loaded ellipse converges as m^(N/2), m = (a - b) / (a + b).",
       .law = Geometric{rate, 0.03},
       .window = {.from = 10.0 / rate, .floor = rounding(aspect)},
       .reason = "the Stokeslet at the centre has the modes m^(k/2) on the ellipse; mode N is the "
                 "first to alias onto the mean; from e^-10 on, where N m^N is small beside it",
       .api = {"stokesbook::Closure", "stokesbook::stokeslet"}},
      rate, defect);
}

Line sheared_line(const std::string& key, const std::string& id, double aspect,
                  const Defect& defect) {
  const double rate = -std::log(ratio(aspect));
  return ellipse_line(
      key, aspect, error_in_shear,
      {.id = id,
       .statement =
           "The angular velocity of a free ellipse in shear converges to Jeffery's as N m^N.",
       .law = Geometric{rate, 0.03, 1.0},
       .window = {.from = 6.0 / rate, .floor = rounding(aspect)},
       .reason =
           "the data hold the modes 1 and -1 only; what aliases is the double layer's kernel, "
           "with the modes k m^(k-1)",
       .api = {"stokesbook::Closure", "stokesbook::double_layer_matrix"}},
      rate, defect);
}

}  // namespace

Experiment loaded_ellipses() {
  const std::vector<double> few_nodes = node_counts(6, 30, 7);
  const Line circle{
      .key = "circle",
      .label = "circle",
      .measure = at(
          few_nodes, [](double x) { return error_under_load(1.0, x, solve_reduced, no_change); },
          2.0),
      .claim = Claim{.id = "03_1",
                     .statement = "The motion of a loaded circle is exact with six nodes or more.",
                     .law = Identity{1e-14},
                     .reason = "Stokeslet, rotlet and kernel have the modes -2 to 2 there",
                     .api = {"stokesbook::Closure"}},
      .control = Control{"the diagonal of the double layer left out", at(few_nodes, [](double x) {
                           return error_under_load(1.0, x, solve_without_diagonal, no_change);
                         })}};
  return {.key = "loaded",
          .title = "Ellipses under a force and a torque",
          .x = "nodes N",
          .error = "error of U and b omega, relative to U",
          .axes = Axes::semi_log,
          .lines = {circle,
                    loaded_line("two", "03_2", 2.0,
                                {"U and omega with a plus sign, which reverses the motions",
                                 solve_with_motions_reversed, no_change}),
                    loaded_line("three", "03_3", 3.0,
                                {"Stokeslet and rotlet without 1 / (4 pi mu)", solve_reduced,
                                 strengths_without_scale}),
                    loaded_line("six", "03_4", 6.0,
                                {"the force of the fluid on the body taken for F", solve_reduced,
                                 opposite_loads})}};
}

Experiment sheared_ellipses() {
  return {.key = "sheared",
          .title = "Free ellipses in shear",
          .x = "nodes N",
          .error = "error of U and b omega, relative to the shear rate times b",
          .axes = Axes::semi_log,
          .lines = {sheared_line("two", "03_5", 2.0,
                                 {"U and omega with a plus sign, which reverses the motions",
                                  solve_with_motions_reversed, no_change}),
                    sheared_line("three", "03_6", 3.0,
                                 {"the background flow with a plus sign on the right",
                                  solve_reduced, opposite_background}),
                    sheared_line("six", "03_7", 6.0,
                                 {"normals into the fluid", solve_reduced, opposite_normals})}};
}

}  // namespace stokesbook::verification::closure
