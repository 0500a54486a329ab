// Compares the solver's tolerance with true residuals (preconditioned from the left and from the
// right, (05.9)) and with errors of velocities. Measures the cost of the solutions.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "experiments.hpp"
#include "support/body_systems.hpp"
#include "support/dense.hpp"

namespace stokesbook::verification::krylov {

using namespace study;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr int most = 1000;

/// Holds a system with its preconditioner and right-hand side.
struct SolvableSystem {
  BodySystem system;
  BlockDiagonalPreconditioner solve_blocks;
  VectorXd rhs = system.rhs();

  SolvableSystem(const std::vector<PlacedBody>& bodies, Index nodes, const Flow& flow)
      : system(bodies, nodes, flow), solve_blocks(block_diagonal(bodies, nodes)) {}

  double residual(const VectorXd& x) const { return (rhs - system.apply(x)).norm() / rhs.norm(); }

  GmresResult from_the_right(const GmresOptions& options) const {
    return gmres(system.map(), solve_blocks, rhs, options);
  }

  /// Solves M^{-1} A x = M^{-1} b: GMRES measures only the preconditioned residual.
  GmresResult from_the_left(const GmresOptions& options) const {
    return gmres([this](const VectorXd& v) { return solve_blocks(system.apply(v)); }, {},
                 solve_blocks(rhs), options);
  }

  GmresResult unpreconditioned(const GmresOptions& options) const {
    return gmres(system.map(), {}, rhs, options);
  }
};

using Solver = GmresResult (SolvableSystem::*)(const GmresOptions&) const;

SolvableSystem woven() {
  return {woven_ellipses(2, 2, 6.0), 64, generic_flow};
}

/// Returns the system of two needles of aspect ratio 16:1 side by side. The flow would bend the
/// needles; bending is the mode with the smallest eigenvalue.
SolvableSystem needles() {
  const Shape needle = Ellipse{1.0, 1.0 / 16.0};
  const auto bending = [](Complex z) {
    return imaginary * z.real() * z.real() + 0.1 * generic_flow(z);
  };
  return {{{needle, 0.0}, {needle, {0.2, 0.3}}}, 272, bending};
}

/// Measures the difference between the residual that GMRES reports and the residual of its iterate.
Measure residual_differences(Solver solve) {
  return [=](Size) {
    const SolvableSystem problem = woven();
    std::vector<Measurement> measurements;
    for (int k = 1; k <= 30; k += 2) {
      const GmresResult result = (problem.*solve)({0.0, k});
      measurements.push_back(
          {.x = static_cast<double>(k),
           .error = std::abs(result.history.back() - problem.residual(result.solution))});
    }
    return measurements;
  };
}

std::vector<double> asked(Size size) {
  std::vector<double> tolerances;
  for (double tolerance = 1e-12; tolerance < 0.5; tolerance *= size == Size::full ? 10.0 : 100.0) {
    tolerances.push_back(tolerance);
  }
  return tolerances;
}

Measure true_residuals(Solver solve) {
  return [=](Size size) {
    const SolvableSystem problem = needles();
    std::vector<Measurement> measurements;
    for (const double tolerance : asked(size)) {
      const GmresResult result = (problem.*solve)({tolerance, most});
      measurements.push_back({.x = tolerance,
                              .error = problem.residual(result.solution),
                              .operations = static_cast<double>(result.iterations)});
    }
    return measurements;
  };
}

/// Returns velocities and angular velocities of all bodies. The longest semi-axis is 1, so both
/// quantities have the same unit.
VectorXd velocities(const BodySystem& system, const VectorXd& density) {
  std::vector<double> values;
  for (const RigidMotion& motion : system.motions(density)) {
    values.insert(values.end(), {motion.velocity.real(), motion.velocity.imag(), motion.omega});
  }
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

template <class Function>
double seconds_of(const Function& function) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  function();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Holds the exact velocities. The error is the largest error of a velocity, relative to the
/// largest exact velocity.
struct Reference {
  VectorXd exact;

  explicit Reference(const SolvableSystem& problem)
      : exact(velocities(problem.system, problem.from_the_right({1e-14, most}).solution)) {}

  double error(const VectorXd& computed) const {
    return (computed - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
  }
};

Measure velocity_errors(Solver solve, int most_iterations = most) {
  return [=](Size size) {
    const SolvableSystem problem = woven();
    const Reference reference(problem);
    std::vector<Measurement> measurements;
    for (const double tolerance : asked(size)) {
      GmresResult result;
      const double seconds = seconds_of([&] {
        result = (problem.*solve)({tolerance, most_iterations});
      });
      measurements.push_back({.x = tolerance,
                              .error = reference.error(velocities(problem.system, result.solution)),
                              .operations = result.iterations + 1.0,
                              .seconds = seconds});
    }
    return measurements;
  };
}

/// Measures the error and the cost of the naive method, which assembles the matrix by one product
/// for each column, and factorises the matrix.
std::vector<Measurement> by_factorisation(Size size) {
  const SolvableSystem problem = woven();
  const Reference reference(problem);
  VectorXd density;
  const double seconds =
      seconds_of([&] { density = test::solve(problem.system.matrix(), problem.rhs); });
  const double error = reference.error(velocities(problem.system, density));
  std::vector<Measurement> measurements;
  for (const double tolerance : asked(size)) {
    measurements.push_back({.x = tolerance,
                            .error = error,
                            .operations = static_cast<double>(problem.system.size()),
                            .seconds = seconds});
  }
  return measurements;
}

}  // namespace

Experiment residuals() {
  return {
      .key = "residuals",
      .title = "The residual that GMRES reports",
      .x = "iterations k",
      .error = "difference from the residual of the iterate",
      .axes = Axes::semi_log,
      .lines = {{.key = "right",
                 .label = "preconditioned from the right",
                 .measure = residual_differences(&SolvableSystem::from_the_right),
                 .claim = Claim{.id = "05_7",
                                .statement = "The recurrence's residual is that of A x = b.",
                                .law = Identity{1e-14},
                                .reason = "b - A M^{-1} y = b - A x; 1e-14: rounding of some ten "
                                          "products",
                                .api = {"stokesbook::gmres", "stokesbook::GmresResult"}},
                 .control = Control{"preconditioned from the left",
                                    residual_differences(&SolvableSystem::from_the_left)}},
                {.key = "left",
                 .label = "preconditioned from the left",
                 .measure = residual_differences(&SolvableSystem::from_the_left)}}};
}

Experiment tolerances() {
  return {
      .key = "tolerances",
      .title = "Residual by the tolerance, two needles 16:1",
      .x = "tolerance",
      .error = "residual of the solution, relative to the right-hand side",
      .lines =
          {{.key = "right",
            .label = "preconditioned from the right",
            .measure = true_residuals(&SolvableSystem::from_the_right),
            .claim =
                Claim{.id = "05_22",
                      .statement =
                          "The residual of the solution is below the tolerance, and not far below.",
                      .law = ErrorBelowTolerance{1.0, 0.1},
                      .reason = "an iteration gains less than a factor of ten",
                      .api = {"stokesbook::GmresOptions"}},
            .control = Control{"preconditioned from the left",
                               true_residuals(&SolvableSystem::from_the_left)}},
           {.key = "left",
            .label = "preconditioned from the left",
            .measure = true_residuals(&SolvableSystem::from_the_left)}},
      .operation = "iterations"};
}

Experiment solvers() {
  return {.key = "solvers",
          .title = "Error of the velocities, four woven ellipses 6:1",
          .x = "tolerance",
          .error = "largest error of a velocity, relative to the largest",
          .lines = {{.key = "blocks",
                     .label = "GMRES, block-diagonal",
                     .measure = velocity_errors(&SolvableSystem::from_the_right),
                     .claim = Claim{.id = "05_23",
                                    .statement = "Velocities err by no more than ten times the "
                                                 "tolerance.",
                                    .law = ErrorBelowTolerance{10.0, 0.1},
                                    .reason = "the solver of suspensions estimates its error so: "
                                              "a velocity is a mean of the density, whose error "
                                              "is A^{-1} r; not less than a tenth, which an "
                                              "iteration gains",
                                    .api = {"stokesbook::gmres"}},
                     .control = Control{"stopped after 20 iterations, converged or not",
                                        velocity_errors(&SolvableSystem::from_the_right, 20)}},
                    {.key = "none",
                     .label = "GMRES, no preconditioner",
                     .measure = velocity_errors(&SolvableSystem::unpreconditioned)},
                    {.key = "dense",
                     .label = "LU factorisation of the dense matrix",
                     .measure = by_factorisation}},
          .work_precision = true,
          .operation = "matrix-vector products"};
}

}  // namespace stokesbook::verification::krylov
