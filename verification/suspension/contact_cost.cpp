// Measures the cost of contact: counts and seconds of a step of a dense cluster, with contact and
// without.
#include <iterator>
#include <optional>
#include <tuple>

#include "experiments.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

// Holds the numbers of the first steps and of all steps. The averages skip the first steps, in
// which the solver still determines the accuracy that contact requires.
struct Steps {
  int first, all;
};

constexpr Steps steps_of(Size size) {
  return size == Size::full ? Steps{6, 12} : Steps{3, 6};
}

struct ClusterRun {
  Steps counts;
  std::vector<StepInfo> steps;
  RunTotals one, first, all;  // after one step, after the first steps, and at the end
};

/// Runs a hexagon of disks in shear whose gaps equal the separation.
const ClusterRun& hexagon(Size size, int rings, bool in_contact) {
  static Once<std::tuple<Size, int, bool>, ClusterRun> runs;
  return runs({size, rings, in_contact}, [&] {
    ClusterRun run{steps_of(size), {}, {}, {}, {}};
    Scene scene = over(disk_hexagon(rings, 0.1, 1e-2), 0.005 * run.counts.all, 0.005);
    scene.solver.gmres_max_iterations = 2000;
    if (in_contact) scene.contact = ContactSettings{0.1};
    const SuspensionSolver solver(scene);
    std::optional<Simulation> simulation;
    Observer observer;
    observer.step = [&](const StepInfo& step) {
      run.steps.push_back(step);
      if (run.steps.size() == 1) run.one = simulation->totals();
      if (std::ssize(run.steps) == run.counts.first) run.first = simulation->totals();
    };
    simulation.emplace(solver, observer);
    simulation->run();
    run.all = simulation->totals();
    return run;
  });
}

/// Averages a quantity over the steps after the first ones.
double in_a_step(const ClusterRun& run, double (*quantity)(const StepInfo& step)) {
  double sum = 0.0;
  for (int k = run.counts.first; k < run.counts.all; ++k) {
    sum += quantity(run.steps[static_cast<std::size_t>(k)]);
  }
  return sum / (run.counts.all - run.counts.first);
}

double gmres_iterations(const StepInfo& step) {
  return step.gmres_iterations;
}
double contacts(const StepInfo& step) {
  return step.contacts;
}
double iterations(const StepInfo& step) {
  return step.ncp_iterations;
}
double seconds(const StepInfo& step) {
  return step.seconds;
}

/// Averages the increase of a total over the steps after the first ones.
double in_a_step(const ClusterRun& run, double (*quantity)(const RunTotals& totals)) {
  return (quantity(run.all) - quantity(run.first)) / (run.counts.all - run.counts.first);
}

/// Holds the runs of one cluster with contact and without.
struct Cluster {
  const ClusterRun &with, &without;
};

Measure over_rings(double (*quantity)(const Cluster& cluster)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int rings = 1; rings <= (size == Size::full ? 5 : 3); ++rings) {
      const Cluster cluster{hexagon(size, rings, true), hexagon(size, rings, false)};
      const double pairs = in_a_step(cluster.with, contacts);
      measurements.push_back({.x = pairs, .error = quantity(cluster)});
    }
    return measurements;
  };
}

double solves_for_a_pair(const Cluster& cluster) {
  const auto solves = [](const RunTotals& totals) {
    return static_cast<double>(totals.contact_solves);
  };
  return in_a_step(cluster.with, solves) / in_a_step(cluster.with, contacts);
}

// Returns the solves for each pair in the first step, which has no columns of an earlier step: a
// planted defect.
double solves_without_columns(const Cluster& cluster) {
  return static_cast<double>(cluster.with.one.contact_solves) /
         static_cast<double>(cluster.with.steps.front().contacts);
}

double with_contact(const Cluster& cluster) {
  return in_a_step(cluster.with, gmres_iterations);
}
double without_contact(const Cluster& cluster) {
  return in_a_step(cluster.without, gmres_iterations);
}

double contact_iterations(const Cluster& cluster) {
  return in_a_step(cluster.with, iterations);
}

double seconds_with(const Cluster& cluster) {
  return in_a_step(cluster.with, seconds);
}
double seconds_without(const Cluster& cluster) {
  return in_a_step(cluster.without, seconds);
}

double first_seconds(const Cluster& cluster) {
  return cluster.with.steps.front().seconds;
}

double share_of_time(const Cluster& cluster) {
  return in_a_step(cluster.with, [](const RunTotals& totals) { return totals.contact_seconds; }) /
         seconds_with(cluster);
}

Line shown(const std::string& key, const std::string& label,
           double (*quantity)(const Cluster& cluster)) {
  return {.key = key, .label = label, .measure = over_rings(quantity)};
}

}  // namespace

Experiment cost_of_contact() {
  return left_to_full(
      {.key = "cost_of_contact",
       .title = "A step of a hexagon of disks in shear, with and without contact",
       .x = "pairs in contact, p",
       .error = "number",
       .axes = Axes::no_law,
       .lines = {
           {.key = "solves",
            .label = "solves for contact, for each pair in contact",
            .measure = over_rings(solves_for_a_pair),
            .claim =
                Claim{.id = "12_17",
                      .statement =
                          "Contacts that last need a few solves a step, not one for each pair.",
                      .law = AtMost{0.2},
                      .reason = "the responses of the step before are used again, and their "
                                "sum is corrected; only new pairs need solves of their own",
                      .api = {"stokesbook::ContactMobility"}},
            .control = Control{"without the columns of the step before",
                               over_rings(solves_without_columns)}},
           shown("with", "GMRES iterations with contact", with_contact),
           shown("without", "GMRES iterations without", without_contact),
           shown("iterations", "contact iterations", contact_iterations),
           shown("seconds_with", "seconds with contact", seconds_with),
           shown("seconds_without", "seconds without contact", seconds_without),
           shown("first_seconds", "seconds of the first step, with contact", first_seconds),
           shown("share_of_time", "part of the time that contact takes", share_of_time)}});
}

}  // namespace stokesbook::verification::suspension
