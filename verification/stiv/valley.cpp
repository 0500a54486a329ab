// Moves a disk into the valley of a star, and measures the mean normal of two flanks.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::stiv {

using namespace study;

namespace {

constexpr double disk_radius = 0.45, valley_separation = 0.09;

// Returns the distance from the star's centre at which the disk on the axis meets both flanks.
double meeting_place(const ContactShape& star, Complex axis) {
  double inside = 0.5, outside = 2.0;
  for (int bisection = 0; bisection < 50; ++bisection) {
    const double middle = 0.5 * (inside + outside);
    const double distance = star.polygon.closest(middle * axis, 10.0).distance;
    (distance > disk_radius + valley_separation ? outside : inside) = middle;
  }
  return outside;
}

// Measures the least length of a row's force on the disk while the disk moves down the axis of the
// valley.
Measure lengths(RowChoice rows) {
  return [=](Size size) {
    const Complex axis = std::polar(1.0, std::numbers::pi / 3.0);
    const auto star = body(Star{1.0, 0.45, 3}, 768), disk = body(Circle{disk_radius}, 256);
    const double place = meeting_place(*star, axis);
    std::vector<Measurement> measurements;
    for (double depth = 0.01; depth < 3.0; depth *= size == Size::full ? std::sqrt(2.0) : 2.0) {
      const Step step{{star, disk},
                      {{{{0.0, 0.0}, 0.0}, {0.0, 0.0}, 0.0},
                       {{2.0 * axis, 0.1}, -(2.0 - place + depth) * axis, 0.0}}};
      double least = 1.0;
      for (const Contact& contact : violations(step, {{valley_separation}, 1e-5, rows})) {
        for (const ContactRow& row : contact.rows) {
          least = std::min(least, std::abs(row.force.on_a.force));
        }
      }
      measurements.push_back({.x = depth, .error = least});
    }
    return measurements;
  };
}

}  // namespace

Experiment valley() {
  return {.key = "valley",
          .title = "A disk that is pressed into the valley of a star",
          .x = "depth p",
          .error = "least length of a row's force",
          .lines = {{.key = "deepest",
                     .label = "rows of deepest vertices",
                     .measure = lengths(RowChoice::deepest)},
                    {.key = "aggregate",
                     .label = "rows of volumes",
                     .measure = lengths(RowChoice::aggregate)}}};
}

}  // namespace stokesbook::verification::stiv
