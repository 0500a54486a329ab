// Runs the published Couette cells for two revolutions of the outer wall from the published starts,
// and compares the mean viscosity and order parameter with the printed values.
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
};

const Cell dilute{"couette", {1100.0, 520.0}}, dense{"couette_dense", {1180.0, 890.0}};

enum class CellBodies {
  all,
  every_other  ///< a planted defect
};

const CouetteSeries& run_of(const Cell& cell, Size size, CellBodies bodies = CellBodies::all) {
  static test::Once<std::tuple<std::string, Size, CellBodies>, CouetteSeries> runs;
  return runs({cell.scene, size, bodies}, [&] {
    Scene scene = shipped_scene(cell.scene);
    if (bodies == CellBodies::every_other) scene.bodies = every_other(scene.bodies);
    if (size == Size::quick) {
      scene.solver.tolerance = 1e-2;
      scene.time->dt = 0.15;
      scene.output.dt_write = 0.15;
    }
    return couette_series(scene, scene.contact->minimum_separation);
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

/// @param  from  start of the mean, in revolutions; a value other than 1 is a planted defect
Measure differences(const Cell& cell, const CouetteProperty& property, double from = 1.0) {
  return at(cell, late, [=](const CouetteSeries& series, double end) {
    return std::abs(mean(series, property, from, end) - printed_of(cell.printed, property));
  });
}

/// Measures the differences if every other body is left out. The steps and the tolerance of the
/// quick size suffice.
Measure differences_with_half_of_the_bodies(const Cell& cell, const CouetteProperty& property) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    const CouetteSeries& series = run_of(cell, Size::quick, CellBodies::every_other);
    for (const double end : late) {
      const double found = mean(series, property, 1.0, end);
      measurements.push_back(
          {.x = end, .error = std::abs(found - printed_of(cell.printed, property))});
    }
    return measurements;
  };
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
          .axes = Axes::no_law,
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
  return {.key = "couette_second_turn",
          .title = "Means over the second revolution of published Couette cells",
          .x = "revolutions r, the last of the mean",
          .error = "mean since the first revolution, in thousandths",
          .axes = Axes::no_law,
          .lines = {
              {.key = "dilute_viscosity",
               .label = "80 ellipses 3:1: added viscosity, printed 100",
               .measure = means(dilute, viscosity)},
              {.key = "dilute_viscosity_off",
               .label = "difference from print",
               .measure = differences(dilute, viscosity),
               .claim = as_printed("12_36", "viscosity"),
               .control = Control{"every other body left out",
                                  differences_with_half_of_the_bodies(dilute, viscosity)}},
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
               .control = Control{"a mean over both revolutions", differences(dilute, order, 0.0)}},
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
