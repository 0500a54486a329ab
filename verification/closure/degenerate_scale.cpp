// Demonstrates Stokes' paradox in the resistance problem: with Stokeslets -log(r / ell) a body of a
// certain size has no resistance; with zero net force and a free uniform velocity (03.14) no size
// is special.
#include "experiments.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;

namespace {

constexpr double fixed_gauge = 1.0;
constexpr Ellipse unit_ellipse{4.0 / 3.0, 2.0 / 3.0};  // mean radius (a + b) / 2 = 1

/// Returns the problem of a held ellipse of the given mean radius, similar to the unit ellipse.
StokesProblem held_ellipse(double radius) {
  const Ellipse ellipse{radius * unit_ellipse.a, radius * unit_ellipse.b};
  return {{held_body(ellipse, 48, {radius * Complex{0.2, 0.1}, 0.4}, {})}, 1.3, {}, fixed_gauge};
}

StokesProblem without_gauge(StokesProblem problem) {
  problem.gauge_length.reset();
  return problem;
}

double condition_with_gauge(double radius) {
  return test::mean_square_condition(held_ellipse(radius), ClosureForm::reduced);
}

double condition_with_balance(double radius) {
  return test::mean_square_condition(without_gauge(held_ellipse(radius)), ClosureForm::reduced);
}

/// Returns the mean radius at which a force along the major axis causes no velocity along that axis
/// (03.13): log(radius / gauge) = a / (a + b).
double degenerate_radius() {
  const auto [a, b] = unit_ellipse;
  return fixed_gauge * std::exp(a / (a + b));
}

}  // namespace

Experiment degenerate_scale() {
  const std::vector<double> radii = log_points(0.25, 10.0, 61);
  return {.key = "degenerate",
          .title = "A held ellipse in unbounded fluid",
          .x = "mean radius over gauge length (a+b)/2ℓ",
          .error = "condition number between mean-square norms",
          .lines = {{.key = "gauge",
                     .label = "Stokeslets of a fixed gauge length",
                     .measure = at(radii, condition_with_gauge)},
                    {.key = "balance",
                     .label = "zero net force, uniform velocity free",
                     .measure = at(radii, condition_with_balance),
                     .claim = Claim{.id = "03_26",
                                    .statement = "With zero net force and a free uniform velocity "
                                                 "no size is special.",
                                    .law = Algebraic{0.0, 1e-9},
                                    .reason = "no length but the body's own is in the system",
                                    .api = {"stokesbook::Closure"}},
                     .control = Control{"Stokeslets of a fixed gauge length",
                                        at(radii, condition_with_gauge)}}}};
}

Experiment near_degenerate_scale() {
  const std::vector<double> distances = log_points(1e-7, 1e-2, 11);
  const auto condition_at = [](double radius) {
    return [=](double distance) { return condition_with_gauge(radius * (1.0 + distance)); };
  };
  return {
      .key = "near_degenerate",
      .title = "Near the degenerate size",
      .x = "relative distance from the degenerate size d",
      .error = "condition number between mean-square norms",
      .lines = {{.key = "gauge",
                 .label = "Stokeslets of a fixed gauge length",
                 .measure = at(distances, condition_at(degenerate_radius())),
                 .claim = Claim{.id = "03_27",
                                .statement = "The resistance problem with a gauge length ell is "
                                             "singular for an ellipse of mean radius "
                                             "ell e^(a / (a + b)).",
                                .law = Algebraic{1.0, 0.05},
                                .reason = "the velocity of a unit force on the ellipse, "
                                          "a / (a + b) - log(R / ell), changes sign there",
                                .api = {"stokesbook::StokesProblem"}},
                 .control = Control{"the gauge length itself taken for the degenerate size",
                                    at(distances, condition_at(fixed_gauge))}}}};
}

}  // namespace stokesbook::verification::closure
