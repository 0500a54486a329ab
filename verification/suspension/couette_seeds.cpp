// Runs Couette cells from random starts: means over the second revolution with confidence
// intervals, for a small cell and the published cells, and the cost of the runs.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "couette_series.hpp"
#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "suspension/nodes/random_fill.hpp"
#include "sweep/results.hpp"
#include "sweep/sweep.hpp"
#include "sweep/task.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

using Runs = std::vector<CouetteSeries>;

/// A kind of run of the small cell.
enum class SmallRun {
  usual,
  careful,             ///< half the tolerance, half the step
  every_other,         ///< a planted defect: every other body is left out
  narrower_separation  ///< a planted defect: contact keeps 0.99 of the separation
};

constexpr double small_separation = 0.01;

/// Returns the run of the small cell (a scene of chapter 12) over two revolutions, from one random
/// start.
const CouetteSeries& small_run(unsigned seed, SmallRun kind) {
  static test::Once<std::pair<unsigned, SmallRun>, CouetteSeries> runs;
  return runs({seed, kind}, [&] {
    SceneFile file = shipped_file("couette_small");
    Scene& scene = file.scene;
    scene.seed = seed;
    scene.time->t_final = 4.0 * std::numbers::pi;
    scene.contact->minimum_separation =
        kind == SmallRun::narrower_separation ? 0.99 * small_separation : small_separation;
    scene.output.dt_write = 0.2;
    if (kind == SmallRun::careful) {
      scene.solver.tolerance *= 0.5;
      *scene.time->dt *= 0.5;
    }
    Scene placed = place_fills(file);
    if (kind == SmallRun::every_other) placed.bodies = every_other(placed.bodies);
    return couette_series(placed, small_separation);
  });
}

/// Consecutive seeds of random starts.
struct Starts {
  unsigned first, count;
};

Runs small_runs(const Starts& starts, SmallRun kind = SmallRun::usual) {
  Runs runs;
  for (unsigned k = 0; k < starts.count; ++k) runs.push_back(small_run(starts.first + k, kind));
  return runs;
}

MeanEstimate estimate(const Runs& runs, const CouetteProperty& property) {
  std::vector<double> values;
  for (const CouetteSeries& run : runs) values.push_back(mean(run, property, 1.0, 2.0));
  return estimate_mean(values);
}

/// Returns the difference of two estimates, relative to the bound that this difference satisfies 19
/// times in 20.
double apart(const MeanEstimate& a, const MeanEstimate& b) {
  return std::abs(a.mean - b.mean) / std::hypot(a.interval, b.interval);
}

/// Measures a function of the number of starts.
template <class Quantity>
Measure over_counts(const Quantity& quantity, unsigned most = 32) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const unsigned n : {4U, 6U, 8U, 16U, 32U}) {
      if (n > most) break;
      measurements.push_back({.x = static_cast<double>(n), .error = quantity(n)});
    }
    return measurements;
  };
}

Measure small_means(const CouetteProperty& property) {
  return over_counts([=](unsigned n) {
    return estimate(small_runs({1, n}), property).mean - property.without;
  });
}

Measure small_intervals(const CouetteProperty& property) {
  return over_counts([=](unsigned n) { return estimate(small_runs({1, n}), property).interval; });
}

/// Measures the difference between the viscosities of the two halves of the starts.
Measure halves(SmallRun kind_of_second, unsigned most = 32) {
  return over_counts(
      [=](unsigned n) {
        const Runs first = small_runs({1, n / 2}),
                   second = small_runs({1 + n / 2, n / 2}, kind_of_second);
        return apart(estimate(first, viscosity), estimate(second, viscosity));
      },
      most);
}

/// Measures a function of the seed of a start.
template <class Quantity>
Measure of_starts(unsigned first, unsigned last, const Quantity& quantity) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (unsigned seed = first; seed <= last; ++seed) {
      measurements.push_back({.x = static_cast<double>(seed), .error = quantity(seed)});
    }
    return measurements;
  };
}

Measure second_revolutions(const CouetteProperty& property) {
  return of_starts(1, 8, [=](unsigned seed) {
    return mean(small_run(seed, SmallRun::usual), property, 1.0, 2.0) - property.without;
  });
}

/// Measures the change of a start's mean viscosity by another kind of run, relative to the 95 %
/// interval of eight starts.
Measure changes(SmallRun kind) {
  return of_starts(2, 4, [=](unsigned seed) {
    const double usual = mean(small_run(seed, SmallRun::usual), viscosity, 1.0, 2.0),
                 other = mean(small_run(seed, kind), viscosity, 1.0, 2.0);
    return std::abs(other - usual) / estimate(small_runs({1, 8}), viscosity).interval;
  });
}

Measure lost_from_starts(SmallRun kind, unsigned last) {
  return of_starts(
      1, last, [=](unsigned seed) { return std::max(0.0, 1.0 - small_run(seed, kind).least_gap); });
}

/// Lists the printed means of the published cells, in the order of the sweep. Disks have no order
/// parameter.
constexpr double unprinted = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<PrintedMeans, 9> printed_of_cells{{{1120.0, unprinted},
                                                        {1220.0, unprinted},
                                                        {1420.0, unprinted},
                                                        {1100.0, 520.0},
                                                        {1230.0, 600.0},
                                                        {1360.0, 650.0},
                                                        {1080.0, 910.0},
                                                        {1180.0, 890.0},
                                                        {unprinted, unprinted}}};

/// Returns the runs from random starts. Cell 0 is the small cell, and the other cells are the
/// published cells in the order of the sweep.
const std::vector<Runs>& cells() {
  static test::Once<int, std::vector<Runs>> all;
  return all(0, [] {
    std::vector<Runs> cells{small_runs({1, 8})};
    const Sweep sweep = read_sweep(STOKESBOOK_SWEEPS "/couette_published.toml");
    cells.resize(1 + printed_of_cells.size());
    for (std::size_t k = 0; k < task_count(sweep); ++k) {
      const Scene scene = place_fills(scene_of(sweep, task_of(sweep, k)));
      cells.at(1 + k / runs_per_combination(sweep))
          .push_back(couette_series(scene, scene.contact->minimum_separation));
    }
    return cells;
  });
}

/// Measures a function of a cell's number and runs; skips cells for which the function returns NaN.
template <class Quantity>
Measure of_cells(const Quantity& quantity) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (std::size_t k = 0; k < cells().size(); ++k) {
      const double value = quantity(k, cells()[k]);
      if (!std::isnan(value)) measurements.push_back({.x = static_cast<double>(k), .error = value});
    }
    return measurements;
  };
}

Line of_random_runs(const std::string& key, const std::string& label,
                    const CouetteProperty& property) {
  return {.key = key, .label = label, .measure = of_cells([=](std::size_t, const Runs& runs) {
                                        return estimate(runs, property).mean - property.without;
                                      })};
}

Line interval(const std::string& key, const CouetteProperty& property) {
  return {.key = key + "_interval",
          .label = "half of its 95 % interval",
          .measure = of_cells(
              [=](std::size_t, const Runs& runs) { return estimate(runs, property).interval; })};
}

/// Returns the bound that the difference of a further run from the mean of the others satisfies 19
/// times in 20, plus a unit of the last printed digit.
double range_of_a_run(const MeanEstimate& estimate, std::size_t runs) {
  return estimate.interval * std::sqrt(static_cast<double>(runs) + 1.0) + printed_unit;
}

Line off(const std::string& key, const CouetteProperty& property) {
  return {.key = key + "_off",
          .label = "difference from print, over the bound for a further run",
          .measure = of_cells([=](std::size_t cell, const Runs& runs) {
            if (cell == 0) return unprinted;
            const MeanEstimate found = estimate(runs, property);
            return std::abs(found.mean - printed_of(printed_of_cells[cell - 1], property)) /
                   range_of_a_run(found, runs.size());
          })};
}

/// Averages a value over the runs of each cell.
template <class Value>
Line taken(const std::string& key, const std::string& label, Value CouetteSeries::*value) {
  return {.key = key, .label = label, .measure = of_cells([=](std::size_t, const Runs& runs) {
                                        double sum = 0.0;
                                        for (const CouetteSeries& run : runs)
                                          sum += static_cast<double>(run.*value);
                                        return sum / static_cast<double>(runs.size());
                                      })};
}

}  // namespace

Experiment couette_interval() {
  return left_to_full(
      {.key = "couette_interval",
       .title = "A small Couette cell, 13 ellipses 2:1 at 5 %: means over the second revolution",
       .x = "random starts n",
       .error = "in thousandths, or as labelled",
       .axes = Axes::no_law,
       .lines = {
           {.key = "viscosity", .label = "added viscosity", .measure = small_means(viscosity)},
           {.key = "viscosity_interval",
            .label = "half of its 95 % interval",
            .measure = small_intervals(viscosity)},
           {.key = "viscosity_halves",
            .label = "difference of the viscosities of both halves, over its 95 % bound",
            .measure = halves(SmallRun::usual),
            .claim = Claim{.id = "12_49",
                           .statement = "Two halves of random starts of a Couette cell have the "
                                        "same mean viscosity within their 95 % intervals.",
                           .law = AtMost{1.0},
                           .reason = "independent starts, and Student's intervals of both, "
                                     "added as independent errors are",
                           .api = {"stokesbook::estimate_mean"}},
            .control = Control{"every other body left out of the runs of one half",
                               halves(SmallRun::every_other, 8)}},
           {.key = "order", .label = "order parameter", .measure = small_means(order)},
           {.key = "order_interval",
            .label = "half of its 95 % interval",
            .measure = small_intervals(order)},
           {.key = "alone",
            .label = "order parameter of the same, each alone in the local shear",
            .measure = small_means(alone)}}});
}

Experiment couette_seeds() {
  return left_to_full(
      {.key = "couette_seeds",
       .title = "Means over the second revolution from random starts, four of each published "
                "cell and eight of the small one",
       .x = "cell k: 0 the small one, 1 to 3 of disks, 4 to 6 of 3:1, 7 to 9 of 6:1, at 5, 10 "
            "and 15 %",
       .error = "in thousandths, or as labelled",
       .axes = Axes::nominal,
       .lines = {of_random_runs("viscosity", "added viscosity", viscosity),
                 interval("viscosity", viscosity), off("viscosity", viscosity),
                 of_random_runs("order", "order parameter", order), interval("order", order),
                 off("order", order)}});
}

Experiment couette_unattended() {
  return left_to_full(
      {.key = "couette_unattended",
       .title = "Cost of the same runs, in the mean over each cell: two revolutions with contact, "
                "on one thread, unattended",
       .x = "cell k",
       .error = "number, or as labelled",
       .axes = Axes::nominal,
       .lines = {
           taken("seconds", "seconds", &CouetteSeries::seconds),
           taken("steps", "steps", &CouetteSeries::steps),
           taken("gmres", "iterations of GMRES", &CouetteSeries::gmres_iterations),
           taken("contact", "contact iterations", &CouetteSeries::contact_iterations),
           {.key = "gap",
            .label = "least gap of all, in separations (2 and more count as 2)",
            .measure = of_cells([](std::size_t, const Runs& runs) {
              return std::ranges::min(runs, {}, &CouetteSeries::least_gap).least_gap;
            })},
           {.key = "estimate",
            .label = "largest error estimate of all, in tolerances",
            .measure = of_cells([](std::size_t, const Runs& runs) {
              return std::ranges::max(runs, {}, &CouetteSeries::largest_estimate).largest_estimate;
            })}}});
}

Experiment couette_small() {
  return left_to_full(
      {.key = "couette_small",
       .title = "The same cell from each of its starts",
       .x = "random start k",
       .error = "mean over the second revolution in thousandths, or as labelled",
       .axes = Axes::nominal,
       .lines = {{.key = "viscosity",
                  .label = "added viscosity",
                  .measure = second_revolutions(viscosity)},
                 {.key = "order", .label = "order parameter", .measure = second_revolutions(order)},
                 {.key = "alone",
                  .label = "order parameter of the same, each alone in the local shear",
                  .measure = second_revolutions(alone)}}});
}

Experiment couette_care() {
  return left_to_full(
      {.key = "couette_care",
       .title = "Effect of numerical errors on these runs",
       .x = "random start k",
       .error = "as said",
       .axes = Axes::nominal,
       .lines = {
           {.key = "care",
            .label = "change of the viscosity by half the tolerance and half the step, over the "
                     "interval of the mean",
            .measure = changes(SmallRun::careful),
            .claim =
                Claim{.id = "12_50",
                      .statement = "Half the tolerance and half the step change a mean viscosity "
                                   "by less than the 95 % interval of the mean over random starts.",
                      .law = AtMost{1.0},
                      .reason = "tolerances are of the worst velocity, and means are over "
                                "many; starts differ by the distances of bodies",
                      .api = {"stokesbook::Rheometer"}},
            .control = Control{"every other body left out", changes(SmallRun::every_other)}},
           {.key = "lost",
            .label = "shortfall of the narrowest gap, relative to the separation",
            .measure = lost_from_starts(SmallRun::usual, 8),
            .claim = Claim{.id = "12_51",
                           .statement = "From any start, two revolutions of the small Couette cell "
                                        "keep the separation.",
                           .law = AtMost{1e-3},
                           .reason = "each step resolves contact with the mobility of all bodies "
                                     "together",
                           .api = {"stokesbook::SuspensionContact"}},
            .control = Control{"contact that keeps 0.99 of the separation",
                               lost_from_starts(SmallRun::narrower_separation, 3)}}}});
}

}  // namespace stokesbook::verification::suspension
