// Exercise 14.3: the drag of small disks in a square lattice, and Darcy's law.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

using std::numbers::pi;
using stokesbook::exercise::not_done;

// Task 1: the drag of a small disk.
double small_disk_drag(double c_L, double radius, double area) {
  //@ starter
  not_done(c_L, radius, area);  // your code instead of this line
  //@ solution
  return 4.0 * pi / (c_L - std::log(radius) + pi * radius * radius / area);
  //@ wrong no_fraction: the area fraction is missing
  (void)area;
  return 4.0 * pi / (c_L - std::log(radius));
  //@ wrong half_logarithm: the logarithm is that of the radius
  return 4.0 * pi / (c_L - 0.5 * std::log(radius) + pi * radius * radius / area);
  //@ end
}

// Task 2: the drag from the mean velocity u at the pressure gradient P.
double drag_from_flow(double viscosity, double area, double P, double u) {
  //@ starter
  not_done(viscosity, area, P, u);  // your code instead of this line
  //@ solution
  return -area * P / (viscosity * u);
  //@ wrong force_of_the_disk: the force of the fluid on the disk
  return area * P / (viscosity * u);
  //@ wrong gradient_alone: the force is the gradient times the area
  (void)area;
  return -P / (viscosity * u);
  //@ end
}

// Task 3: the permeability.
double permeability(double drag, double area) {
  //@ starter
  not_done(drag, area);  // your code instead of this line
  //@ solution
  return area / drag;
  //@ wrong resistance: this is the inverse
  return drag / area;
  //@ wrong no_area: the area of the cell is missing
  (void)area;
  return 1.0 / drag;
  //@ end
}
