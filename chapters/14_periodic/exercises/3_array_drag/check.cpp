// Check of exercise 14.3: drag and permeability against solutions of cells, by both closures.
#include "chapters/check.hpp"

#include <numbers>

#include "periodic/far_sums.hpp"
#include "support/cells.hpp"

using namespace stokesbook;
using exercise::expect;
using exercise::text;
using std::numbers::pi;

double small_disk_drag(double c_L, double radius, double area);
double drag_from_flow(double viscosity, double area, double P, double u);
double permeability(double drag, double area);

namespace {

test::Cell held_disk(double side, double area_fraction) {
  test::Cell cell = test::disk_in_a_cell(side, {0.0, side}, area_fraction, 48);
  cell.viscosity = 0.7;
  cell.bodies[0].held = RigidMotion{};
  return cell;
}

// The drag from the force at the mean velocity 1.
double drag_of(double side, double area_fraction) {
  test::Cell cell = held_disk(side, area_fraction);
  cell.mean_velocity = 1.0;
  return -test::solve(cell, {44, 100000}).bodies[0].force.real() / cell.viscosity;
}

// The mean velocity at a gradient of the pressure.
double velocity_at(double side, double area_fraction, double gradient) {
  test::Cell cell = held_disk(side, area_fraction);
  cell.pressure_gradient = gradient;
  return test::solve(cell, {44, 100000}).mean_velocity.real();
}

std::string name(double side, double area_fraction) {
  return "area fraction " + text(area_fraction) + ", side of the cell " + text(side);
}

void check_small(double side, double area_fraction) {
  const double area = side * side, radius = std::sqrt(area_fraction * area / pi),
               c_L = logarithm_constant(Lattice(side, {0.0, side}));
  const auto drag = [](double inverse) { return 4.0 * pi / inverse; };
  const double logarithm = std::log(radius);
  expect({.what = name(side, area_fraction),
          .got = small_disk_drag(c_L, radius, area),
          .expected = drag_of(side, area_fraction),
          .tolerance = 2.0 * area_fraction * area_fraction,  // the next order
          .mistakes = {{drag(c_L - logarithm),
                        "the area fraction is missing: the pressure gradient of the array acts on "
                        "the disk"},
                       {drag(c_L - 0.5 * logarithm + area_fraction),
                        "the logarithm is that of the radius; one half belongs to that of the area "
                        "fraction"},
                       {drag(-logarithm + area_fraction), "the constant of the lattice is missing"},
                       {0.5 * drag(c_L - logarithm + area_fraction),
                        "a Stokeslet has the factor 1/(4 pi)"}}});
}

void check_flow(double side, double area_fraction, double gradient) {
  const double drag = drag_of(side, area_fraction), area = side * side;
  expect({.what = name(side, area_fraction) + ", P = " + text(gradient),
          .got = drag_from_flow(0.7, area, gradient, velocity_at(side, area_fraction, gradient)),
          .expected = drag,
          .tolerance = 1e-9,
          .mistakes = {{-drag,
                        "the force of the fluid on the disk is -V P: P is negative if the "
                        "fluid flows along x"},
                       {drag / area, "the force is the gradient times the area of the cell"},
                       {0.7 * drag, "the viscosity is missing"}}});
}

void check_permeability(double side, double area_fraction) {
  const double drag = drag_of(side, area_fraction), area = side * side;
  const double exact = 0.7 * velocity_at(side, area_fraction, -1.0);
  expect({.what = name(side, area_fraction),
          .got = permeability(drag, area),
          .expected = exact,
          .tolerance = 1e-9,
          .mistakes = {{1.0 / exact, "this is the inverse, a resistance"},
                       {exact / area, "the area of the cell is missing"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the drag of a small disk",
                         .formula = "4 pi/(c_L - log(a) + pi a^2/V)",
                         .hint = "(14.13), with the radius in place of the area fraction",
                         .check =
                             [] {
                               check_small(1.0, 0.01);
                               check_small(3.0, 0.005);
                               check_small(3.0, 0.02);
                             }},
                        {.title = "the drag from the flow",
                         .formula = "-V P/(mu u)",
                         .hint = "the disk exerts the force V P on the fluid",
                         .check =
                             [] {
                               check_flow(1.5, 0.1, -1.0);
                               check_flow(2.0, 0.3, -0.5);
                             }},
                        {.title = "the permeability",
                         .formula = "V/D",
                         .hint = "u = -k P/mu, and D = -V P/(mu u)",
                         .check = [] {
                           check_permeability(1.5, 0.1);
                           check_permeability(2.0, 0.3);
                         }}});
}
