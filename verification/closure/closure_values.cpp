// Shows that the closure selects one of the densities that produce the same flow: free bodies move
// alike for any right-hand side of their border, and held bodies for any factor between mean
// density and load.
#include <algorithm>
#include <numbers>

#include "experiments.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;

namespace {

/// Returns a problem with two loaded free bodies and a held body.
StokesProblem problem() {
  return {{free_body(Ellipse{1.0, 0.6}, 64, {{-1.6, 0.5}, 0.7}, {{1.0, -0.4}, 0.3}),
           free_body(Circle{0.8}, 64, {{1.4, 0.0}}, {{-0.3, 0.9}, -0.5}),
           held_body(Circle{0.7}, 64, {{0.2, 2.4}}, {{0.2, 0.5}, -1.0})},
          1.3,
          {},
          50.0};
}

constexpr int border_rows = 9, held_rows = 3;

/// Returns the largest difference between the motions and loads of two solutions.
double difference(const Completion& p, const Completion& q) {
  double largest = 0.0;
  for (std::size_t k = 0; k < p.motions.size(); ++k) {
    largest =
        std::max({largest, distance(p.motions[k], q.motions[k]), distance(p.loads[k], q.loads[k])});
  }
  return largest;
}

Completion completed(const DenseSystem& system, ClosureForm form) {
  return complete_dense(problem(), form, solve(system));
}

/// Returns the change of motions and loads if a vector of size beta is on the right-hand side of
/// the border, instead of the form's values. The change is relative to beta, since the rounding
/// errors grow with beta.
double change_by_values(const StokesProblem& of, ClosureForm form, double beta) {
  DenseSystem system = assemble(of, form);
  const Completion given = completed(system, form);
  system.rhs.tail(border_rows).setLinSpaced(-beta, 0.7 * beta);
  return difference(completed(system, form), given) / std::max(1.0, beta);
}

/// A planted defect: one body's normals point into the fluid, so that its rigid motions are not
/// null densities.
StokesProblem problem_with_normals_turned() {
  StokesProblem turned = problem();
  turned.components[0].curve.side = Side::fluid_inside;
  return turned;
}

/// Returns the change of motions and loads if the rows <eta> + F / (4 pi mu) = 0 of the held body
/// become <eta> + beta F / (4 pi mu) = 0.
double change_by_factor(double beta) {
  DenseSystem system = assemble(problem(), ClosureForm::scaled_bordered);
  const Completion given = completed(system, ClosureForm::scaled_bordered);
  system.matrix.bottomRightCorner(held_rows, held_rows) *= beta;
  return difference(completed(system, ClosureForm::scaled_bordered), given);
}

/// A planted defect: the row lacks the factor 4 pi mu, while F is read as before.
double change_by_strength(double beta) {
  DenseSystem system = assemble(problem(), ClosureForm::scaled_bordered);
  const Completion given = completed(system, ClosureForm::scaled_bordered);
  system.matrix.rightCols(held_rows) /= 4.0 * std::numbers::pi * problem().viscosity;
  system.matrix.bottomRightCorner(held_rows, held_rows) *= beta;
  return difference(completed(system, ClosureForm::scaled_bordered), given);
}

Line values_line(const std::string& key, const std::string& id, const std::string& label,
                 ClosureForm form) {
  const std::vector<double> sizes = log_points(1e-2, 1e2, 9);
  return {
      .key = key,
      .label = label,
      .measure = at(sizes, [=](double b) { return change_by_values(problem(), form, b); }),
      .claim = Claim{.id = id,
                     .statement = "Any values on the right of the closure give the same motions "
                                  "and loads.",
                     .law = Identity{1e-12},
                     .reason = "rigid motions as density produce no flow in the fluid; 1e-12: "
                               "rounding times the condition number",
                     .api = {"stokesbook::assemble", "stokesbook::complete_dense"}},
      .control = Control{"normals of one body into the fluid", at(sizes, [=](double b) {
                           return change_by_values(problem_with_normals_turned(), form, b);
                         })}};
}

}  // namespace

Experiment closure_values() {
  const std::vector<double> sizes = log_points(1e-2, 1e2, 9);
  return {
      .key = "values",
      .title = "Results do not depend on the values of the closure",
      .x = "factor β",
      .error = "largest change of U, omega, F, L",
      .lines = {
          values_line("power", "03_8", "values in Power's border", ClosureForm::power_bordered),
          values_line("scaled", "03_9", "values in the scaled border",
                      ClosureForm::scaled_bordered),
          {.key = "factor",
           .label = "factor between load and mean density of a held body",
           .measure = at(
               sizes, [](double b) { return std::max(change_by_factor(b), change_by_factor(-b)); }),
           .claim =
               Claim{.id = "03_10",
                     .statement = "On held bodies any factor between mean density and "
                                  "load, of either sign, gives the same loads.",
                     .law = Identity{1e-12},
                     .reason =
                         "the factor determines the rigid part of the density, and nothing else",
                     .api = {"stokesbook::assemble"}},
           .control = Control{"4 pi mu left out of the Stokeslet's column",
                              at(sizes, change_by_strength)}}}};
}

}  // namespace stokesbook::verification::closure
