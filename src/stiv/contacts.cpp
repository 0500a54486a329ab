// Groups the vertex events of two components into connected contacts, with the volume (10.6) and
// the rows of each: gap (10.5), its derivative (10.9), and the balanced force (sections "Which
// number stands for a contact" and "Forces" of chapter 10).
#include "stiv/contacts.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace stokesbook {

using Eigen::Index;

namespace {

// Turns a vector x of a component's frame into the plane, at a time tau.
Complex rotate(const RigidPath& path, double tau, Complex x) {
  return std::polar(1.0, path.at(tau).orientation) * x;
}

// Returns the wrenches of the force n on one component and -n on the other: (n, arm x n) and
// (-n, -other_arm x n), both at the same point.
PairWrench opposite(Complex n, Complex arm, Complex other_arm, bool of_a) {
  const Wrench mine{n, cross(arm, n)}, others{-n, -cross(other_arm, n)};
  return of_a ? PairWrench{mine, others} : PairWrench{others, mine};
}

// An event, and whether its vertex belongs to component a.
struct Event : VertexEvent {
  bool of_a;
};

using Events = std::vector<Event>;
using Run = Events;  // events of consecutive vertices of one polygon, in the order of the curve

// Splits the events of one polygon with m vertices whose gaps are less than `limit` into runs.
std::vector<Run> split_into_runs(const std::vector<VertexEvent>& events, Index m, bool of_a,
                                 double limit) {
  std::vector<Run> runs;
  for (const VertexEvent& event : events) {
    if (event.gap >= limit) continue;
    const bool continues = !runs.empty() && runs.back().back().vertex + 1 == event.vertex;
    if (!continues) runs.emplace_back();
    runs.back().push_back({event, of_a});
  }
  // The first vertex follows the last one: join the run that ends there and the run that begins.
  if (runs.size() > 1 && runs.front().front().vertex == 0 && runs.back().back().vertex == m - 1) {
    Run& last = runs.back();
    last.insert(last.end(), runs.front().begin(), runs.front().end());
    runs.front() = std::move(last);
    runs.pop_back();
  }
  // A run of all vertices has no natural start: let it start at the widest gap.
  if (runs.size() == 1 && static_cast<Index>(runs.front().size()) == m) {
    Run& all = runs.front();
    std::rotate(all.begin(), std::ranges::max_element(all, {}, &Event::gap), all.end());
  }
  return runs;
}

using Group = std::vector<Run>;  // connected runs

// Groups the events of a pair whose gaps are less than `limit` into connected runs.
std::vector<Group> group_runs(const PairEvents& pair, double limit) {
  const Index m_a = pair.shape_a.polygon.size(), m_b = pair.shape_b.polygon.size();
  std::vector<Run> runs = split_into_runs(pair.events_a, m_a, true, limit);
  std::ranges::move(split_into_runs(pair.events_b, m_b, false, limit), std::back_inserter(runs));
  std::map<Index, std::size_t> runs_in_a, runs_in_b;  // the run of each vertex
  for (std::size_t k = 0; k < runs.size(); ++k) {
    for (const Event& event : runs[k]) (event.of_a ? runs_in_a : runs_in_b)[event.vertex] = k;
  }
  std::vector<std::size_t> first(runs.size());  // the least run that each run is connected to
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (std::size_t k = 0; k < runs.size(); ++k) {
    for (const Event& event : runs[k]) {
      // The run is joined with each run of the other polygon that has a vertex of the closest edge,
      // or a vertex at most two farther.
      const std::map<Index, std::size_t>& others = event.of_a ? runs_in_b : runs_in_a;
      const Index m = event.of_a ? m_b : m_a;
      for (Index shift = -2; shift <= 3; ++shift) {
        const auto other = others.find((event.edge + shift + m) % m);
        if (other == others.end()) continue;
        const auto [kept, replaced] = std::minmax({first[k], first[other->second]});
        if (kept < replaced) std::ranges::replace(first, replaced, kept);
      }
    }
  }
  std::vector<Group> groups(runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    groups[first[k]].push_back(std::move(runs[k]));
  }
  std::erase_if(groups, &Group::empty);
  return groups;
}

// Returns the places in a run at which the gap has local minima. Between two minima the gap rises
// and falls by more than the threshold.
std::vector<std::size_t> find_minima(const Run& run, double threshold) {
  std::vector<std::size_t> found;
  std::size_t turning = 0;  // place of the least or greatest gap since the last turn
  bool descends = true;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const double beyond = run[i].gap - run[turning].gap;
    if (descends ? beyond < 0.0 : beyond > 0.0) {
      turning = i;
    } else if (descends ? beyond > threshold : beyond < -threshold) {
      if (descends) found.push_back(turning);
      descends = !descends;
      turning = i;
    }
  }
  if (descends) found.push_back(turning);
  return found;
}

// Returns for each local minimum of the gap in a run its support, the events that get rows: the
// deepest vertex, then the ends of the stretch of nearly equal gaps if the contact is flat.
std::vector<Events> find_supports(const Run& run, double threshold) {
  constexpr std::size_t vertices_of_a_curved_contact = 4;
  std::vector<Events> found;
  for (std::size_t lowest : find_minima(run, threshold)) {
    const auto is_as_deep = [&](std::size_t i) {
      return run[i].gap <= run[lowest].gap + threshold;
    };
    std::size_t first = lowest, last = lowest;
    while (first > 0 && is_as_deep(first - 1)) --first;
    while (last + 1 < run.size() && is_as_deep(last + 1)) ++last;
    const bool is_flat = last - first + 1 > vertices_of_a_curved_contact;
    found.push_back({run[lowest]});
    if (is_flat && first < lowest) found.back().push_back(run[first]);
    if (is_flat && last > lowest) found.back().push_back(run[last]);
  }
  return found;
}

ContactRow row_of(const PairEvents& pair, const Event& event) {
  const ContactShape& shape = event.of_a ? pair.shape_a : pair.shape_b;
  return contact_row(event, shape.polygon.vertex(event.vertex), event.of_a, pair.paths);
}

// Returns the events of all runs of a group, one run after the other.
Events collect_events(const Group& group) {
  Events events;
  for (const Run& run : group) events.insert(events.end(), run.begin(), run.end());
  return events;
}

Event find_deepest(const Events& events) {
  return *std::ranges::min_element(events, {}, &Event::gap);
}

void add(PairWrench& sum, double weight, const PairWrench& wrenches) {
  const auto add_to = [weight](Wrench& wrench, const Wrench& other) {
    wrench.force += weight * other.force;
    wrench.torque += weight * other.torque;
  };
  add_to(sum.on_a, wrenches.on_a);
  add_to(sum.on_b, wrenches.on_b);
}

// Returns the weighted mean of the rows of all vertices that end too deep, with the gap V / sum w_s
// (10.6). Point, normal, time and key are those of the deepest vertex.
ContactRow mean_row(const PairEvents& pair, const Events& violation) {
  ContactRow mean = row_of(pair, find_deepest(violation));
  mean.gap = 0.0;
  mean.force = mean.derivative = {};
  double length = 0.0;
  for (const Event& event : violation) length += event.weight;
  for (const Event& event : violation) {
    const ContactRow row = row_of(pair, event);
    const double share = event.weight / length;
    mean.gap += share * row.gap;
    add(mean.force, share, row.force);
    add(mean.derivative, share, row.derivative);
  }
  return mean;
}

// Adds a row for each local minimum of the gap, to the violation that contains it, or else to a new
// contact that is near but not violated. The vertices of one polygon suffice, as each polygon sees
// the whole contact: the polygon with the deepest vertex is used.
std::vector<Contact> add_deepest_rows(const PairEvents& pair, const std::vector<Events>& violations,
                                      std::vector<Contact> contacts) {
  const double sags = pair.shape_a.sag + pair.shape_b.sag;
  for (const Group& group : group_runs(pair, std::numeric_limits<double>::infinity())) {
    Contact near{pair.paths.a, pair.paths.b, 0.0, {}};
    const bool of_a = find_deepest(collect_events(group)).of_a;
    for (const Run& run : group) {
      if (run.front().of_a != of_a) continue;
      for (const Events& support : find_supports(run, sags)) {
        const auto is_it = [&](const Event& event) {
          return event.of_a == of_a && event.vertex == support.front().vertex;
        };
        const auto violated = std::ranges::find_if(violations, [&](const Events& violation) {
          return std::ranges::any_of(violation, is_it);
        });
        Contact& contact = violated == violations.end()
                               ? near
                               : contacts[static_cast<std::size_t>(violated - violations.begin())];
        for (const Event& event : support) contact.rows.push_back(row_of(pair, event));
      }
    }
    if (!near.rows.empty()) contacts.push_back(std::move(near));
  }
  return contacts;
}

}  // namespace

ContactRow contact_row(const VertexEvent& event, Complex vertex, bool of_a, const PathPair& paths) {
  const RigidPath& mine = of_a ? paths.path_a : paths.path_b;
  const RigidPath& other = of_a ? paths.path_b : paths.path_a;
  //! [row]
  // Arms use only the vector between the centres: places far from the origin would lose digits.
  const Complex apart = other.start.position - mine.start.position;
  const Complex apart_at_end = apart + (other.displacement - mine.displacement);
  const Complex normal = rotate(other, event.time, event.normal);
  // The force acts half-way between the vertex and the point that it touches.
  const Complex arm =
      0.5 * (rotate(mine, event.time, vertex) + apart + rotate(other, event.time, event.point));
  const Complex arm_at_end = rotate(mine, 1.0, vertex);
  //! [row]
  const RowKey key =
      of_a ? RowKey{paths.a, paths.b, event.vertex} : RowKey{paths.b, paths.a, event.vertex};
  // Force with the centres at the start, derivative (10.9) with the centres at the end of the step.
  return {key,
          event.gap,
          event.time,
          mine.start.position + arm,
          of_a ? normal : -normal,
          opposite(normal, arm, arm - apart, of_a),
          opposite(rotate(other, 1.0, event.normal), arm_at_end, arm_at_end - apart_at_end, of_a)};
}

PairEvents pair_events(const ContactShapes& shapes, const PathPair& paths,
                       const Clearance& clearance) {
  const ContactShape &a = *shapes[paths.a], &b = *shapes[paths.b];
  VertexEvents of_a = vertex_events(a, b, RelativePath(paths.path_a, paths.path_b), clearance),
               of_b = vertex_events(b, a, RelativePath(paths.path_b, paths.path_a), clearance);
  of_a.cost += of_b.cost;
  return {paths, a, b, std::move(of_a.events), std::move(of_b.events), of_a.cost};
}

std::vector<Contact> connected_contacts(const PairEvents& pair, double tolerance, RowChoice rows) {
  std::vector<Events> violations;
  std::vector<Contact> contacts;
  for (const Group& group : group_runs(pair, -tolerance)) {
    violations.push_back(collect_events(group));
    double volume = 0.0;  // V = sum w_s g_s (10.6)
    for (const Event& event : violations.back()) volume += event.weight * event.gap;
    contacts.push_back({pair.paths.a, pair.paths.b, volume, {}});
  }
  contacts = add_deepest_rows(pair, violations, std::move(contacts));
  for (std::size_t k = 0; k < violations.size(); ++k) {
    std::vector<ContactRow>& own = contacts[k].rows;
    if (rows == RowChoice::aggregate) {
      own = {mean_row(pair, violations[k])};
    } else if (rows == RowChoice::every) {
      own.clear();
      for (const Event& event : violations[k]) own.push_back(row_of(pair, event));
    } else if (own.empty()) {
      // No local minimum belongs to this violation, as a deeper one is within the sags. The row is
      // that of its deepest vertex, which may also be the end of a flat support of the deeper one.
      const ContactRow row = row_of(pair, find_deepest(violations[k]));
      for (Contact& other : contacts) {
        std::erase_if(other.rows, [&](const ContactRow& its) { return its.key == row.key; });
      }
      own = {row};
    }
  }
  for (Contact& contact : contacts) std::ranges::sort(contact.rows, {}, &ContactRow::key);
  return contacts;
}

}  // namespace stokesbook
