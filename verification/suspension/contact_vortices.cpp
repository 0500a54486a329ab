// Runs the published 48 ellipses in Taylor-Green vortices with contact, and measures the error of
// the contact mobility under the lagged coupling.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "experiments.hpp"
#include "support/exact_gaps.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

constexpr double published_separation = 0.00313;  // 0.05 times the published node spacing

// The full study takes the published steps. The quick study takes steps ten times as long, which
// lead to contact early.
struct Vortices {
  Scene scene;
  RecordedRun run;
};

/// @param  parts       number of parts into which the longest published step is divided
/// @param  separation  gap that contact keeps
const Vortices& vortices(Size size, int parts, double separation = published_separation) {
  static Once<std::tuple<Size, int, double>, Vortices> runs;
  return runs({size, parts, separation}, [&] {
    Scene scene = ellipses_in_vortices(1e-3);
    scene.contact = ContactSettings{separation};
    scene = size == Size::full ? over(scene, 30.0, 0.025 / parts) : over(scene, 4.5, 0.25 / parts);
    scene.output.dt_write = size == Size::full ? 1.0 : 0.5;
    return Vortices{scene, recorded_run(scene)};
  });
}

/// Measures by how much gaps fall short of the published separation, relative to it.
Measure lost_in_vortices(double separation) {
  return [=](Size size) {
    const auto& [scene, run] = vortices(size, 1, separation);
    std::vector<Measurement> measurements;
    for (const Frame& frame : run.frames) {
      if (frame.t == 0.0) continue;
      const double gap = least_exact_gap(placed_shapes(scene, frame), 0.05);
      measurements.push_back(
          {.x = frame.t, .error = std::max(0.0, 1.0 - gap / published_separation)});
    }
    return measurements;
  };
}

Measure iterations_so_far(int parts) {
  return [=](Size size) {
    const auto& [scene, run] = vortices(size, parts);
    std::vector<Measurement> measurements;
    for (const Frame& frame : run.frames) {
      if (frame.t == 0.0) continue;
      double iterations = 0.0;
      for (const StepInfo& step : run.steps) {
        if (step.t <= frame.t) iterations += step.ncp_iterations;
      }
      measurements.push_back({.x = frame.t, .error = iterations});
    }
    return measurements;
  };
}

/// Holds a scene, and the two bodies that a pair of unit forces pulls apart.
struct Pull {
  Scene scene;
  std::size_t left, right;
};

Pull disks(double gap) {
  Pull pull{{}, 0, 1};
  for (const double side : {-1.0, 1.0}) {
    pull.scene.bodies.push_back({.shape = Circle{1.0}, .position = side * (1.0 + 0.5 * gap)});
  }
  return pull;
}

// Selects two of the 48 ellipses that lie tip to tip. All columns are shifted so that the gaps
// between neighbouring columns are equal.
Pull tips(double gap) {
  Pull pull{ellipses_in_vortices(), 17, 29};
  for (Body& body : pull.scene.bodies) {
    const double column = body.position.real() > 0.0 ? 1.0 : -1.0;
    const bool inner = std::abs(body.position.real()) < 1.0;
    body.position = {column * (inner ? 1.0 : 3.0) * (0.475 + 0.5 * gap), body.position.imag()};
  }
  return pull;
}

/// Holds the speed at which the pull opens the gap, for each coupling.
struct Response {
  double coupled, lagged;
  double told;  ///< lagged; the densities of the other bodies are those under the force
};

Response solved_response(Pull pull) {
  Scene& scene = pull.scene;
  scene.flow = QuiescentFlow{};
  scene.gauge_length = 30.0;  // arbitrary: the forces balance
  scene.solver.tolerance = 1e-4;
  scene.solver.preconditioner = PreconditionerKind::block_diagonal;
  scene.solver.gmres_max_iterations = 2000;
  scene.bodies[pull.left].force = -1.0;
  scene.bodies[pull.right].force = 1.0;
  const SuspensionSolver solver(scene);
  const Instant start = solver.start();
  const auto opening = [&](const Solution& solution) {
    return (solution.motions[pull.right].velocity - solution.motions[pull.left].velocity).real();
  };
  // A lagged solve takes the densities of the other bodies from the time before the contact force
  // acts. These densities are 0.
  const auto nothing = [](const Discretisation& discretisation) -> ComplexVector {
    Eigen::Index nodes = 0;
    for (const auto& shape : discretisation) nodes += shape->curve.size();
    return ComplexVector::Zero(nodes);
  };
  const Solution coupled = solver.solve(start);
  DensityHistory densities(1);
  densities.add(0.0, start.configuration, coupled.discretisation, coupled.density);
  const auto known = [&](const Discretisation& discretisation) {
    return densities.guess(0.0, start.configuration, discretisation);
  };
  return {opening(coupled), opening(solver.solve_lagged(start, nothing)),
          opening(solver.solve_lagged(start, known))};
}

using MakePull = Pull (*)(double gap);

const Response& response(MakePull pull, double gap) {
  static Once<std::pair<MakePull, double>, Response> found;
  return found({pull, gap}, [=] { return solved_response(pull(gap)); });
}

Measure ratios(MakePull pull, double Response::*opening = &Response::lagged) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const bool full = size == Size::full;
    const double factor = full ? 2.0 : 4.0, least = full || pull == disks ? 1.0 / 4096 : 1.0 / 1024;
    for (double gap = least; gap <= 1.0 / 32; gap *= factor) {
      const Response& found = response(pull, gap);
      measurements.push_back({.x = gap, .error = found.*opening / found.coupled});
    }
    return measurements;
  };
}

}  // namespace

Experiment taylor_green_in_contact() {
  return left_to_full(
      {.key = "vortices_in_contact",
       .title = "48 ellipses in Taylor-Green vortices, kept 0.05 of the published spacing apart; "
                "steps of 0.025 unless said, in the quick size ten times as long",
       .x = "time t",
       .error = "part of the separation, or number",
       .axes = Axes::no_law,
       .lines = {
           {.key = "lost",
            .label = "shortfall of the narrowest gap, relative to the separation",
            .measure = lost_in_vortices(published_separation),
            .claim = Claim{.id = "12_21",
                           .statement = "The published run in vortices reaches its end with all "
                                        "gaps resolved, none below the separation.",
                           .law = AtMost{1e-3},
                           .reason = "contact is resolved with the mobility of all bodies "
                                     "together, and nodes crowd where gaps are narrow",
                           .api = {"stokesbook::SuspensionContact"}},
            .control = Control{"contact keeps 99 % of the separation",
                               lost_in_vortices(0.99 * published_separation)}},
           {.key = "iterations",
            .label = "contact iterations so far; published 290 at t = 30",
            .measure = iterations_so_far(1)},
           {.key = "iterations_2",
            .label = "the same, steps half as long; published 559",
            .measure = iterations_so_far(2)},
           {.key = "iterations_4",
            .label = "the same, steps a quarter as long; published 559",
            .measure = iterations_so_far(4)}}});
}

Experiment lagged_contact() {
  return {
      .key = "lagged_contact",
      .title =
          "Speed at which contact forces open a gap, by the lagged coupling over the coupled "
          "scheme",
      .x = "gap g",
      .error = "opening under a pair of forces, lagged over coupled",
      .lines = {
          {.key = "disks",
           .label = "two disks of radius 1",
           .measure = ratios(disks),
           .claim = Claim{.id = "12_22",
                          .statement = "With the lagged coupling contact forces are too weak by a "
                                       "factor that grows like g^(-3/2), whatever the time step.",
                          .law = Algebraic{1.5, 0.05},
                          .window = {.to = 0.005},
                          .reason = "a body alone moves as if no fluid had to leave the gap; "
                                    "together they separate by g^(3/2), the law of lubrication. No "
                                    "time step enters, and forces are found from this response",
                          .api = {"stokesbook::SuspensionSolver::solve_lagged"}},
           .control = Control{"densities of the other body under the force",
                              ratios(disks, &Response::told)}},
          {.key = "tips", .label = "tips of two of the 48 ellipses", .measure = ratios(tips)}}};
}

}  // namespace stokesbook::verification::suspension
