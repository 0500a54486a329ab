// Compares error and work of dense systems and GMRES, for wide and narrow gaps, with equal numbers
// of nodes on both circles or with equal spacings.
#include <chrono>
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "krylov/gmres.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

struct Solved {
  Load load;
  double kernel_evaluations;
};

Solved by_dense(const StokesProblem& problem, AnnulusMatrix matrix) {
  const double nodes = static_cast<double>(node_offsets(problem).back());
  return {solve_annulus(problem, matrix(problem)).load, nodes * nodes};
}

/// Solves by GMRES; the operator is the sum of double layer, closure and N_0, applied to values.
Solved by_gmres(const StokesProblem& problem) {
  const Closure closure(problem);
  const Curve &inner = problem.components[0].curve, &wall = problem.components[1].curve;
  const StressletSum sum({inner, wall});
  const LinearMap apply = [&](const VectorXd& x) -> VectorXd {
    const ComplexVector density = deinterleaved(x), rest = closure.without_rigid_part(density);
    ComplexVector u = sum(rest) - 0.5 * rest + closure.velocity(density);
    u.head(inner.size()) += diagonal_velocity(inner, rest.head(inner.size()));
    u.tail(wall.size()) += diagonal_velocity(wall, rest.tail(wall.size())) +
                           null_space_velocity(wall, rest.tail(wall.size()));
    return interleaved(u);
  };
  const ComplexVector rhs = closure.right_hand_side();
  const GmresResult result = gmres(apply, {}, interleaved(rhs), {1e-13, 200});
  const double nodes = static_cast<double>(sum.size());
  return {closure.complete(deinterleaved(result.solution)).loads[0],
          (result.iterations + 1.0) * nodes * nodes};
}

using Solve = std::function<Solved(const StokesProblem&)>;

const Solve dense = [](const StokesProblem& problem) { return by_dense(problem, right_matrix); };
const Solve dense_without = [](const StokesProblem& problem) {
  return by_dense(problem, matrix_without_n0);
};

/// Measures errors by the mean number N of nodes of a circle. The outer circle has `ratio` times as
/// many nodes as the inner one.
Measure measure(double relative_gap, Index ratio, const Solve& solve) {
  const test::EccentricAnnulus annulus = eccentric_annulus(relative_gap);
  const Load exact = inner_load(annulus, 1.0);
  return [=](Size size) {
    const Index step = relative_gap < 0.5 ? 48 : 16, most = size == Size::full ? 6 : 4;
    std::vector<Measurement> measurements;
    for (Index n = step; n <= most * step; n += step) {
      const Index inner = 2 * n / (1 + ratio);
      const StokesProblem problem = annulus_problem(annulus, 1.0, inner, ratio * inner);
      const auto start = std::chrono::steady_clock::now();
      const Solved solved = solve(problem);
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      measurements.push_back({.x = static_cast<double>(n),
                              .error = relative_difference(solved.load, exact),
                              .unknowns = 4.0 * static_cast<double>(n),
                              .operations = solved.kernel_evaluations,
                              .seconds = taken.count()});
    }
    return measurements;
  };
}

}  // namespace

Experiment work() {
  return {
      .key = "work",
      .title = "Work for the load of the inner circle",
      .x = "mean nodes a circle N",
      .error = "relative error of the inner circle's load",
      .axes = Axes::semi_log,
      .lines =
          {{.key = "wide", .label = "gap 0.5, dense", .measure = measure(0.5, 1, dense)},
           {.key = "wide_gmres", .label = "gap 0.5, GMRES", .measure = measure(0.5, 1, by_gmres)},
           {.key = "wide_without",
            .label = "gap 0.5, dense, without N_0",
            .measure = measure(0.5, 1, dense_without)},
           {.key = "near", .label = "gap 0.1, dense", .measure = measure(0.1, 1, dense)},
           {.key = "near_spacing",
            .label = "gap 0.1, dense, equal spacing",
            .measure = measure(0.1, 2, dense)},
           {.key = "touching", .label = "gap 0.01, dense", .measure = measure(0.01, 1, dense)}},
      .work_precision = true,
      .operation = "kernel evaluations"};
}

}  // namespace stokesbook::verification::null_space
