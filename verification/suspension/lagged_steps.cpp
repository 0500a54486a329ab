// Follows the lagged coupling step by step in a crowd: each step is a sweep of block Jacobi, whose
// errors grow for any length of the step.
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"
#include "support/spectra.hpp"
#include "support/touching.hpp"
#include "support/vectors.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

constexpr int most_steps = 40;

Scene crowd_in_vortices(Coupling coupling) {
  Scene scene = ellipses_in_vortices(1e-2);
  scene.solver.coupling = coupling;
  scene.solver.preconditioner = PreconditionerKind::block_diagonal;
  return scene;
}

/// Runs the first steps of the 48 ellipses, until the solver rejects a step. The run of the coupled
/// scheme, the control, ends after 8 steps.
const RecordedRun& run_of(double dt, Coupling coupling) {
  static Once<std::pair<double, Coupling>, RecordedRun> runs;
  return runs({dt, coupling}, [=] {
    const int steps = coupling == Coupling::local ? most_steps : 8;
    Scene scene = over(crowd_in_vortices(coupling), steps * dt, dt);
    scene.output.dt_write = steps * dt;
    return recorded_run(scene, Refusals::recorded);
  });
}

Measure residuals(double dt) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    double step = 0.0;
    for (const StepInfo& info : run_of(dt, Coupling::local).steps) {
      measurements.push_back({.x = ++step, .error = info.residual});
    }
    return measurements;
  };
}

/// Returns the largest modulus of the eigenvalues of a sweep at the start, by Arnoldi's method. The
/// sweep does not depend on the time step.
double spectral_radius() {
  static Once<int, double> found;
  return found(0, [] {
    constexpr Eigen::Index m = 40;
    const Discretised start(crowd_in_vortices(Coupling::local));
    const auto sweep = [&](const Eigen::VectorXd& error) -> Eigen::VectorXd {
      return error -
             start.discrete.precondition(interleaved(start.discrete.system(deinterleaved(error))));
    };
    Eigen::MatrixXd basis(2 * start.discrete.system.right_hand_side().size(), m + 1),
        projected = Eigen::MatrixXd::Zero(m + 1, m);
    basis.col(0) = interleaved(random_vector(basis.rows() / 2, 1)).normalized();
    for (Eigen::Index k = 0; k < m; ++k) {
      Eigen::VectorXd next = sweep(basis.col(k));
      for (int pass = 0; pass < 2; ++pass) {
        const Eigen::VectorXd parts = basis.leftCols(k + 1).transpose() * next;
        next -= basis.leftCols(k + 1) * parts;
        projected.col(k).head(k + 1) += parts;
      }
      projected(k + 1, k) = next.norm();
      basis.col(k + 1) = next.normalized();
    }
    return eigenvalues(projected.topRows(m)).cwiseAbs().maxCoeff();
  });
}

/// Measures the relative difference between the spectral radius and the factor by which the
/// residual grows in a step. The factor is the geometric mean over the last six steps before the
/// solver rejects a step.
Measure growth(Coupling coupling) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double dt : {2.5e-8, 2.5e-6, 2.5e-4}) {
      const std::vector<StepInfo>& steps = run_of(dt, coupling).steps;
      const double last = steps.back().residual, before = steps[steps.size() - 7].residual;
      const double factor = std::pow(last / before, 1.0 / 6.0);
      measurements.push_back({.x = dt, .error = std::abs(factor / spectral_radius() - 1.0)});
    }
    return measurements;
  };
}

Line of_steps(const std::string& key, const std::string& label, double dt,
              Size least = Size::quick) {
  return {.key = key, .label = label, .measure = residuals(dt), .least = least};
}

}  // namespace

Experiment lagged_steps() {
  return {.key = "lagged_steps",
          .title = "48 ellipses in vortices by the lagged coupling, from the published start",
          .x = "step k",
          .error = "residual of the densities of the step before",
          .axes = Axes::semi_log,
          .lines = {of_steps("dt_2", "steps of 0.025, as published", 2.5e-2),
                    of_steps("dt_3", "0.0025", 2.5e-3, Size::full),
                    of_steps("dt_4", "0.00025", 2.5e-4), of_steps("dt_8", "2.5e-8", 2.5e-8)}};
}

Experiment lagged_growth() {
  return left_to_full(
      {.key = "lagged_growth",
       .title = "By what a step of the lagged coupling multiplies the residual",
       .x = "step h",
       .error = "growth over the spectral radius of a sweep, less 1",
       .lines = {
           {.key = "growth",
            .label = "48 ellipses in vortices",
            .measure = growth(Coupling::local),
            .claim = Claim{.id = "12_52",
                           .statement = "In a crowd the lagged coupling multiplies its error "
                                        "by the spectral radius of block Jacobi in each step, "
                                        "however short.",
                           .law = AtMost{0.1},
                           .reason = "a step is a sweep; in the few of them that it takes, "
                                     "bodies hardly move",
                           .api = {"stokesbook::SuspensionSolver::solve_lagged"}},
            .control = Control{"steps of the coupled scheme", growth(Coupling::global)}}}});
}

}  // namespace stokesbook::verification::suspension
