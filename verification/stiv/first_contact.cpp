// Compares first contact times with closed forms for circles, tests the tolerance of the search,
// and counts the vertices that a separation requires.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::stiv {

using namespace study;
using Eigen::Index;

namespace {

constexpr double approach_separation = 0.1;

// Describes a step of two components, and the distance that they have travelled when the circles
// are at the separation.
struct Approach {
  double exact;
  double travel;
  Step (*step)(double phase_a, double phase_b, Index m);
};

constexpr double aside = 1.0, approach_travel = 8.0;

Step oblique_step(double phase_a, double phase_b, Index m) {
  return {{body(Circle{1.0}, m), body(Circle{1.0}, m)},
          {{{{-3.0, 0.0}, phase_a}, {0.5 * approach_travel, 0.0}, 0.0},
           {{{3.0, aside}, phase_b}, {-0.5 * approach_travel, 0.0}, 0.0}}};
}

Approach oblique() {
  const double touching = 2.0 + approach_separation;
  return {6.0 - std::sqrt(touching * touching - aside * aside), approach_travel, oblique_step};
}

Step enclosed_step(double phase_a, double phase_b, Index m) {
  return {{body(Circle{1.0}, m), container(Circle{3.0}, m)},
          {{{{0.2, 0.3}, phase_a}, {approach_travel, 0.0}, 0.0}, {{{0.0, 0.0}, phase_b}, {}, 0.0}}};
}

Approach enclosed() {
  const double touching = 3.0 - 1.0 - approach_separation;
  return {std::sqrt(touching * touching - 0.3 * 0.3) - 0.2, approach_travel, enclosed_step};
}

// Measures the largest error of a method over many orientations of the polygons.
Measure errors(const Approach& approach,
               double (*time)(const Approach& approach, double phase_a, double phase_b, Index m)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index m = 16; m <= (size == Size::full ? 1024 : 256); m *= 2) {
      constexpr int phases = 6;
      double worst = 0.0;
      for (int i = 0; i < phases; ++i) {
        for (int k = 0; k < phases; ++k) {
          const double edge = 2.0 * std::numbers::pi / static_cast<double>(m) / phases;
          const double found = time(approach, (i + 0.3) * edge, (k + 0.1) * edge, m);
          worst = std::max(worst, std::abs(found * approach.travel - approach.exact));
        }
      }
      measurements.push_back({.x = static_cast<double>(m), .error = worst});
    }
    return measurements;
  };
}

double by_advancement(const Approach& approach, double phase_a, double phase_b, Index m) {
  const ContactRules rules{{approach_separation}, 1e-9, RowChoice::every, 0.0};
  return first_time(violations(approach.step(phase_a, phase_b, m), rules));
}

// Returns the first of M instants at which fine polygons are closer than the separation. The phases
// shift the instants.
double by_instants(const Approach& approach, double phase_a, double phase_b, Index m) {
  const Step step = approach.step(0.0, 0.0, 256);
  const double spacing = 1.0 / static_cast<double>(m);
  double tau = spacing * std::fmod(static_cast<double>(m) * (phase_a + phase_b), 1.0);
  while (distance_at(step, tau, 2.0 * approach_separation) > approach_separation) tau += spacing;
  return tau;
}

Line line(const std::string& key, const std::string& label, const Approach& approach,
          const std::string& id) {
  return {.key = key,
          .label = label,
          .measure = errors(approach, by_advancement),
          .claim = Claim{.id = id,
                         .statement = label + ": first contact is of order 2 in the vertices.",
                         .law = Algebraic{2.0},
                         .reason = "polygons lie within their sags, h^2/(8 a), of the circles; the "
                                   "largest error over many orientations is their sum",
                         .api = {"stokesbook::interferences()", "stokesbook::sag()"}},
          .control = Control{"distances at M instants instead, the first that is too small",
                             errors(approach, by_instants)}};
}

// Returns the step of an ellipse and a star that turn and meet, at one of many orientations.
Step turning_step(int scene) {
  Step step = slanting_impact(2.0, 200);
  step.paths[0].start.orientation = 0.4 + 0.02 * scene;
  return step;
}

constexpr int scenes = 12;

// Holds the first contact of a vertex of the ellipse by some method, and the difference of its
// distance from the separation.
struct Found {
  double time = 1.0, error = 0.0, queries = 0.0;
};

Measurement over_scenes(double x, const std::function<Found(const Step& step)>& search) {
  Measurement measurement{.x = x, .operations = 0.0};
  for (int scene = 0; scene < scenes; ++scene) {
    const Found found = search(turning_step(scene));
    measurement.error = std::max(measurement.error, found.error);
    measurement.operations += found.queries / scenes;
  }
  return measurement;
}

// Returns the distance minus the separation; the distance is negative if the polygons overlap.
double excess(const Step& step, Index vertex, double tau) {
  const Complex z =
      RelativePath(step.paths[0], step.paths[1]).at(tau)(step.shapes[0]->polygon.vertex(vertex));
  return step.shapes[1]->polygon.closest(z, 100.0).distance - approach_separation;
}

Found by_events(const Step& step, double tolerance) {
  const VertexEvents found =
      vertex_events(*step.shapes[0], *step.shapes[1], RelativePath(step.paths[0], step.paths[1]),
                    {approach_separation, tolerance, 4.0 * approach_separation, 0.0});
  const VertexEvent& first = *std::ranges::min_element(found.events, {}, &VertexEvent::time);
  return {first.time, std::abs(excess(step, first.vertex, first.time)),
          static_cast<double>(found.cost.queries) / static_cast<double>(found.cost.vertices)};
}

// Marches along the path of each vertex, without the library's search:
// tau += next_step(excess, bound of the speed).
template <class NextStep>
Found by_march(const Step& step, double tolerance, const NextStep& next_step) {
  const Polygon& a = step.shapes[0]->polygon;
  const RelativePath path(step.paths[0], step.paths[1]);
  Found found;
  for (Index i = 0; i < a.size(); ++i) {
    const double bound = path.speed_bound(std::abs(a.vertex(i)));
    for (double tau = 0.0; tau < 1.0;) {
      const double above = excess(step, i, tau);
      found.queries += 1.0 / static_cast<double>(a.size());
      if (above <= tolerance) {
        if (tau < found.time) found = {tau, std::abs(above), found.queries};
        break;
      }
      tau += next_step(above, bound);
    }
  }
  return found;
}

std::vector<Measurement> by_advancement_to(Size size) {
  std::vector<Measurement> measurements;
  const double factor = size == Size::full ? std::sqrt(10.0) : 10.0;
  for (double tolerance = 1e-9; tolerance < 2e-2; tolerance *= factor) {
    measurements.push_back(
        over_scenes(tolerance, [=](const Step& step) { return by_events(step, tolerance); }));
  }
  return measurements;
}

std::vector<Measurement> by_half_the_bound(Size) {
  std::vector<Measurement> measurements;
  for (double tolerance = 1e-9; tolerance < 2e-2; tolerance *= 10.0) {
    measurements.push_back(over_scenes(tolerance, [=](const Step& step) {
      return by_march(step, tolerance,
                      [](double above, double bound) { return 2.0 * above / bound; });
    }));
  }
  return measurements;
}

std::vector<Measurement> by_equal_steps(Size size) {
  std::vector<Measurement> measurements;
  for (double spacing = size == Size::full ? 1e-4 : 1e-3; spacing < 0.2;
       spacing *= std::sqrt(10.0)) {
    measurements.push_back(over_scenes(spacing, [=](const Step& step) {
      return by_march(step, 0.0, [=](double, double) { return spacing; });
    }));
  }
  return measurements;
}

Measure vertex_counts(Index (*count)(double separation)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double delta = size == Size::full ? 1e-6 : 1e-5; delta < 0.2; delta *= 10.0) {
      measurements.push_back({.x = delta, .error = static_cast<double>(count(delta))});
    }
    return measurements;
  };
}

const Star lobes{1.0, 0.3, 5};

Index by_sag(double delta) {
  return contact_shape(lobes, Side::fluid_outside, 0.05 * delta).polygon.size();
}

Index by_spacing(double delta) {
  const ContactShape shape = contact_shape(sample(lobes, 512, Side::fluid_outside));
  return static_cast<Index>(std::ceil(shape.weights.sum() / delta));
}

}  // namespace

Experiment first_contact() {
  return {
      .key = "first_contact",
      .title = "First contact of circles",
      .x = "vertices M",
      .error = "largest error of the travel before contact, in radii",
      .lines = {line("oblique", "two circles that meet obliquely", oblique(), "10_2"),
                line("enclosed", "a circle that meets the wall around it", enclosed(), "10_3")}};
}

Experiment advancement() {
  return {
      .key = "advancement",
      .title = "Accuracy with which contact is found, and its cost",
      .x = "part of the step, or tolerance T",
      .error = "distance from the separation where contact is found",
      .lines = {{.key = "conservative",
                 .label = "conservative advancement",
                 .measure = by_advancement_to,
                 .claim = Claim{.id = "10_4",
                                .statement = "Contact is found above the separation, within the "
                                             "tolerance.",
                                .law = ErrorBelowTolerance{1.001, 0.05},
                                .reason = "steps of (d - delta)/L cannot pass it and end at the "
                                          "first distance below delta + tolerance; of a dozen "
                                          "impacts one ends in the upper part of that",
                                .api = {"stokesbook::vertex_events()"}},
                 .control = Control{"the bound of the speed is half of what it should be",
                                    by_half_the_bound}},
                {.key = "equal", .label = "equal steps in time", .measure = by_equal_steps}},
      .work_precision = true,
      .operation = "queries a vertex"};
}

Experiment vertices_for_a_separation() {
  return {
      .key = "vertices",
      .title = "Vertices for a separation: a star with five arms",
      .x = "separation δ",
      .error = "vertices",
      .lines = {{.key = "by_sag",
                 .label = "sag of a twentieth of the separation",
                 .measure = vertex_counts(by_sag),
                 .claim = Claim{.id = "10_5",
                                .statement = "The vertices grow as the root of 1/separation.",
                                .law = Algebraic{0.5, 0.02},
                                .reason = "the sag is max |x'' across| (2 pi/M)^2/8",
                                .api = {"stokesbook::ContactShape"}},
                 .control = Control{"edges as long as the separation", vertex_counts(by_spacing)}},
                {.key = "by_spacing",
                 .label = "edges as long as the separation",
                 .measure = vertex_counts(by_spacing)}}};
}

}  // namespace stokesbook::verification::stiv
