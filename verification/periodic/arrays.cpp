// Measures the drag of arrays of held disks, beside the values that Sangani and Acrivos printed,
// and the flow through an array of worms.
#include <cmath>
#include <numbers>

#include "defects.hpp"
#include "experiments.hpp"
#include "support/cells.hpp"
#include "support/once.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook::verification::periodic {

using namespace study;
using std::numbers::pi;
using test::Cell;

namespace {

// The drag over viscosity and mean velocity in square arrays, as Sangani and Acrivos printed it.
struct Printed {
  double area_fraction, drag;
};
constexpr Printed printed[] = {{0.05, 15.56}, {0.1, 24.83},   {0.2, 51.53},
                               {0.3, 102.90}, {0.4, 217.89},  {0.5, 532.55},
                               {0.6, 1763.0}, {0.7, 13520.0}, {0.75, 126300.0}};

// Computes the drag with automatic nodes and near corrections.
double drag_of(double area_fraction) {
  static test::Once<double, double> drags;
  return drags(area_fraction, [&] {
    Scene scene;
    scene.bodies = {Body{.shape = Circle{std::sqrt(area_fraction / pi)}, .held = true}};
    scene.cell = CellSettings{.mean_velocity = 1.0};
    scene.solver.tolerance = 1e-8;
    const SuspensionSolver solver(scene);
    return -solver.solve(solver.start()).loads[0].force.real();
  });
}

// A planted defect: 32 nodes for every gap, and no near corrections.
double drag_by_the_plain_rule(double area_fraction) {
  Cell cell = test::disk_in_a_cell(1.0, imaginary, area_fraction, 32);
  cell.bodies[0].held = RigidMotion{};
  cell.mean_velocity = 1.0;
  return -solve(cell, {44, 100000}).bodies[0].force.real();
}

std::vector<Measurement> computed_drags(Size) {
  std::vector<Measurement> measurements;
  for (const Printed& row : printed) {
    measurements.push_back({.x = row.area_fraction, .error = drag_of(row.area_fraction)});
  }
  return measurements;
}

std::vector<Measurement> printed_drags(Size) {
  std::vector<Measurement> measurements;
  for (const Printed& row : printed) {
    measurements.push_back({.x = row.area_fraction, .error = row.drag});
  }
  return measurements;
}

// The plain rule has no solution for the narrowest gaps.
Measure differences(double (*drag)(double area_fraction), double most) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const auto& [area_fraction, value] : printed) {
      if (area_fraction > most) continue;
      measurements.push_back(
          {.x = area_fraction, .error = std::abs(value / drag(area_fraction) - 1.0)});
    }
    return measurements;
  };
}

// The mean velocity along x past the worms at the gradient (-1, 0).
Measure worms(Defect defect) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int n = 40; n <= 160; n += size == Size::full ? 10 : 20) {
      Cell cell = test::worm_in_a_cell(n);
      cell.pressure_gradient = -1.0;
      const double found =
          solve(cell, {44, 100000}, {}, images_with(cell.lattice, defect)).mean_velocity.real();
      constexpr double published = 0.008234042360;
      measurements.push_back(
          {.x = static_cast<double>(n), .error = std::abs(found / published - 1.0)});
    }
    return measurements;
  };
}

// The mean velocity at the pressure gradient that belongs to the mean velocity 1.
Measure there_and_back(bool is_planted) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double area_fraction : {0.05, 0.1, 0.2, 0.3, 0.4}) {
      Cell cell = test::disk_in_a_cell(2.0, {0.3, 1.5}, area_fraction, 64);
      cell.bodies[0].held = RigidMotion{};
      cell.mean_velocity = 1.0;
      const Complex force = solve(cell, {44, 100000}).bodies[0].force;
      cell.pressure_gradient = is_planted ? force : force / cell.lattice.area();
      const Complex back = solve(cell, {44, 100000}).mean_velocity;
      measurements.push_back({.x = area_fraction, .error = std::abs(back - 1.0)});
    }
    return measurements;
  };
}

}  // namespace

Experiment drag() {
  return {
      .key = "drag",
      .title = "Drag of held disks in a square array",
      .x = "area fraction c",
      .error = "force over viscosity and mean velocity",
      .lines = {{.key = "computed", .label = "computed to eight digits", .measure = computed_drags},
                {.key = "printed", .label = "printed in 1982", .measure = printed_drags}}};
}

Experiment printed_drag() {
  return {
      .key = "printed_drag",
      .title = "Printed values of the drag beside computed ones",
      .x = "area fraction c",
      .error = "difference, relative to the computed drag",
      .axes = Axes::no_law,
      .lines = {{.key = "difference",
                 .label = "printed value",
                 .measure = differences(drag_of, 0.8),
                 .claim = Claim{.id = "14_16",
                                .statement = "The drag of disks in a square array agrees with "
                                             "the printed values up to the area fraction 0.7.",
                                .law = Identity{4e-4},
                                .window = {.to = 0.72},
                                .reason = "the values have four or five digits, the last of "
                                          "which is off by up to three units",
                                .api = {"stokesbook::SuspensionSolver", "stokesbook::FarOperator"}},
                 .control = Control{"32 nodes and no near corrections",
                                    differences(drag_by_the_plain_rule, 0.6)}}}};
}

Experiment worm() {
  return {
      .key = "worm",
      .title = "Mean velocity through an array of worms that cross the edges of their cells",
      .x = "nodes N",
      .error = "error of the mean velocity, relative",
      .axes = Axes::semi_log,
      .lines = {{.key = "worm",
                 .label = "pressure gradient given",
                 .measure = worms(nullptr),
                 .claim = Claim{.id = "14_17",
                                .statement =
                                    "With 120 nodes or more, the mean velocity past a body "
                                    "that crosses the edges of its cell has eight correct digits.",
                                .law = Identity{1e-8},
                                .window = {.from = 119.0},
                                .reason = "periodic kernels are analytic on the curve, wherever "
                                          "an edge is drawn; the value was published with "
                                          "ten digits",
                                .api = {"stokesbook::FarOperator"}},
                 .control = Control{"no term with conj(A_0)", worms(without_the_forces)}}}};
}

Experiment closures() {
  return {
      .key = "closures",
      .title = "Mean velocity at the pressure gradient that belongs to the mean velocity 1",
      .x = "area fraction c",
      .error = "error of the mean velocity",
      .axes = Axes::no_law,
      .lines = {{.key = "back",
                 .label = "gradient F/V",
                 .measure = there_and_back(false),
                 .claim = Claim{.id = "14_18",
                                .statement = "The two closures are the inverse of each other.",
                                .law = Identity{1e-11},
                                .reason = "the total force on the fluid is the mean gradient of "
                                          "the pressure times the area",
                                .api = {"stokesbook::Closure"}},
                 .control = Control{"the gradient is the force", there_and_back(true)}}}};
}

}  // namespace stokesbook::verification::periodic
