// Shows the effect of restarts on GMRES, for two circles that nearly touch.
#include "experiments.hpp"
#include "support/body_systems.hpp"

namespace stokesbook::verification::krylov {

using namespace study;
using Eigen::Index;

namespace {

constexpr double restart_gap = 1e-2;

Measure history(int length) {
  return [=](Size) {
    const Index nodes = nodes_at_gap(restart_gap);
    const BodySystem system(circle_pair(restart_gap), nodes, generic_flow);
    const LinearMap solve_blocks = block_diagonal(circle_pair(restart_gap), nodes);
    const std::vector<double> residuals =
        restarted(system.map(), solve_blocks, system.rhs(), length, 120);
    std::vector<Measurement> measurements;
    for (std::size_t k = 1; k < residuals.size() && residuals[k - 1] > 1e-10; ++k) {
      measurements.push_back({.x = static_cast<double>(k), .error = residuals[k]});
    }
    return measurements;
  };
}

}  // namespace

Experiment restarts() {
  return {.key = "restarts",
          .title = "Restarts, for two circles with the gap 1e-2",
          .x = "matrix-vector products k",
          .error = "residual, relative to the right-hand side",
          .axes = Axes::semi_log,
          .lines = {{.key = "never", .label = "no restart", .measure = history(120)},
                    {.key = "thirty", .label = "every 30 iterations", .measure = history(30)},
                    {.key = "ten", .label = "every 10 iterations", .measure = history(10)}}};
}

}  // namespace stokesbook::verification::krylov
