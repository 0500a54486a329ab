// What the lagged coupling leaves: a sweep contracts errors by a factor that knows the gap and no
// time step.
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/point_sets.hpp"
#include "suspension/solver.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;
using Eigen::VectorXd;

namespace {

/// What inverts the diagonal of the system.
enum class Blocks { own, half };

Scene pair(double gap) {
  Scene pair;
  pair.flow = ShearFlow{1.0};
  for (const double side : {-1.0, 1.0}) {
    Body body;
    body.shape = Circle{1.0};
    body.position = side * (1.0 + 0.5 * gap);
    body.n_nodes = automatic_nodes;
    pair.bodies.push_back(body);
  }
  pair.solver.preconditioner = PreconditionerKind::block_diagonal;
  return pair;
}

/// Factor by which a sweep contracts an error, in the end.
///
/// @param  blocks  half is a planted defect: the jump relation without the layer of the own curve
double contraction(double gap, Blocks blocks) {
  const SuspensionSolver solver(pair(gap));
  const Configuration start = solver.initial_configuration();
  const DiscreteProblem discrete =
      solver.discretise(start, solver.references(solver.first_resolutions(start)));
  const auto sweep = [&](const VectorXd& error) -> VectorXd {
    const ComplexVector velocity = discrete.system(deinterleaved(error));
    if (blocks == Blocks::half) return error + 2.0 * interleaved(velocity);
    return error - discrete.precondition(interleaved(velocity));
  };
  const ComplexVector random = test::random_vector(discrete.system.offsets().back(), 1);
  VectorXd error = interleaved(random);
  // Moduli come in pairs of both signs: two sweeps tell. Other modes fade as the cube of the first.
  const int sweeps = 20 + static_cast<int>(12.0 / std::pow(gap, 1.5));
  double factor = 0.0;
  for (int k = 0; k < std::min(sweeps, 4000); ++k) {
    const VectorXd next = sweep(sweep(error.normalized()));
    factor = std::sqrt(next.norm());
    error = next;
  }
  return factor;
}

/// The same in closed form: mode 2 of two circles in bipolar coordinates, chapter 05.
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
                 .claim = Claim{.id = "09_30",
                                .statement = "A lagged sweep over two circles contracts errors by "
                                             "e^(-4 a + asinh(2 sinh 2 a)), cosh a = 1 + g/2.",
                                .law = Identity{1e-5},
                                .reason = "mode 2 of the pair in bipolar coordinates has the "
                                          "preconditioned eigenvalue farthest from 1",
                                .api = {"stokesbook::SuspensionSolver::solve_lagged"}},
                 .control = Control{"-1/2 instead of the own blocks", differences(Blocks::half)}},
                {.key = "left",
                 .label = "1 less closed form",
                 .measure = what_is_lost(exact_contraction)}}};
}

}  // namespace stokesbook::verification::time_stepping
