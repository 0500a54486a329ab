// Tests Newton's third law for the forces of a row, and the invariance of volumes and forces under
// a change of the observer.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "set_ups.hpp"
#include "stiv/absolute_volume.hpp"

namespace stokesbook::verification::stiv {

using namespace study;

namespace {

// Returns the larger of |F_a + F_b| and the sum of the torques about the origin, for the positions
// at the start of the step (10.10).
double imbalance(const PairWrench& wrench, const PathPair& paths) {
  const auto& [on_a, on_b] = wrench;
  const double torque = cross(paths.path_a.start.position, on_a.force) + on_a.torque +
                        cross(paths.path_b.start.position, on_b.force) + on_b.torque;
  return std::max(std::abs(on_a.force + on_b.force), std::abs(torque));
}

Measure imbalances(PairWrench ContactRow::*form) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int k = -8; k <= (size == Size::full ? 3 : -3); ++k) {
      // At the start of the step the gap is so small that even the shortest step leads to contact.
      const double length = 0.1 * std::pow(2.0, k);
      Step step = slanting_impact(1.0, 400);
      const double contact = first_time(violations(step, {{0.1}, 1e-8, RowChoice::every}));
      for (RigidPath& path : step.paths) {
        path.start = path.at(0.99999 * contact);
        path.displacement *= length;
        path.rotation *= length;
      }
      double worst = 0.0;
      for (const Contact& contact_found : violations(step, {{0.1}, 1e-8, RowChoice::every})) {
        for (const ContactRow& row : contact_found.rows) {
          worst = std::max(worst, imbalance(row.*form, {0, 1, step.paths[0], step.paths[1]}));
        }
      }
      measurements.push_back({.x = length, .error = worst});
    }
    return measurements;
  };
}

// Returns the paths of two circles with a small offset that approach each other by .4. The observer
// moves to the left: at the observer's velocity .2 the right circle rests, and at higher velocities
// the left circle chases it.
PathPair seen_by(double observer) {
  return {0,
          1,
          {{{0.0, 0.0}, 0.0}, {0.2 + observer, 0.0}, 0.0},
          {{{2.2, 0.2}, 0.0}, {-0.2 + observer, 0.0}, 0.0}};
}

constexpr double event_tolerance = 1e-5;

PairEvents events_of(const PathPair& paths) {
  static const ContactShapes circles{body(Circle{1.0}, 256), body(Circle{1.0}, 256)};
  return pair_events(circles, paths, {0.1, event_tolerance, 0.4, 0.0});
}

Contact contact_of(double observer) {
  const PathPair paths = seen_by(observer);
  return connected_contacts(events_of(paths), event_tolerance, RowChoice::aggregate).front();
}

AbsoluteVolume absolute_of(double observer) {
  return absolute_volume(events_of(seen_by(observer)), event_tolerance);
}

double force_sum(const Wrench& a, const Wrench& b) {
  return std::abs(a.force + b.force) / std::max(std::abs(a.force), std::abs(b.force));
}

double relative_sum(double observer) {
  const PairWrench force = contact_of(observer).rows.front().force;
  return force_sum(force.on_a, force.on_b);
}

double absolute_sum(double observer) {
  const PairWrench force = absolute_of(observer).force;
  return force_sum(force.on_a, force.on_b);
}

double relative_change(double observer) {
  const Contact seen = contact_of(observer), same = contact_of(0.0);
  return std::max(
      std::abs(seen.volume / same.volume - 1.0),
      std::abs(seen.rows.front().force.on_a.force - same.rows.front().force.on_a.force));
}

double absolute_change(double observer) {
  const AbsoluteVolume seen = absolute_of(observer), same = absolute_of(0.0);
  return std::abs(seen.volume / same.volume - 1.0);
}

Measure for_observers(double (*error)(double observer)) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double observer : {0.01, 0.05, 0.1, 0.2, 0.4, 1.0, 10.0, 100.0}) {
      measurements.push_back({.x = observer, .error = error(observer)});
    }
    return measurements;
  };
}

}  // namespace

Experiment balance() {
  return {
      .key = "balance",
      .title = "Newton's third law for every vertex of an impact",
      .x = "length of the step Δt",
      .error = "largest sum of forces or torques",
      .lines = {{.key = "start",
                 .label = "arms at the start of the step",
                 .measure = imbalances(&ContactRow::force),
                 .claim = Claim{.id = "10_11",
                                .statement = "Forces and torques of a row add up to zero.",
                                .law = Identity{1e-14},
                                .reason = "one normal and one point for both components, with "
                                          "torques about the centres where the flow is solved; a "
                                          "few roundings",
                                .api = {"stokesbook::contact_row()"}},
                 .control = Control{"the derivative of the gap for the force",
                                    imbalances(&ContactRow::derivative)}},
                {.key = "end",
                 .label = "arms at the end of the step",
                 .measure = imbalances(&ContactRow::derivative),
                 .claim = Claim{.id = "10_12",
                                .statement = "The derivative of the gap leaves a torque in "
                                             "proportion to the step.",
                                .law = Algebraic{-1.0},
                                .reason = "it balances about the centres at the end: at the start "
                                          "the sum is the relative displacement times the normal",
                                .api = {"stokesbook::contact_row()"}},
                 .control = Control{"arms at the start, which leave none",
                                    imbalances(&ContactRow::force)}}}};
}

Experiment observers() {
  return {
      .key = "observers",
      .title = "One impact of two circles, seen by moving observers",
      .x = "velocity of the observer v",
      .error = "relative: sum of forces, change of volume",
      .lines = {
          {.key = "sum",
           .label = "sum of forces, relative volume",
           .measure = for_observers(relative_sum),
           .claim = Claim{.id = "10_13",
                          .statement = "Forces by the relative volume are opposite for any "
                                       "observer.",
                          .law = Identity{1e-14},
                          .reason = "each vertex has one normal for both circles; a few "
                                    "roundings",
                          .api = {"stokesbook::interferences()"}},
           .control = Control{"the volume by absolute velocities", for_observers(absolute_sum)}},
          {.key = "change",
           .label = "change, relative volume",
           .measure = for_observers(relative_change),
           .claim = Claim{.id = "10_14",
                          .statement = "Volume and forces are the same for any observer.",
                          .law = Identity{1e-10},
                          .reason = "only differences of displacements enter; these have "
                                    "rounding errors of 1e-14 at a velocity of 100, and "
                                    "enter through depths of 1e-1 at worst a hundred times",
                          .api = {"stokesbook::RelativePath"}},
           .control = Control{"the volume by absolute velocities", for_observers(absolute_change)}},
          {.key = "absolute_sum",
           .label = "sum of forces, absolute velocities",
           .measure = for_observers(absolute_sum)},
          {.key = "absolute_change",
           .label = "change, absolute velocities",
           .measure = for_observers(absolute_change)}}};
}

}  // namespace stokesbook::verification::stiv
