// Runs the published Couette cells for two revolutions of the outer wall from the published starts,
// and compares the mean viscosity and order parameter with print.
#include <cmath>

#include "couette_series.hpp"
#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

/// A cell whose start is published.
struct Cell {
  std::string scene;
  PrintedMeans printed;
  double area_fraction;
};

const Cell dilute{"couette", {1100.0, 520.0}, 0.05}, dense{"couette_dense", {1180.0, 890.0}, 0.1};

const CouetteSeries& run_of(const Cell& cell, Size size) {
  static test::Once<std::pair<std::string, Size>, CouetteSeries> runs;
  return runs({cell.scene, size}, [&] {
    Scene scene = shipped_scene(cell.scene);
    if (size == Size::quick) {
      scene.solver.tolerance = 1e-2;
      scene.time->dt = 0.15;
      scene.output.dt_write = 0.15;
    }
    return couette_series(scene);
  });
}

/// Measures a function of a run and a time (in revolutions) at several times.
template <class Quantity>
Measure at(const Cell& cell, const std::vector<double>& times, const Quantity& quantity) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const CouetteSeries& series = run_of(cell, size);
    for (const double time : times) {
      measurements.push_back({.x = time, .error = quantity(series, time)});
    }
    return measurements;
  };
}

Measure over_eighths(const Cell& cell, const CouetteProperty& property) {
  std::vector<double> ends;
  for (int k = 1; k <= 16; ++k) ends.push_back(0.125 * k);
  return at(cell, ends, [=](const CouetteSeries& series, double end) {
    return mean(series, property, end - 0.125, end) - property.without;
  });
}

const std::vector<double> late{1.75, 1.875, 2.0};

Measure means(const Cell& cell, const CouetteProperty& property) {
  return at(cell, late, [=](const CouetteSeries& series, double end) {
    return mean(series, property, 1.0, end) - property.without;
  });
}

/// The definition of a mean. Values other than the defaults are planted defects.
struct Averaging {
  double from = 1.0;  ///< start of the mean, in revolutions
  double area = 1.0;  ///< area to which a property refers, relative to the cell's area
};

Measure differences(const Cell& cell, const CouetteProperty& property,
                    const Averaging& averaging = {}) {
  return at(cell, late, [=](const CouetteSeries& series, double end) {
    const double found = mean(series, property, averaging.from, end) / averaging.area;
    return std::abs(found - printed_of(cell.printed, property));
  });
}

Claim as_printed(const std::string& id, const std::string& what) {
  return {.id = id,
          .statement = "From the published start, the mean " + what +
                       " over the second revolution of the dilute cell is the published one, to a "
                       "unit of its last digit.",
          .law = Identity{printed_unit},
          .reason =
              "the print has two digits after the point, rounded or truncated; the mean over many "
              "bodies depends less than that on the tolerance",
          .api = {"stokesbook::Rheometer"}};
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
                    {.key = "dilute_alone",
                     .label = "order parameter of the same, each alone in the local shear",
                     .measure = over_eighths(dilute, alone)},
                    {.key = "dense_viscosity",
                     .label = "320 ellipses 6:1, added viscosity",
                     .measure = over_eighths(dense, viscosity),
                     .least = Size::full},
                    {.key = "dense_order",
                     .label = "the same, order parameter",
                     .measure = over_eighths(dense, order),
                     .least = Size::full},
                    {.key = "dense_alone",
                     .label = "order parameter of the same, each alone",
                     .measure = over_eighths(dense, alone),
                     .least = Size::full}}};
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
                    {.key = "dilute_alone",
                     .label = "the same if each turned alone",
                     .measure = means(dilute, alone)},
                    {.key = "dilute_order_off",
                     .label = "difference from print",
                     .measure = differences(dilute, order),
                     .claim = as_printed("12_37", "order parameter"),
                     .control = Control{"a mean over both revolutions",
                                        differences(dilute, order, of_both_turns)}},
                    {.key = "dense_viscosity",
                     .label = "320 ellipses 6:1: added viscosity, printed 180",
                     .measure = means(dense, viscosity),
                     .least = Size::full},
                    {.key = "dense_order",
                     .label = "320 ellipses 6:1: order parameter, printed 890",
                     .measure = means(dense, order),
                     .least = Size::full}}};
}

}  // namespace stokesbook::verification::suspension
