// The published Couette cells over two revolutions of the outer wall: viscosity and order, from the
// published starts and from random ones.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"
#include "suspension/fill.hpp"
#include "sweep/estimate.hpp"
#include "sweep/parse.hpp"
#include "sweep/table_column.hpp"
#include "sweep/task.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

/// What a run says at its written times, in thousandths.
struct Series {
  std::vector<double> revolutions, viscosity, order;
};

Series series_of(const Scene& scene) {
  Series series;
  for (const Frame& frame : recorded_run(scene).frames) {
    series.revolutions.push_back(frame.t / (2.0 * std::numbers::pi));
    series.viscosity.push_back(1e3 * frame.rheology.torque_ratio);
    series.order.push_back(1e3 * frame.rheology.order_parameter);
  }
  return series;
}

/// One of the two, and its value without bodies.
struct Property {
  std::vector<double> Series::*values;
  double without;
};

constexpr Property viscosity{&Series::viscosity, 1000.0}, order{&Series::order, 0.0};

double mean(const Series& series, const Property& property, double from, double to) {
  return time_average(series.revolutions, series.*property.values, from, to);
}

/// Printed means over the second revolution, in thousandths; NaN where there are none.
struct Printed {
  double viscosity, order;
  double operator()(const Property& property) const {
    return property.values == &Series::viscosity ? viscosity : order;
  }
};

constexpr double unit = 10.0;  // of the last digit that is printed

/// A cell whose start has been published.
struct Cell {
  std::string scene;
  Printed printed;
  double area_fraction;
  bool quick;  ///< enough for the quick size
};

const Cell dilute{"couette", {1100.0, 520.0}, 0.05, true},
    dense{"couette_dense", {1180.0, 890.0}, 0.1, false};

const Series& run_of(const Cell& cell, Size size) {
  static Once<std::pair<std::string, Size>, Series> runs;
  return runs({cell.scene, size}, [&] {
    Scene scene = shipped_scene(cell.scene);
    if (size == Size::quick) {
      scene.solver.tolerance = 1e-2;
      scene.time->dt = 0.1;
    }
    return series_of(scene);
  });
}

/// Measures a function of a run and of a time in revolutions, at several.
template <class Quantity>
Measure at(const Cell& cell, const std::vector<double>& times, const Quantity& quantity) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    if (size == Size::quick && !cell.quick) return measurements;
    const Series& series = run_of(cell, size);
    for (const double time : times) {
      measurements.push_back({.x = time, .error = quantity(series, time)});
    }
    return measurements;
  };
}

Measure over_eighths(const Cell& cell, const Property& property) {
  std::vector<double> ends;
  for (int k = 1; k <= 16; ++k) ends.push_back(0.125 * k);
  return at(cell, ends, [=](const Series& series, double end) {
    return mean(series, property, end - 0.125, end) - property.without;
  });
}

const std::vector<double> late{1.75, 1.875, 2.0};

Measure means(const Cell& cell, const Property& property) {
  return at(cell, late, [=](const Series& series, double end) {
    return mean(series, property, 1.0, end) - property.without;
  });
}

/// How a mean is taken; other values are planted defects.
struct Averaging {
  double from = 1.0;  ///< revolutions
  double area = 1.0;  ///< to which a property is referred, of that of the cell
};

Measure differences(const Cell& cell, const Property& property, const Averaging& averaging = {}) {
  return at(cell, late, [=](const Series& series, double end) {
    const double found = mean(series, property, averaging.from, end) / averaging.area;
    return std::abs(found - cell.printed(property));
  });
}

Claim as_printed(const std::string& id, const std::string& what) {
  return {.id = id,
          .statement = "From the published start, the mean " + what +
                       " over the second revolution of the dilute cell is the published one, to a "
                       "unit of its last digit.",
          .law = Identity{unit},
          .reason =
              "printed to two digits after the point, rounded or cut; the mean over many "
              "bodies depends on the tolerance less than that",
          .api = {"stokesbook::Rheometer"}};
}

/// Cells with random starts, as the sweep has them. Disks have no order.
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<Printed, 9> printed_of_cells{{{1120.0, none},
                                                   {1220.0, none},
                                                   {1420.0, none},
                                                   {1100.0, 520.0},
                                                   {1230.0, 600.0},
                                                   {1360.0, 650.0},
                                                   {1080.0, 910.0},
                                                   {1180.0, 890.0},
                                                   {none, none}}};

const std::vector<std::vector<Series>>& random_runs() {
  static Once<int, std::vector<std::vector<Series>>> runs;
  return runs(0, [] {
    const Sweep sweep = read_sweep(STOKESBOOK_SWEEPS "/couette_published.toml");
    std::vector<std::vector<Series>> cells(printed_of_cells.size());
    for (std::size_t k = 0; k < task_count(sweep); ++k) {
      const Scene scene = with_fills_placed(scene_of(sweep, task_of(sweep, k)));
      cells.at(k / runs_per_combination(sweep)).push_back(series_of(scene));
    }
    return cells;
  });
}

Estimate second_revolution(const std::vector<Series>& runs, const Property& property) {
  std::vector<double> values;
  for (const Series& run : runs) values.push_back(mean(run, property, 1.0, 2.0));
  return estimate_mean(values);
}

/// By how much a further run may differ from the mean of others, 19 times in 20, and its print.
double range_of_a_run(const Estimate& estimate, std::size_t runs) {
  return estimate.interval * std::sqrt(static_cast<double>(runs) + 1.0) + unit;
}

/// Measures a function of the estimate by a cell's runs, of their number and of what is printed,
/// where there is one.
template <class Quantity>
Measure of_cells(const Property& property, const Quantity& quantity) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    if (size == Size::quick) return measurements;
    for (std::size_t k = 0; k < random_runs().size(); ++k) {
      const std::vector<Series>& runs = random_runs()[k];
      const Estimate estimate = second_revolution(runs, property);
      const double value = quantity(estimate, runs.size(), printed_of_cells[k]);
      if (std::isnan(value)) continue;
      measurements.push_back({.x = static_cast<double>(k + 1), .error = value});
    }
    return measurements;
  };
}

Line of_random_runs(const std::string& key, const std::string& label, const Property& property) {
  return {.key = key,
          .label = label,
          .measure = of_cells(property, [=](const Estimate& estimate, std::size_t, const Printed&) {
            return estimate.mean - property.without;
          })};
}

Line interval(const std::string& key, const Property& property) {
  return {.key = key + "_interval",
          .label = "half of its 95 % interval",
          .measure = of_cells(property, [](const Estimate& estimate, std::size_t, const Printed&) {
            return estimate.interval;
          })};
}

Line off(const std::string& key, const Property& property) {
  return {.key = key + "_off",
          .label = "from print, over what a run may differ",
          .measure = of_cells(
              property, [=](const Estimate& estimate, std::size_t runs, const Printed& printed) {
                return std::abs(estimate.mean - printed(property)) / range_of_a_run(estimate, runs);
              })};
}

}  // namespace

Experiment couette_turns() {
  return {.key = "couette_turns",
          .title = "Published Couette cells over two revolutions, from their published starts",
          .x = "revolutions r",
          .error = "mean over the eighth of a revolution before, in thousandths",
          .axes = Axes::nominal,
          .lines = {{.key = "dilute_viscosity",
                     .label = "80 ellipses 3:1, added viscosity",
                     .measure = over_eighths(dilute, viscosity)},
                    {.key = "dilute_order",
                     .label = "the same, order parameter",
                     .measure = over_eighths(dilute, order)},
                    {.key = "dense_viscosity",
                     .label = "320 ellipses 6:1, added viscosity (full size)",
                     .measure = over_eighths(dense, viscosity)},
                    {.key = "dense_order",
                     .label = "the same, order parameter (full size)",
                     .measure = over_eighths(dense, order)}}};
}

Experiment couette_second_turn() {
  const Averaging of_fluid{.area = 1.0 - dilute.area_fraction}, of_both_turns{.from = 0.0};
  return {.key = "couette_second_turn",
          .title = "Means over the second revolution of published Couette cells",
          .x = "revolutions r, the last of the mean",
          .error = "mean since the first revolution, in thousandths",
          .axes = Axes::nominal,
          .lines = {{.key = "dilute_viscosity",
                     .label = "80 ellipses 3:1: added viscosity, printed 100",
                     .measure = means(dilute, viscosity)},
                    {.key = "dilute_viscosity_off",
                     .label = "difference from print",
                     .measure = differences(dilute, viscosity),
                     .claim = as_printed("12_36", "viscosity"),
                     .control = Control{"torque over the area of the fluid instead of the cell's",
                                        differences(dilute, viscosity, of_fluid)}},
                    {.key = "dilute_order",
                     .label = "80 ellipses 3:1: order parameter, printed 520",
                     .measure = means(dilute, order)},
                    {.key = "dilute_order_off",
                     .label = "difference from print",
                     .measure = differences(dilute, order),
                     .claim = as_printed("12_37", "order parameter"),
                     .control = Control{"a mean over both revolutions",
                                        differences(dilute, order, of_both_turns)}},
                    {.key = "dense_viscosity",
                     .label = "320 ellipses 6:1 (full size): added viscosity, printed 180",
                     .measure = means(dense, viscosity)},
                    {.key = "dense_order",
                     .label = "320 ellipses 6:1 (full size): order parameter, printed 890",
                     .measure = means(dense, order)}}};
}

Experiment couette_seeds() {
  return {.key = "couette_seeds",
          .title = "Means over the second revolution from random starts, full size only",
          .x = "cell k: 1 to 3 of disks, 4 to 6 of 3:1, 7 to 9 of 6:1, at 5, 10 and 15 %",
          .error = "mean over four starts, in thousandths",
          .axes = Axes::nominal,
          .lines = {of_random_runs("viscosity", "added viscosity", viscosity),
                    interval("viscosity", viscosity), off("viscosity", viscosity),
                    of_random_runs("order", "order parameter", order), interval("order", order),
                    off("order", order)}};
}

}  // namespace stokesbook::verification::suspension
