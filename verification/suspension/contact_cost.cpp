// What contact costs: steps of dense clusters with and without it, in counts.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "experiments.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

constexpr int steps = 4;

/// A hexagon of disks that touch but for the separation, in shear.
RecordedRun hexagon(int rings, bool in_contact, int steps_taken = steps) {
  static Once<std::tuple<int, bool, int>, RecordedRun> runs;
  return runs({rings, in_contact, steps_taken}, [&] {
    Scene scene = over(disk_hexagon(rings, 0.1, 1e-2), 0.005 * steps_taken, 0.005);
    scene.solver.gmres_max_iterations = 2000;
    if (in_contact) scene.contact = ContactSettings{0.1};
    return recorded_run(scene);
  });
}

/// In a step after the first, which finds out how exactly contact is to be solved.
double contact_solves(int rings) {
  const auto solves = [&](int steps_taken) {
    return static_cast<double>(hexagon(rings, true, steps_taken).totals.contact_solves);
  };
  return (solves(steps) - solves(1)) / (steps - 1);
}

double pairs_in_contact(const RecordedRun& run) {
  double pairs = 0.0;
  for (const StepInfo& step : run.steps) pairs += step.contacts;
  return pairs / static_cast<double>(run.steps.size());
}

double gmres_iterations(const RecordedRun& run) {
  double iterations = 0.0;
  for (const StepInfo& step : run.steps) iterations += step.gmres_iterations;
  return iterations / static_cast<double>(run.steps.size());
}

double seconds(const RecordedRun& run) {
  double sum = 0.0;
  for (const StepInfo& step : run.steps) sum += step.seconds;
  return sum / static_cast<double>(run.steps.size());
}

Measure over_rings(double (*quantity)(int rings)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int rings = 1; rings <= (size == Size::full ? 5 : 3); ++rings) {
      const int bodies = 1 + 3 * rings * (rings + 1);
      const RecordedRun run = hexagon(rings, true);
      measurements.push_back({.x = pairs_in_contact(run),
                              .error = quantity(rings),
                              .unknowns = static_cast<double>(bodies),
                              .operations = contact_solves(rings),
                              .seconds = seconds(run)});
    }
    return measurements;
  };
}

// A response to a force between any two bodies: a planted defect.
Measure all_pairs() {
  return [](Size size) {
    std::vector<Measurement> measurements = over_rings([](int) { return 1.0; })(size);
    for (Measurement& point : measurements) {
      point.operations = 0.5 * point.unknowns * (point.unknowns - 1.0);
    }
    return measurements;
  };
}

double with_contact(int rings) {
  return gmres_iterations(hexagon(rings, true));
}
double without_contact(int rings) {
  return gmres_iterations(hexagon(rings, false));
}
double share(int rings) {
  return 1.0 - without_contact(rings) / with_contact(rings);
}

double contact_iterations(int rings) {
  const RecordedRun run = hexagon(rings, true);
  return static_cast<double>(run.totals.ncp_iterations) / static_cast<double>(run.totals.steps);
}

double seconds_without(int rings) {
  return seconds(hexagon(rings, false));
}

}  // namespace

Experiment cost_of_contact() {
  return {.key = "cost_of_contact",
          .title = "A step of a hexagon of disks in shear, with and without contact",
          .x = "pairs in contact, p",
          .error = "number",
          .lines =
              {{.key = "with",
                .label = "GMRES iterations with contact",
                .measure = over_rings(with_contact),
                .claim = Claim{.id = "12_17",
                               .statement = "Contact asks for a solve for each pair in contact, "
                                            "and few for any other.",
                               .law = Cost{1.0, 0.15},
                               .reason = "rows are those of pairs that are pressed together",
                               .api = {"stokesbook::LoadResponse"}},
                .control = Control{"a solve for any two bodies", all_pairs()}},
               {.key = "without",
                .label = "GMRES iterations without",
                .measure = over_rings(without_contact)},
               {.key = "share", .label = "share of contact in these", .measure = over_rings(share)},
               {.key = "iterations",
                .label = "contact iterations",
                .measure = over_rings(contact_iterations)},
               {.key = "seconds_without",
                .label = "seconds without contact",
                .measure = over_rings(seconds_without)}},
          .work_precision = true,
          .operation = "solves for contact"};
}

}  // namespace stokesbook::verification::suspension
