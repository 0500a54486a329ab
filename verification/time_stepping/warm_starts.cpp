// Guesses of densities from earlier ones: how good they are by the step, and what they save.
#include <cmath>

#include "experiments.hpp"
#include "suspension/density_history.hpp"
#include "suspension/solver.hpp"

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

/// A smooth motion, which nothing but the clock determines.
Configuration at(double t) {
  return {{{-0.3 - 0.5 * t, 1.6 - 0.3 * t * t}, 0.7 * t},
          {{1.7 * std::cos(0.6 * t), 0.3 + std::sin(0.4 * t)}, 1.2 - t + 0.2 * t * t},
          {{0.4 + 0.2 * t, -1.8 + 0.1 * t}, std::sin(t)}};
}

/// What is remembered of a time: it, or, a planted defect, half of it.
using Clock = double (*)(double t);
double right(double t) {
  return t;
}
double stopping(double t) {
  return std::round(t / 0.3) * 0.3 + 1e-3 * t;
}

/// The last of a row of solutions.
struct Last {
  double cold, warm;  // iterations
  double residual;    // where the warm one begins
};

Last last(double dt, std::size_t kept, Clock clock) {
  static const SuspensionSolver solver(three_bodies());
  DensityHistory history(kept);
  Last last{};
  const auto steps = static_cast<int>(kept) + 1;
  for (int k = 0; k < steps; ++k) {
    const double t = 0.5 - dt * (steps - 1 - k);
    const Configuration now = at(t);
    const Solution warm = solver.solve(now, 1.0, [&](const References& references) {
      return history.guess(clock(t), now, references);
    });
    history.add(clock(t), now, warm.references, warm.density);
    last = {0.0, static_cast<double>(warm.gmres.iterations), warm.gmres.history.front()};
  }
  last.cold = solver.solve(at(0.5)).gmres.iterations;
  return last;
}

const std::vector<double> steps{0.16, 0.08, 0.04, 0.02, 0.01, 0.005};

Measure residuals(std::size_t kept, Clock clock) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double dt : steps) {
      measurements.push_back({.x = dt, .error = last(dt, kept, clock).residual});
    }
    return measurements;
  };
}

Measure shares(std::size_t kept) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double dt : steps) {
      const auto [cold, warm, residual] = last(dt, kept, right);
      measurements.push_back({.x = dt, .error = warm / cold});
    }
    return measurements;
  };
}

Line residual_line(std::size_t kept, const std::string& id) {
  const double order = static_cast<double>(kept);
  return {.key = "kept_" + std::to_string(kept),
          .label = std::to_string(kept) + (kept == 1 ? " density kept" : " densities kept"),
          .measure = residuals(kept, right),
          .claim = Claim{.id = id,
                         .statement = "A guess from " + std::to_string(kept) +
                                      " earlier densities leaves a residual of order dt^" +
                                      std::to_string(kept) + ".",
                         .law = Algebraic{order, 0.25},
                         .window = {.to = 0.05, .floor = 3e-8},
                         .reason = "the polynomial through k values errs by the k-th power of "
                                   "their distance; below, what GMRES left of them",
                         .api = {"stokesbook::DensityHistory"}},
          .control = Control{"times that stand still", residuals(kept, stopping)}};
}

}  // namespace

Experiment guesses() {
  return {
      .key = "guesses",
      .title = "Guesses from earlier densities",
      .x = "time step dt",
      .error = "residual where GMRES begins, relative",
      .lines = {residual_line(1, "09_31"),
                residual_line(2, "09_32"),
                residual_line(3, "09_33"),
                {.key = "kept_4", .label = "4 densities kept", .measure = residuals(4, right)}}};
}

Experiment saved_iterations() {
  return {.key = "saved",
          .title = "Iterations that guesses save",
          .x = "time step dt",
          .error = "iterations over those without a guess",
          .lines = {{.key = "kept_4",
                     .label = "4 densities kept",
                     .measure = shares(4),
                     .claim = Claim{.id = "09_34",
                                    .statement = "Guesses from four densities save a third of the "
                                                 "iterations or more where a step turns bodies by "
                                                 "less than a tenth.",
                                    .law = Floor{0.4, 1.6},
                                    .window = {.to = 0.1},
                                    .reason = "iterations are as the digits to be gained: of "
                                              "eight, the guess has three to six",
                                    .api = {"stokesbook::DensityHistory"}},
                     .control = Control{"no guess",
                                        [](Size) {
                                          std::vector<Measurement> all;
                                          for (const double dt : steps)
                                            all.push_back({.x = dt, .error = 1.0});
                                          return all;
                                        }}},
                    {.key = "kept_1", .label = "1 density kept", .measure = shares(1)},
                    {.key = "kept_2", .label = "2 densities kept", .measure = shares(2)},
                    {.key = "kept_6", .label = "6 densities kept", .measure = shares(6)}}};
}

}  // namespace stokesbook::verification::time_stepping
