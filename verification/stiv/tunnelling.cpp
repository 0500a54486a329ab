// Compares detection of two circles that approach at any speed: by the swept search, and by
// distances at the end of the step or at some instants.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::stiv {

using namespace study;

namespace {

constexpr double crossing_separation = 0.1, start_gap = 2.0, reach = 1e9;

// Returns the gap minus the separation that a method finds at the end of a step. Each circle
// travels half of the way.
using Gap = double (*)(const Step& step);

Measure errors(Gap gap) {
  return [=](Size size) {
    const auto circle = body(Circle{1.0}, 64);
    std::vector<double> travels{2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 20.0, 100.0, 1000.0};
    if (size == Size::full) travels.insert(travels.end(), {1e4, 1e5, 1e6});
    std::vector<Measurement> measurements;
    for (const double travel : travels) {
      const Step step{{circle, circle},
                      {{{{-2.0, 0.0}, 0.0}, {0.5 * travel, 0.0}, 0.0},
                       {{{2.0, 0.0}, 0.0}, {-0.5 * travel, 0.0}, 0.0}}};
      const double exact = start_gap - crossing_separation - travel;
      measurements.push_back({.x = travel, .error = std::abs(gap(step) - exact) / travel});
    }
    return measurements;
  };
}

double swept(const Step& step) {
  return least_gap(violations(step, {{crossing_separation}, 1e-4}));
}

// Returns the least gap at some instants, or 0 if the circles do not overlap at any of them.
double seen_at(const Step& step, int instants) {
  double least = 0.0;
  for (int k = 1; k <= instants; ++k) {
    least = std::min(
        least, distance_at(step, static_cast<double>(k) / instants, reach) - crossing_separation);
  }
  return least;
}

double at_end(const Step& step) {
  return seen_at(step, 1);
}

double at_instants(const Step& step) {
  return seen_at(step, 16);
}

}  // namespace

Experiment tunnelling() {
  return {
      .key = "tunnelling",
      .title = "Two unit circles that come together, from a gap of 2",
      .x = "travel |Δc|",
      .error = "error of the gap at the end of the step, over the travel",
      .lines = {
          {.key = "end", .label = "overlap at the end", .measure = errors(at_end)},
          {.key = "instants", .label = "overlap at 16 instants", .measure = errors(at_instants)},
          {.key = "swept",
           .label = "swept",
           .measure = errors(swept),
           .claim = Claim{.id = "10_1",
                          .statement = "However far two circles travel in a step, the gap found is "
                                       "their first gap less the travel.",
                          .law = Identity{1e-14},
                          .reason = "conservative steps cannot pass the first contact, "
                                    "and on the axis the gap falls by the travel; a few "
                                    "roundings",
                          .api = {"stokesbook::interferences()"}},
           .control =
               Control{"overlap is looked for at the end of the step only", errors(at_end)}}}};
}

}  // namespace stokesbook::verification::stiv
