#pragma once

#include <exception>
#include <string>
#include <vector>

#include "suspension/motion/simulation.hpp"

namespace stokesbook::test {

/// Keeps the frames, steps and totals of a run in memory.
struct RecordedRun {
  std::vector<Frame> frames;
  std::vector<StepInfo> steps;
  std::vector<std::string> warnings;  ///< from Observer::warning
  RunTotals totals;
  RunResolution resolution;
  std::string stopped;  ///< why the run did not reach its end; empty if it did
};

/// Selects whether an exception that ends a run early is thrown again, or its message is recorded.
/// Exceptions due to programming errors are treated in the same way.
enum class Refusals { thrown, recorded };

/// Runs a scene and keeps the results in memory.
inline RecordedRun recorded_run(const Scene& scene, Refusals refusals = Refusals::thrown) {
  RecordedRun run;
  Observer observer;
  observer.frame = [&](const Frame& frame) { run.frames.push_back(frame); };
  observer.step = [&](const StepInfo& step) { run.steps.push_back(step); };
  observer.warning = [&](const std::string& warning) { run.warnings.push_back(warning); };
  const SuspensionSolver solver(scene);
  Simulation simulation(solver, observer);
  try {
    simulation.run();
  } catch (const std::exception& error) {
    if (refusals == Refusals::thrown) throw;
    run.stopped = error.what();
  }
  run.totals = simulation.totals();
  run.resolution = simulation.resolution();
  return run;
}

/// Returns a scene in which bodies in a flow keep a separation. The scene has automatic nodes and a
/// solver tolerance of 1e-5.
inline Scene in_contact(const BackgroundFlow& flow, const std::vector<Body>& bodies,
                        double separation) {
  Scene scene;
  scene.flow = flow;
  scene.bodies = bodies;
  scene.solver.tolerance = 1e-5;
  scene.contact = ContactSettings{separation};
  return scene;
}

/// Sets the number of nodes of all bodies.
inline Scene with_nodes(Scene scene, int n_nodes) {
  for (Body& body : scene.bodies) body.n_nodes = n_nodes;
  return scene;
}

/// Adds the settings of time stepping to a scene.
inline Scene over(Scene scene, double t_final, double dt,
                  SteppingMethod method = SteppingMethod::euler) {
  scene.time = TimeSettings{t_final, dt, method};
  return scene;
}

}  // namespace stokesbook::test
