// Compares derivatives of the gap (10.9) with central differences of the whole search.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::stiv {

using namespace study;
using Eigen::Index;

namespace {

// Holds a change of one component's displacement or rotation.
struct Change {
  Complex shift;
  double turn;
};

constexpr std::array<Change, 3> changes{{{{1.0, 0.0}, 0.0}, {{0.0, 1.0}, 0.0}, {{0.0, 0.0}, 1.0}}};

std::map<Index, VertexEvent> events_after(const Step& step, const Change& change, double size) {
  PathPair paths{0, 1, step.paths[0], step.paths[1]};
  paths.path_a.displacement += size * change.shift;
  paths.path_a.rotation += size * change.turn;
  std::map<Index, VertexEvent> events;
  for (const VertexEvent& event : pair_events(step.shapes, paths, {0.1, 1e-6, 0.4}).events_a) {
    if (event.gap < 0.0 && event.time < 1.0) events.insert({event.vertex, event});
  }
  return events;
}

bool touches_a_corner(const Polygon& polygon, const VertexEvent& event) {
  return event.point == polygon.vertex(event.edge) ||
         event.point == polygon.vertex((event.edge + 1) % polygon.size());
}

// Returns the largest difference over all vertices that touch the same edge at all three states. If
// the edge changes, the gap has no derivative.
double worst_difference(const Step& step, double h, PairWrench ContactRow::*form) {
  const PathPair paths{0, 1, step.paths[0], step.paths[1]};
  const Polygon &a = step.shapes[0]->polygon, &b = step.shapes[1]->polygon;
  const auto here = events_after(step, changes[0], 0.0);
  double worst = 0.0;
  for (const Change& change : changes) {
    const auto before = events_after(step, change, -h), after = events_after(step, change, h);
    for (const auto& [vertex, event] : here) {
      const auto touches_it = [&b, vertex = vertex,
                               edge = event.edge](const std::map<Index, VertexEvent>& moved) {
        const auto found = moved.find(vertex);
        return found != moved.end() && found->second.edge == edge &&
               !touches_a_corner(b, found->second);
      };
      if (touches_a_corner(b, event) || !touches_it(before) || !touches_it(after)) continue;
      const double slope = (after.at(vertex).gap - before.at(vertex).gap) / (2.0 * h);
      const ContactRow row = contact_row(event, a.vertex(vertex), true, paths);
      const Wrench& wrench = (row.*form).on_a;
      const double predicted = dot(wrench.force, change.shift) + wrench.torque * change.turn;
      worst = std::max(worst, std::abs(slope - predicted));
    }
  }
  return worst;
}

Measure differences(PairWrench ContactRow::*form) {
  return [=](Size size) {
    const Step step = slanting_impact(1.0, 100);
    std::vector<Measurement> measurements;
    for (double h = size == Size::full ? 1e-6 : 1e-4; h < 2e-3; h *= std::sqrt(10.0)) {
      measurements.push_back({.x = h, .error = worst_difference(step, h, form)});
    }
    return measurements;
  };
}

}  // namespace

Experiment gradients() {
  return {.key = "gradients",
          .title = "Derivatives of the gap against central differences",
          .x = "change ε",
          .error = "largest difference of a derivative, over all vertices",
          .lines = {{.key = "end",
                     .label = "arms at the end of the step",
                     .measure = differences(&ContactRow::derivative),
                     .claim = Claim{.id = "10_10",
                                    .statement = "The derivative about the centres at the end is "
                                                 "exact.",
                                    .law = Algebraic{-2.0, 0.05},
                                    .window = {.from = 9e-5, .floor = 1e-12},
                                    .reason = "central differences of a gap that is exact: what is "
                                              "left is their own h^2",
                                    .api = {"stokesbook::contact_row()"}},
                     .control = Control{"arms about the centres at the start",
                                        differences(&ContactRow::force)}},
                    {.key = "start",
                     .label = "arms at the start of the step",
                     .measure = differences(&ContactRow::force)}}};
}

}  // namespace stokesbook::verification::stiv
