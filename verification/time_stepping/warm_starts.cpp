// Measures guesses of densities that are extrapolated from earlier densities: their residual as a
// function of the step, and the iterations that they save. Measures guesses from the density of a
// stage, which lies off the path of the bodies.
#include <cmath>

#include "experiments.hpp"
#include "suspension/motion/instant_solver.hpp"
#include "suspension/solver/density_history.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;

namespace {

Scene three_bodies() {
  Scene scene;
  scene.flow = ExtensionalFlow{1.0};
  const std::vector<Shape> shapes{Star{0.8, 0.2, 5}, Ellipse{1.0, 0.4}, Circle{0.7}};
  for (const Shape& shape : shapes) {
    Body body;
    body.shape = shape;
    body.n_nodes = 96;
    scene.bodies.push_back(body);
  }
  scene.solver.tolerance = 1e-6;
  scene.solver.gmres_tol = 1e-8;
  return scene;
}

/// Returns the configuration of a smooth motion at a time.
Configuration at(double t) {
  return {{{-0.3 - 0.5 * t, 1.6 - 0.3 * t * t}, 0.7 * t},
          {{1.7 * std::cos(0.6 * t), 0.3 + std::sin(0.4 * t)}, 1.2 - t + 0.2 * t * t},
          {{0.4 + 0.2 * t, -1.8 + 0.1 * t}, std::sin(t)}};
}

/// Selects whether the flow reverses after the first solution without a reversal of the history (a
/// planted defect).
enum class Reversal { none, untold };

/// Holds the results of the last of a series of solutions.
struct Last {
  double cold, warm;  // iterations without and with a guess
  double residual;    // initial residual with the guess
};

Last last(double dt, std::size_t kept, Reversal reversal) {
  static const SuspensionSolver solver(three_bodies());
  DensityHistory history(kept);
  Last last{};
  for (std::size_t k = 0; k <= kept; ++k) {
    const double t = 0.5 - dt * static_cast<double>(kept - k);
    const double amplitude = k == 0 && reversal == Reversal::untold ? -1.0 : 1.0;
    const Configuration now = at(t);
    const Instant instant{now, scaled(amplitude, solver.start().forcing)};
    const Solution warm = solver.solve(instant, [&](const Discretisation& discretisation) {
      return history.guess(t, now, discretisation);
    });
    history.add(t, now, warm.discretisation, warm.density);
    last = {0.0, static_cast<double>(warm.gmres.iterations), warm.gmres.history.front()};
  }
  last.cold = solver.solve(solver.instant(at(0.5))).gmres.iterations;
  return last;
}

const std::vector<double> steps_per_unit{6.25, 12.5, 25.0, 50.0, 100.0, 200.0};

Measure residuals(std::size_t kept, Reversal reversal = Reversal::none) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double x : steps_per_unit) {
      measurements.push_back({.x = x, .error = last(1.0 / x, kept, reversal).residual});
    }
    return measurements;
  };
}

Measure shares(std::size_t kept, Reversal reversal = Reversal::none) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double x : steps_per_unit) {
      const auto [cold, warm, residual] = last(1.0 / x, kept, reversal);
      measurements.push_back({.x = x, .error = warm / cold});
    }
    return measurements;
  };
}

/// Returns the configuration of a stage, which deviates from the motion.
Configuration near_path(double t, double deviation) {
  Configuration stage = at(t);
  stage[0].position += deviation * Complex{1.0 - t, 0.5};
  stage[0].orientation += 2.0 * deviation;
  stage[1].orientation -= deviation * (1.0 + t);
  stage[2].position -= deviation * Complex{0.3, t};
  return stage;
}

/// Takes steps that end at t = 0.5, each with a stage that deviates by dt to a power. Returns the
/// residual with which the solve at the end of the last step begins.
double residual_after_stages(double dt, int steps, double power) {
  static const SuspensionSolver solver(three_bodies());
  static const OutputSchedule schedule(solver.scene());
  RunStatistics statistics;
  InstantSolver instants(solver, schedule, statistics, {});
  double t = 0.5 - steps * dt, residual = 0.0;
  instants.solve({t, t}, at(t));
  for (int k = 0; k < steps; ++k) {
    const StepTime end{t + dt, t};
    instants.solve_stage(end, near_path(end.t, std::pow(dt, power)));
    residual = instants.solve(end, at(end.t)).solution.gmres.history.front();
    t = end.t;
  }
  return residual;
}

Measure residuals_after_stages(int steps, double power) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double x : {12.5, 25.0, 50.0, 100.0}) {
      measurements.push_back({.x = x, .error = residual_after_stages(1.0 / x, steps, power)});
    }
    return measurements;
  };
}

const std::string defect = "the flow reverses after the first density, and the history does not";

Line residual_line(std::size_t kept, const std::string& id) {
  const std::string densities =
      std::to_string(kept) + (kept == 1 ? " earlier density" : " earlier densities");
  return {
      .key = "kept_" + std::to_string(kept),
      .label = densities,
      .measure = residuals(kept),
      .claim = Claim{.id = id,
                     .statement = "A guess from " + densities + " leaves a residual of order dt^" +
                                  std::to_string(kept) + ".",
                     .law = Algebraic{static_cast<double>(kept), 0.25},
                     .window = {.from = 20.0, .floor = 3e-8},
                     .reason = "the polynomial through k values errs by the k-th power of their "
                               "distance; below, what GMRES left of them",
                     .api = {"stokesbook::DensityHistory"}},
      .control = Control{defect, residuals(kept, Reversal::untold)}};
}

}  // namespace

Experiment guesses() {
  return {.key = "guesses",
          .title = "Guesses from earlier densities, three bodies in motion",
          .x = "steps a unit of time, (1/h)",
          .error = "residual where GMRES begins, relative",
          .lines = {residual_line(1, "09_32"),
                    residual_line(2, "09_33"),
                    residual_line(3, "09_34"),
                    {.key = "kept_4", .label = "4 earlier densities", .measure = residuals(4)},
                    {.key = "kept_6", .label = "6 earlier densities", .measure = residuals(6)}}};
}

Experiment guesses_after_stages() {
  return {
      .key = "after_stages",
      .title = "Guesses from the density of a stage at the same time, three bodies in motion",
      .x = "steps a unit of time, (1/h)",
      .error = "residual where GMRES begins, relative",
      .lines = {
          {.key = "as_it_is",
           .label = "density of the stage",
           .measure = residuals_after_stages(1, 2.0),
           .claim = Claim{.id = "09_39",
                          .statement = "The density of a stage that deviates from the path by dt^2 "
                                       "leaves a residual of order dt^2 at the end of the step.",
                          .law = Algebraic{2.0},
                          .reason = "the density is a smooth function of the configuration",
                          .api = {"stokesbook::InstantSolver"}},
           .control = Control{"stages deviate by dt", residuals_after_stages(1, 1.0)}},
          {.key = "corrected",
           .label = "less the deviations of two earlier steps",
           .measure = residuals_after_stages(3, 2.0),
           .claim = Claim{.id = "09_40",
                          .statement = "Minus the deviation extrapolated from two earlier steps, "
                                       "the density of a stage leaves a residual of order dt^4.",
                          .law = Algebraic{4.0},
                          .reason = "the deviation over dt^2 is a smooth function of time, and is "
                                    "extrapolated by a straight line",
                          .api = {"stokesbook::InstantSolver"}},
           .control = Control{"stages deviate by dt", residuals_after_stages(3, 1.0)}}}};
}

Experiment saved_iterations() {
  return {
      .key = "saved",
      .title = "Iterations with guesses over those without, three bodies in motion",
      .x = "steps a unit of time, (1/h)",
      .error = "iterations over those without a guess",
      .lines = {{.key = "kept_1", .label = "1 earlier density", .measure = shares(1)},
                {.key = "kept_2", .label = "2 earlier densities", .measure = shares(2)},
                {.key = "kept_4",
                 .label = "4 earlier densities",
                 .measure = shares(4),
                 .claim = Claim{.id = "09_35",
                                .statement = "Guesses from four densities save a third of the "
                                             "iterations or more where a step turns bodies by a "
                                             "tenth of a radian or less.",
                                .law = Floor{0.4, 1.6},
                                .window = {.from = 10.0},
                                .reason = "iterations are in proportion to the digits to be "
                                          "gained: of eight, the guess has three to six",
                                .api = {"stokesbook::DensityHistory"}},
                 .control = Control{defect, shares(4, Reversal::untold)}},
                {.key = "kept_6", .label = "6 earlier densities", .measure = shares(6)}}};
}

}  // namespace stokesbook::verification::time_stepping
