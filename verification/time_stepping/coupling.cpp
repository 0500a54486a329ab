// Measures the errors of the lagged coupling: a sweep contracts errors by a factor that depends on
// the gap, and not on the time step.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/once.hpp"
#include "support/point_sets.hpp"
#include "suspension/solver/density_history.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;
using Eigen::VectorXd;

namespace {

/// Selects the blocks by which a sweep inverts the diagonal of the system.
enum class Blocks { own, half };

Scene pair_of_nodes(double gap, int n_nodes) {
  Scene pair;
  pair.flow = ShearFlow{1.0};
  for (const double side : {-1.0, 1.0}) {
    Body body;
    body.shape = Circle{1.0};
    body.position = side * (1.0 + 0.5 * gap);
    body.n_nodes = n_nodes;
    pair.bodies.push_back(body);
  }
  pair.solver.preconditioner = PreconditionerKind::block_diagonal;
  return pair;
}

/// Returns the asymptotic factor by which a sweep contracts an error.
///
/// @param  blocks  half is a planted defect: the blocks are the jump relation only, without the
///                 layer of the curve on itself
double contraction(double gap, Blocks blocks) {
  const SuspensionSolver solver(pair_of_nodes(gap, automatic_nodes));
  const Instant start = solver.start();
  const std::vector<Gap> gaps = solver.gaps(start.configuration);
  const LinearSystem discrete = solver.linear_system(
      start, solver.discretise(solver.first_resolutions(start.configuration, gaps)));
  const auto sweep = [&](const VectorXd& error) -> VectorXd {
    const ComplexVector velocity = discrete.system(deinterleaved(error));
    if (blocks == Blocks::half) return error + 2.0 * interleaved(velocity);
    return error - discrete.precondition(interleaved(velocity));
  };
  const ComplexVector random = test::random_vector(discrete.system.offsets().back(), 1);
  VectorXd error = interleaved(random);
  // The eigenvalues come in pairs of opposite sign, so the modulus follows from two sweeps. The
  // other modes decay as the cube of the first.
  const int sweeps = 20 + static_cast<int>(12.0 / std::pow(gap, 1.5));
  double factor = 0.0;
  for (int k = 0; k < std::min(sweeps, 4000); ++k) {
    const VectorXd next = sweep(sweep(error.normalized()));
    factor = std::sqrt(next.norm());
    error = next;
  }
  return factor;
}

/// Returns the factor in closed form, for mode 2 of two circles in bipolar coordinates (13.2).
double exact_contraction(double gap) {
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  return std::exp(-4.0 * alpha + std::asinh(2.0 * std::sinh(2.0 * alpha)));
}

const std::vector<double>& gaps(Size size) {
  static const std::vector<double> few{0.03, 0.05, 0.1, 0.2, 0.5, 1.0},
      many{0.01, 0.02, 0.03, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0};
  return size == Size::quick ? few : many;
}

Measure differences(Blocks blocks) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const double gap : gaps(size)) {
      measurements.push_back(
          {.x = gap, .error = std::abs(contraction(gap, blocks) - exact_contraction(gap))});
    }
    return measurements;
  };
}

/// Selects the event at the beginning of the last step of a lagged run: a reversal of the flow,
/// with or without a reversal of the stored densities.
enum class Event { none, reversal, reversal_that_is_told };

/// Returns the error of the velocity after a unit of time of the lagged coupling. The two circles
/// move round each other by a given motion, and their densities lag by a step. Only the last
/// hundred steps are computed: a hundred sweeps reduce earlier errors to a thousandth at a gap of
/// 0.05, and to less at wider gaps.
double error_of_lagged(double gap, int steps, Event event) {
  const SuspensionSolver solver(pair_of_nodes(gap, 112));
  const auto at = [gap](double t) -> Configuration {
    const Complex position = std::polar(1.0 + 0.5 * gap, t);
    return {{-position, 0.0}, {position, 0.0}};
  };
  const Solution exact = solver.solve(solver.instant(at(1.0)));
  const auto time = [=](int k) { return static_cast<double>(k) / steps; };
  const int begin = std::max(0, steps - 100);
  const Solution first = solver.solve(solver.instant(at(time(begin))));
  DensityHistory densities(1);
  densities.add(time(begin), at(time(begin)), first.discretisation, first.density);
  Solution lagged;
  for (int k = begin + 1; k <= steps; ++k) {
    const double t = time(k);
    const bool reverses = k == steps && event != Event::none;
    if (reverses && event == Event::reversal_that_is_told) densities.reverse(t);
    const auto before = [&](const Discretisation& discretisation) {
      return densities.guess(t, at(t), discretisation);
    };
    const auto& [configuration, forcing, cell, shifts] = solver.instant(at(t));
    lagged = solver.solve_lagged({configuration, scaled(reverses ? -1.0 : 1.0, forcing)}, before);
    densities.add(t, at(t), lagged.discretisation, lagged.density);
  }
  const double amplitude = event == Event::none ? 1.0 : -1.0;
  const Complex velocity = exact.motions[0].velocity;
  return std::abs(amplitude * lagged.motions[0].velocity - velocity) / std::abs(velocity);
}

Measure errors_of_lagged(double gap, Event event) {
  return [=](Size size) {
    static test::Once<std::tuple<double, int, Event>, double> errors;
    std::vector<Measurement> measurements;
    for (int steps = 25; steps <= (size == Size::full ? 1600 : 400); steps *= 2) {
      measurements.push_back({.x = static_cast<double>(steps),
                              .error = errors({gap, steps, event},
                                              [&] { return error_of_lagged(gap, steps, event); })});
    }
    return measurements;
  };
}

Measure what_is_lost(double (*factor)(double gap)) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double gap : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0}) {
      measurements.push_back({.x = gap, .error = 1.0 - factor(gap)});
    }
    return measurements;
  };
}

}  // namespace

Experiment sweeps() {
  return {
      .key = "sweeps",
      .title = "Sweeps of block Jacobi on two circles",
      .x = "gap, in radii, g",
      .error = "contraction by a sweep, and the closed form less it",
      .lines = {{.key = "difference",
                 .label = "measured less closed form",
                 .measure = differences(Blocks::own),
                 .claim = Claim{.id = "09_29",
                                .statement = "A lagged sweep over two circles contracts errors by "
                                             "e^(-4 a + asinh(2 sinh 2 a)), cosh a = 1 + g/2.",
                                .law = AtMost{1e-5},
                                .reason = "mode 2 of the pair in bipolar coordinates has the "
                                          "preconditioned eigenvalue farthest from 1",
                                .api = {"stokesbook::SuspensionSolver::solve_lagged"}},
                 .control = Control{"-1/2 instead of the own blocks", differences(Blocks::half)}},
                {.key = "left",
                 .label = "1 less closed form",
                 .measure = what_is_lost(exact_contraction)}}};
}

Experiment lagged() {
  return {
      .key = "lagged",
      .title = "The lagged coupling by the time step, two circles that turn about each other",
      .x = "steps a unit of time, (1/h)",
      .error = "error of the velocity, relative",
      .lines = {
          {.key = "gap_02",
           .label = "gap 0.2",
           .measure = errors_of_lagged(0.2, Event::none),
           .claim =
               Claim{.id = "09_30",
                     .statement = "Where densities change smoothly the lagged coupling is of "
                                  "order 1.",
                     .law = Algebraic{1.0, 0.2},
                     .window = {.from = 80.0},
                     .reason = "a step adds h eta' to the error, and a sweep leaves the factor rho "
                               "of all that was there: h rho / (1 - rho) eta' in the end, where "
                               "h / (1 - rho) is a tenth of the time sqrt(g) in which a gap passes "
                               "by a node, or less",
                     .api = {"stokesbook::SuspensionSolver::solve_lagged"}},
           .control = Control{"a flow that reverses with the last step",
                              errors_of_lagged(0.2, Event::reversal)}},
          {.key = "gap_05", .label = "gap 0.5", .measure = errors_of_lagged(0.5, Event::none)},
          {.key = "gap_005", .label = "gap 0.05", .measure = errors_of_lagged(0.05, Event::none)},
          {.key = "jump",
           .label = "gap 0.2, the flow reverses with the last step",
           .measure = errors_of_lagged(0.2, Event::reversal),
           .claim = Claim{.id = "09_31",
                          .statement = "Where loads jump the error of the lagged coupling does not "
                                       "depend on the time step.",
                          .law = Algebraic{0.0, 0.05},
                          .reason = "after one sweep it is the factor of the sweep times the jump",
                          .api = {"stokesbook::SuspensionSolver::solve_lagged"}},
           .control = Control{"densities that reverse with the flow",
                              errors_of_lagged(0.2, Event::reversal_that_is_told)}}}};
}

}  // namespace stokesbook::verification::time_stepping
