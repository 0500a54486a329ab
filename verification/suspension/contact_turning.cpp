// Compares Euler's and Heun's steps in a container that turns with its suspension: the exact motion
// is a rigid rotation, in which no contact begins.
#include <algorithm>
#include <complex>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

/// Measures a run whose container turns at a rate: the largest distance of a body from its place
/// after a rotation at the rate 1, over half its length.
Measurement turned(Size size, const TimeSettings& time, double x, double rate) {
  Scene scene = turning_ellipses(size, rate);
  scene.time = time;
  scene.time->t_final = size == Size::full ? 1.0 : 0.3;
  scene.output.dt_write = scene.time->t_final;
  const RecordedRun run = recorded_run(scene);
  const std::vector<BodyState>&start = run.frames.front().bodies, &end = run.frames.back().bodies;
  const Complex rotation = std::polar(1.0, scene.time->t_final);
  const double half_length = std::get<Ellipse>(scene.bodies.front().shape).a;
  Measurement measurement{.x = x, .operations = 0.0};
  for (std::size_t k = 0; k < start.size(); ++k) {
    const double distance = std::abs(end[k].position - rotation * start[k].position);
    measurement.error = std::max(measurement.error, distance / half_length);
  }
  for (const StepInfo& step : run.steps) measurement.operations += step.matvecs;
  return measurement;
}

Measure by_heun(double rate) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const double tolerance : {1e-3, 3e-3, 1e-2}) {
      const TimeSettings time{.dt = 0.3, .method = SteppingMethod::heun, .tolerance = tolerance};
      measurements.push_back(turned(size, time, tolerance, rate));
    }
    return measurements;
  };
}

std::vector<Measurement> by_euler(Size size) {
  std::vector<Measurement> measurements;
  for (const double dt : {0.03, 0.1, 0.3}) {
    const TimeSettings time{.dt = dt, .method = SteppingMethod::euler};
    measurements.push_back(turned(size, time, dt, 1.0));
  }
  return measurements;
}

}  // namespace

Experiment contact_turning() {
  return {.key = "contact_turning",
          .title = "A container that turns with its suspension: steps that meet no contact",
          .x = "tolerance of Heun's steps, or length of Euler's, Δt",
          .error = "largest distance from the rigid rotation, in half lengths of a body",
          .lines = {{.key = "heun",
                     .label = "Heun, adapted steps",
                     .measure = by_heun(1.0),
                     .claim = Claim{.id = "12_61",
                                    .statement = "Adapted steps of Heun's method follow the rigid "
                                                 "rotation of a container to their tolerance.",
                                    .law = ErrorBelowTolerance{1.0, 0.01},
                                    .reason = "the errors of the steps have one sign in a rotation "
                                              "and add up, but each is far below its bound",
                                    .api = {"stokesbook::Simulation"}},
                     .control = Control{"a container that turns faster by 3 %", by_heun(1.03)}},
                    {.key = "euler", .label = "Euler, fixed steps", .measure = by_euler}},
          .work_precision = true,
          .operation = "matrix-vector products"};
}

}  // namespace stokesbook::verification::suspension
