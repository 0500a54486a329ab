// Runs the published Couette cells, and records viscosity, order parameter, gaps and costs for the
// tables and claims of chapter 12.
#include "couette_series.hpp"

#include <chrono>
#include <cmath>
#include <numbers>
#include <variant>

#include "support/exact_gaps.hpp"
#include "support/recorded_run.hpp"
#include "sweep/results.hpp"

namespace stokesbook::verification::suspension {

namespace {

/// Returns the shear rate at a distance from the axis, without bodies.
double shear_rate(const Scene& scene, double r) {
  double outer = 0.0, inner = 0.0, omega = 0.0;
  for (const Wall& wall : scene.walls) {
    const double radius = std::get<Circle>(wall.shape).radius;
    (wall.role == WallRole::outer ? outer : inner) = radius;
    if (wall.role == WallRole::outer) omega = std::get<RotatingWall>(wall.motion).omega;
  }
  const double inner2 = inner * inner, outer2 = outer * outer;
  return 2.0 * omega * inner2 * outer2 / ((outer2 - inner2) * r * r);
}

/// Returns cos 2 psi of an ellipse at the angle psi from the stream (chapter 07). The phase tau,
/// defined by tan psi = tan(tau) / lambda, grows linearly in time. The stream is slower on its
/// left, towards the axis.
double alignment(double aspect, double rate, double psi, double t) {
  const double phase = std::atan2(aspect * std::sin(psi), std::cos(psi)) +
                       aspect * rate * t / (1.0 + aspect * aspect);
  const double along = aspect * std::cos(phase), across = std::sin(phase);
  return (along * along - across * across) / (along * along + across * across);
}

}  // namespace

double order_alone(const Scene& scene, double t) {
  double sum = 0.0;
  for (const Body& body : scene.bodies) {
    const auto& [a, b] = std::get<Ellipse>(body.shape);
    const double stream = std::arg(body.position) + 0.5 * std::numbers::pi;
    const double rate = shear_rate(scene, std::abs(body.position));
    sum += alignment(a / b, rate, body.orientation - stream, t);
  }
  return sum / static_cast<double>(scene.bodies.size());
}

std::vector<Body> every_other(const std::vector<Body>& bodies) {
  std::vector<Body> kept;
  for (std::size_t k = 0; k < bodies.size(); k += 2) kept.push_back(bodies[k]);
  return kept;
}

CouetteSeries couette_series(const Scene& scene, double separation) {
  using clock = std::chrono::steady_clock;
  const clock::time_point start = clock::now();
  const test::RecordedRun run = test::recorded_run(scene);
  CouetteSeries series;
  series.seconds = std::chrono::duration<double>(clock::now() - start).count();
  series.steps = run.totals.steps;
  series.gmres_iterations = run.totals.gmres_iterations;
  series.contact_iterations = run.totals.ncp_iterations;
  series.largest_estimate = run.resolution.velocity_error / scene.solver.tolerance;
  series.least_gap = test::least_exact_gap(scene, run.frames, 2.0 * separation) / separation;
  for (const Frame& frame : run.frames) {
    series.revolutions.push_back(frame.t / (2.0 * std::numbers::pi));
    series.viscosity.push_back(1e3 * frame.rheology.torque_ratio);
    series.order.push_back(1e3 * frame.rheology.order_parameter);
    series.order_alone.push_back(1e3 * order_alone(scene, frame.t));
  }
  return series;
}

double mean(const CouetteSeries& series, const CouetteProperty& property, double from, double to) {
  return time_average(series.revolutions, series.*property.values, from, to);
}

}  // namespace stokesbook::verification::suspension
