// Runs published experiments by the published method and by ours, and records error, work and time.
#include "methods.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <tuple>

#include "scenes.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::suspension {

using study::Size;

namespace {

// Tolerances of velocities: the loosest tolerance of our method, and one that the published nodes
// meet in all runs.
constexpr double loosest = 1e-2, met_by_equal_nodes = 3e-2;

Scene stepped(Scene scene, Way way, const Trial& trial, double parameter) {
  scene.solver = {.tolerance = met_by_equal_nodes};
  scene.solver.preconditioner = PreconditionerKind::block_diagonal;
  if (way == Way::ours) {
    scene.solver.tolerance = std::min(loosest, parameter);
    scene = with_nodes(scene, automatic_nodes, automatic_nodes);
  } else {
    scene.solver.gmres_tol = 1e-6;
    scene.solver.near_singular = NearSingular::interpolation;
  }
  if (way == Way::published) {
    scene.time->method = SteppingMethod::euler;
    scene.time->dt = parameter;
  } else {
    scene.time->method = trial.adapted;
    scene.time->tolerance = parameter;
    scene.time->dt = 0.1;  // the first step
  }
  return scene;
}

std::vector<double> bodies_at_end(const std::vector<Frame>& frames) {
  std::vector<double> values;
  for (const BodyState& body : frames.back().bodies) {
    values.insert(values.end(), {body.position.real(), body.position.imag(), body.orientation});
  }
  return values;
}

std::vector<double> observed(const Trial& trial, const std::vector<Frame>& frames) {
  return trial.observed != nullptr ? trial.observed(frames) : bodies_at_end(frames);
}

const std::vector<double>& expected(const Trial& trial, const Scene& scene,
                                    const test::RecordedRun& any) {
  static test::Once<std::string, std::vector<double>> found;
  return found(trial.key, [&] {
    if (trial.reference == nullptr) return observed(trial, {any.frames.front()});
    return observed(trial, test::recorded_run(trial.reference(scene)).frames);
  });
}

Outcome outcome(const Trial& trial, Way way, double parameter) {
  static test::Once<std::tuple<std::string, Way, double>, Outcome> found;
  return found({trial.key, way, parameter}, [&] {
    const Scene scene = trial.scene();
    const std::clock_t start = std::clock();
    const test::RecordedRun done = test::recorded_run(stepped(scene, way, trial, parameter));
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const std::vector<int>& most = done.resolution.most_nodes;
    const double nodes = std::accumulate(most.begin(), most.end(), 0.0);
    const std::vector<double> values = observed(trial, done.frames),
                              right = expected(trial, scene, done);
    double error = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      error = std::max(error, std::abs(values[k] - right[k]));
    }
    // Each solve applies the operator once in every iteration, and once to its initial guess.
    const long long applications =
        way == Way::published
            ? done.totals.gmres_iterations + done.totals.solves + done.totals.contact_solves
            : done.totals.matvecs;
    return Outcome{error, 1e-6 * static_cast<double>(applications) * nodes * nodes,
                   static_cast<double>(done.totals.steps), seconds};
  });
}

}  // namespace

std::vector<Outcome> outcomes(const Trial& trial, Way way, Size size) {
  const bool published = way == Way::published;
  std::vector<double> parameters = published ? trial.steps : trial.tolerances;
  if (size == Size::full) {
    const double factor = published ? 2.0 : 3.0;
    for (int k = 0; k < 2; ++k) parameters.push_back(parameters.back() / factor);
  }
  std::vector<Outcome> found;
  for (const double parameter : parameters) found.push_back(outcome(trial, way, parameter));
  return found;
}

}  // namespace stokesbook::verification::suspension
