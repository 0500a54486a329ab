// Runs random dense crowds with steps that are far too long, and checks in every step the gap, the
// balance of contact forces and the number of contact iterations.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "crowds.hpp"
#include "experiments.hpp"
#include "support/contact_balance.hpp"
#include "support/exact_gaps.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"
#include "suspension/contact/gap_constraints.hpp"
#include "suspension/motion/stepping.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

/// Results of the scenes of one family.
struct Tally {
  double scenes = 0.0, stopped = 0.0, steps = 0.0, halved = 0.0;
  double in_contact = 0.0;                         // steps in contact
  double iterations = 0.0, most_iterations = 0.0;  // contact iterations; most in a step
  double all_iterations = 0.0;                     // with the iterations of rejected attempts
  double narrowest = 4.0;                          // least gap of any written state, in separations
  double unbalanced = 0.0, unbalanced_without_reaction = 0.0;
  double seconds = 0.0, seconds_of_contact = 0.0;
  int one_by_one = 0;  // linear problems of the step with the most contacts, see one_by_one()
};

/// Returns a frame in which each contact force acts on only one of the two bodies: a planted
/// defect.
Frame without_reaction(const Scene& scene, Frame frame) {
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    frame.bodies[k].force = scene.bodies[k].force;
    frame.bodies[k].torque = scene.bodies[k].torque;
  }
  for (const ContactForce& contact : frame.contacts) {
    if (contact.a.is_wall) continue;
    BodyState& body = frame.bodies[contact.a.number];
    const Complex force = contact.force * contact.normal;
    body.force += force;
    body.torque += cross(contact.point - body.position, force);
  }
  return frame;
}

/// Returns the gaps of one pair of polygons, and their derivatives.
ContactRows rows_of_pair(const std::vector<stokesbook::Contact>& contacts,
                         const ComponentPair& pair, Eigen::Index velocities) {
  ContactRows rows;
  std::vector<double> gaps;
  std::vector<Eigen::Triplet<double>> derivatives, forces;
  const auto add = [&](auto& entries, std::size_t component, const Wrench& wrench) {
    const auto row = static_cast<int>(gaps.size()), first = static_cast<int>(3 * component);
    entries.emplace_back(row, first, wrench.force.real());
    entries.emplace_back(row, first + 1, wrench.force.imag());
    entries.emplace_back(row, first + 2, wrench.torque);
  };
  for (const stokesbook::Contact& contact : contacts) {
    if (ComponentPair{contact.a, contact.b} != pair) continue;
    for (const ContactRow& row : contact.rows) {
      add(derivatives, contact.a, row.derivative.on_a);
      add(derivatives, contact.b, row.derivative.on_b);
      add(forces, contact.a, row.force.on_a);
      add(forces, contact.b, row.force.on_b);
      rows.keys.push_back({static_cast<std::int64_t>(row.key.vertex_of), row.key.vertex});
      gaps.push_back(row.gap);
    }
  }
  const auto m = static_cast<Eigen::Index>(gaps.size());
  rows.gap = Eigen::Map<const Eigen::VectorXd>(gaps.data(), m);
  rows.gradient.resize(m, velocities);
  rows.gradient.setFromTriplets(derivatives.begin(), derivatives.end());
  rows.force_gradient.resize(m, velocities);
  rows.force_gradient.setFromTriplets(forces.begin(), forces.end());
  return rows;
}

/// Resolves the contact of one Euler step pair by pair, until no pair is in contact or each pair
/// has been resolved four times: a planted defect.
///
/// @return  number of linear problems
int one_by_one(Scene scene, const Frame& frame) {
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    scene.bodies[k].position = frame.bodies[k].position;
    scene.bodies[k].orientation = frame.bodies[k].orientation;
  }
  const SuspensionSolver solver(scene);
  Instant start = solver.start();
  const auto reversals =
      std::ranges::count_if(scene.reverse_at, [&](double t) { return t <= frame.t; });
  start.forcing = scaled(reversals % 2 == 0 ? 1.0 : -1.0, start.forcing);
  const Solution free = solver.solve(start);
  ContactMobility mobility(solver, free);
  const double separation = solver.separation(), sag = 4e-3 * separation;
  const ContactShapes shapes = contact_shapes(solver.discretisation(), sag);
  const ContactRules polygons{{separation + 2.0 * sag}, 1e-5 * separation};
  Eigen::VectorXd velocity = to_rate(free);
  const double dt = *scene.time->dt;
  const auto contacts_at = [&](const Eigen::VectorXd& at) {
    return interferences(shapes, straight_paths(start.configuration, at, dt), polygons).contacts;
  };
  int linear_problems = 0;
  for (int sweep = 0; sweep < 4; ++sweep) {
    for (const stokesbook::Contact& contact : contacts_at(velocity)) {
      const ContactResult result = resolve_contact(
          {.free_velocity = velocity,
           .dt = dt,
           .separation = separation,
           .tolerance = polygons.tolerance,
           .rows =
               [&](const Eigen::VectorXd& at) {
                 return rows_of_pair(contacts_at(at), {contact.a, contact.b}, at.size());
               },
           .respond = [&](const Eigen::SparseMatrix<double>& forces) -> Eigen::MatrixXd {
             return mobility(forces);
           }});
      linear_problems += result.iterations;
      if (result.status == ContactStatus::resolved) velocity = result.velocity;
    }
  }
  return linear_problems;
}

void add(Tally& tally, const Scene& scene, double separation) {
  const auto start = std::chrono::steady_clock::now();
  const RecordedRun run = recorded_run(scene, Refusals::recorded);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  tally.seconds += passed.count();
  tally.seconds_of_contact += run.totals.contact_seconds;
  tally.scenes += 1.0;
  tally.stopped += run.stopped.empty() ? 0.0 : 1.0;
  tally.steps += static_cast<double>(run.totals.steps);
  tally.halved += static_cast<double>(run.totals.rejected_steps);
  tally.all_iterations += static_cast<double>(run.totals.ncp_iterations);
  for (const StepInfo& step : run.steps) {
    const double iterations = step.ncp_iterations;
    tally.in_contact += iterations > 0.0 ? 1.0 : 0.0;
    tally.iterations += iterations;
    tally.most_iterations = std::max(tally.most_iterations, iterations);
  }
  const double gap = least_exact_gap(scene, run.frames, 4.0 * separation);
  tally.narrowest = std::min(tally.narrowest, gap / separation);
  for (const Frame& frame : run.frames) {
    tally.unbalanced = std::max(tally.unbalanced, contact_imbalance(scene, frame));
    tally.unbalanced_without_reaction =
        std::max(tally.unbalanced_without_reaction,
                 contact_imbalance(scene, without_reaction(scene, frame)));
  }
  if (!scene.contact) return;
  const auto contacts = [](const Frame& frame) { return frame.contacts.size(); };
  const Frame& most = std::ranges::max(run.frames, {}, contacts);
  if (tally.one_by_one == 0 && contacts(most) > 0) tally.one_by_one = one_by_one(scene, most);
}

// Without contact, an overlap stops the run. The planted defect leaves contact out; its steps may
// not be halved, so that the run stops at once. Few scenes suffice for it.
enum class Contact { resolved, left_out };

using Tallies = std::map<int, Tally>;

const Tallies& tallies(Size size, Contact contact) {
  static Once<std::pair<Size, Contact>, Tallies> all;
  return all({size, contact}, [&] {
    const bool few = size == Size::quick || contact == Contact::left_out;
    std::vector<unsigned> seeds{2, 11, 12, 20, 22};
    if (contact == Contact::left_out) seeds = {28, 30, 32};
    if (!few) {
      seeds.resize(200);
      std::iota(seeds.begin(), seeds.end(), 0U);
    }
    Tallies result;
    for (const unsigned seed : seeds) {
      const auto drive = static_cast<int>(seed / crowds) % drives,
                 crowd = static_cast<int>(seed % crowds);
      Scene scene = crowded_scene({static_cast<Drive>(drive), static_cast<Crowd>(crowd)}, seed,
                                  few ? 10 : 200);
      const double separation = scene.contact->minimum_separation;
      if (contact == Contact::left_out) {
        scene.contact.reset();
        scene.time->dt_min = scene.time->dt;
      }
      add(result[crowds * drive + crowd + 1], scene, separation);
    }
    return result;
  });
}

std::vector<Measurement> measured(double (*quantity)(const Tally&), const Tallies& tallies) {
  std::vector<Measurement> measurements;
  for (const auto& [number, tally] : tallies) {
    measurements.push_back({.x = static_cast<double>(number), .error = quantity(tally)});
  }
  return measurements;
}

Measure over_families(double (*quantity)(const Tally&), Contact contact = Contact::resolved) {
  return [=](Size size) { return measured(quantity, tallies(size, contact)); };
}

double lost(const Tally& tally) {
  return std::max(0.0, 1.0 - tally.narrowest);
}
double stopped(const Tally& tally) {
  return tally.stopped;
}
double mean_iterations(const Tally& tally) {
  return tally.iterations / std::max(tally.in_contact, 1.0);
}
double problems_one_by_one(const Tally& tally) {
  return tally.one_by_one;
}
double most_iterations(const Tally& tally) {
  return tally.most_iterations;
}

double share_of_time(const Tally& tally) {
  return tally.seconds_of_contact / tally.seconds;
}

/// Adds up the families of each flow (steps in contact, and their iterations); the sum has the
/// number of the last family.
Measure over_flows(double (*quantity)(const Tally&)) {
  return [=](Size size) {
    std::map<int, std::pair<int, Tally>> flows;
    for (const auto& [family, tally] : tallies(size, Contact::resolved)) {
      auto& [last, sum] = flows[(family - 1) / crowds];
      last = family;
      sum.in_contact += tally.in_contact;
      sum.iterations += tally.iterations;
      sum.one_by_one = std::max(sum.one_by_one, tally.one_by_one);
    }
    Tallies sums;
    for (const auto& [flow, family_and_sum] : flows) sums.insert(family_and_sum);
    return measured(quantity, sums);
  };
}

Line counted(const std::string& key, const std::string& label, double (*quantity)(const Tally&)) {
  return {.key = key, .label = label, .measure = over_families(quantity)};
}

}  // namespace

Experiment random_crowds() {
  return left_to_full(
      {.key = "crowds",
       .title =
           "Random dense crowds, steps up to twenty times too long: in a rotating container (1 "
           "to 3), shear (4 to 6), extension (7 to 9), vortices (10 to 12), settling (13 to "
           "15); of each circles, ellipses to 10:1, stars",
       .x = "family f",
       .error = "number, or part of the separation",
       .axes = Axes::nominal,
       .lines = {
           {.key = "lost",
            .label = "shortfall of the narrowest gap, relative to the separation",
            .measure = over_families(lost),
            .claim = Claim{.id = "12_18",
                           .statement = "In every written state of a random crowd all gaps are at "
                                        "least the separation, less a thousandth of it.",
                           .law = AtMost{1e-3},
                           .reason = "steps are accepted by the closest points of the curves; "
                                     "measured by formulas that share no code with them",
                           .api = {"stokesbook::SuspensionContact"}},
            .control = Control{"contact left out", over_families(lost, Contact::left_out)}},
           {.key = "unbalanced",
            .label = "net force or torque of contact, with the walls' reactions, over the largest",
            .measure = over_families([](const Tally& tally) { return tally.unbalanced; }),
            .claim = Claim{.id = "12_19",
                           .statement = "The forces of contact balance, including those on walls, "
                                        "and so do their torques.",
                           .law = Identity{1e-12},
                           .reason = "they act on both bodies at one point along one line",
                           .api = {"stokesbook::SuspensionContact"}},
            .control = Control{"forces that act on one of both bodies only",
                               over_families([](const Tally& tally) {
                                 return tally.unbalanced_without_reaction;
                               })}},
           {.key = "stopped",
            .label = "scenes that stopped",
            .measure = over_families(stopped),
            .claim = Claim{.id = "12_20",
                           .statement = "Every run of a random crowd reaches its end.",
                           .law = Identity{0.0},
                           .reason = "a step that contact does not resolve is halved, and short "
                                     "steps have linear problems with a solution",
                           .api = {"stokesbook::Simulation"}},
            .control = Control{"contact left out", over_families(stopped, Contact::left_out)}},
           counted("scenes", "scenes", [](const Tally& tally) { return tally.scenes; }),
           counted("steps", "steps", [](const Tally& tally) { return tally.steps; }),
           counted("halved", "steps halved", [](const Tally& tally) { return tally.halved; }),
           counted("in_contact", "steps in contact",
                   [](const Tally& tally) { return tally.in_contact; }),
           counted("all_iterations", "contact iterations, with those of rejected attempts",
                   [](const Tally& tally) { return tally.all_iterations; }),
           counted("iterations", "contact iterations in a step in contact, on average",
                   mean_iterations),
           {.key = "flows",
            .label = "the same for all families of a flow together, shown at its last family",
            .measure = over_flows(mean_iterations),
            .claim =
                Claim{.id = "12_23",
                      .statement = "A step in contact takes fewer than three linear problems "
                                   "on average, in every flow.",
                      .law = AtMost{3.0},
                      .reason =
                          "Newton's method for gaps that are nearly linear where the step before "
                          "ended; both stages of Heun's method count, rejected attempts do not",
                      .api = {"stokesbook::SuspensionContact"}},
            .control = Control{"pairs resolved one by one", over_flows(problems_one_by_one)}},
           {.key = "most_iterations",
            .label = "most in a step",
            .measure = over_families(most_iterations),
            .claim =
                Claim{.id = "12_24",
                      .statement = "No step takes more than nine linear problems.",
                      .law = AtMost{9.0},
                      .reason = "a step that needs more is halved; the published maximum is nine",
                      .api = {"stokesbook::SuspensionContact"}},
            .control = Control{"pairs resolved one by one", over_families(problems_one_by_one)}},
           counted("share", "share of the time that contact takes", share_of_time)}});
}

}  // namespace stokesbook::verification::suspension
