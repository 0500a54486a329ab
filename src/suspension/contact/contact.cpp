// Keeps components apart: finds the contact forces of a stage (chapter 12).
//
// The loops from the outside in, each with the condition that ends it:
//   ContactSteps::advance   until the error of the step is allowed: shorten the step
//     ContactSteps::begin     until the first stage is resolved: halve the step
//       ContactStages::resolve  until nodes and GMRES tolerance suffice for the contact forces
//         SuspensionContact::resolve   until the linear problems have solutions: better mobility
//           GapConstraints::resolve      exact Jacobian of the gaps, then that of the forces
//             resolve_contact              Newton's method for the gaps: one linear complementarity
//                                          problem an iteration (chapter 11)
//               ContactMobility::refine      until the combination of columns is accurate: GMRES
#include "suspension/contact/contact.hpp"

#include <algorithm>
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "suspension/bodies/components.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Over the separation: the distance between polygons and their curves, and the tolerance of gaps.
constexpr double relative_sag = 4e-3, relative_tolerance = 1e-5;

// Configurations at the start are often given with few digits: a gap may be narrower than the
// separation by this part.
constexpr double relative_slack_of_starts = 1e-3;

// Improves a mobility for which a linear complementarity problem had no solution, or for which a
// force does not open its own gap. Returns false if no improvement is left.
bool improve(ContactMobility& mobility, ContactStatus status) {
  const bool unsolved = status == ContactStatus::no_linear_solution;
  if (!unsolved && status != ContactStatus::response_not_seen) return false;
  return mobility.tighten() || (unsolved && mobility.accept_any_correction());
}

ContactParty contact_party(const Scene& scene, std::size_t component) {
  const ComponentView view = component_of(scene, component);
  return {view.wall != nullptr, view.number};
}

std::vector<ContactForce> contact_forces(const Scene& scene, const ContactResult& result,
                                         const GapConstraints& constraints,
                                         const ConstraintRules& rules,
                                         const std::optional<Lattice>& lattice) {
  std::vector<ContactForce> forces;
  for (std::size_t i = 0; i < result.keys.size(); ++i) {
    const auto row = static_cast<Index>(i);
    if (result.multipliers[row] <= 0.0) continue;
    const GapConstraint& found = constraints.at(result.keys[i]);
    const auto& [a, b, image] = found.pair;
    forces.push_back({.a = contact_party(scene, a),
                      .b = contact_party(scene, b),
                      .point = found.force_on_a.point,
                      .normal = found.force_on_a.normal,
                      .force = result.multipliers[row],
                      .gap = rules.between(found.pair, rules.curves) + result.gaps[row],
                      .image = image,
                      .shift = lattice ? lattice->vector(image) : Complex{}});
  }
  return forces;
}

// Lists the pairs whose gap does not open under its own force; all pairs if the linear problem has
// no solution, or if the mobility was corrected by more than the tolerance.
std::vector<ComponentPair> unresolved_pairs(const ContactOutcome& outcome,
                                            const GapConstraints& constraints, double tolerance) {
  const ContactResult& result = outcome.result;
  const bool is_solved =
      result.status != ContactStatus::no_linear_solution && outcome.correction <= tolerance;
  std::vector<ComponentPair> pairs;
  for (std::size_t i = 0; i < result.keys.size(); ++i) {
    if (is_solved && result.response[static_cast<Index>(i)] > 0.0) continue;
    const ContactPair& found = constraints.at(result.keys[i]).pair;
    pairs.emplace_back(found.a, found.b);
  }
  return pairs;
}

}  // namespace

Imbalance imbalance(const VectorXd& force, const Configuration& acting, const ContactShapes& shapes,
                    double torque) {
  std::vector<std::size_t> loaded;
  Complex centre{};
  for (std::size_t k = 0; k < acting.size(); ++k) {
    if (force.segment<3>(static_cast<Index>(3 * k)).isZero(0.0)) continue;
    loaded.push_back(k);
    centre += acting[k].position;
  }
  if (loaded.empty()) return {0.0, 0.0};
  centre /= static_cast<double>(loaded.size());
  Complex net{};
  double largest = 0.0, farthest = 0.0, radius = 0.0;
  for (const std::size_t k : loaded) {
    const auto first = static_cast<Index>(3 * k);
    const Complex own(force[first], force[first + 1]), arm = acting[k].position - centre;
    net += own;
    torque -= force[first + 2] + cross(arm, own);
    // The forces of two contacts of a body may cancel and leave a torque.
    largest = std::max({largest, std::abs(own), std::abs(force[first + 2]) / shapes[k]->radius});
    farthest = std::max(farthest, std::abs(arm));
    radius = std::max(radius, shapes[k]->radius);
  }
  return {std::abs(net) / largest, std::abs(torque) / (largest * (farthest + radius))};
}

SuspensionContact::SuspensionContact(const SuspensionSolver& solver)
    : solver_(solver),
      separation_(solver.separation()),
      shapes_(contact_shapes(solver.discretisation(), relative_sag * separation_)) {
  double sag = 0.0;
  for (const auto& shape : shapes_) sag = std::max(sag, shape->sag);
  polygon_separation_ = separation_ + 2.0 * sag;
}

// Finds the gaps of pairs that forces can move apart, and all overlaps. Overlaps are measured by
// the polygons, gaps by the curves.
std::vector<std::pair<ContactPair, double>> SuspensionContact::gaps(
    const Placement& placement) const {
  const Discretisation& discretisation = solver_.discretisation();
  const PathImages images = resting_images(shapes_, placement, polygon_separation_);
  std::vector<Pose> poses;
  for (const RigidPath& path : images.paths) poses.push_back(path.start);
  std::vector<std::pair<ContactPair, double>> gaps;
  for (const PolygonGap& found : polygon_gaps(images.shapes, poses, polygon_separation_)) {
    const std::optional<ContactPair> pair = images.pair(found.a, found.b);
    if (!pair) continue;
    const auto curve = [&](std::size_t k, const Pose& pose) {
      return smooth_curve(*discretisation[k], pose);
    };
    if (found.gap <= 0.0) {
      gaps.emplace_back(*pair, found.gap);
    } else if (is_movable_pair(discretisation, pair->a, pair->b)) {
      gaps.emplace_back(*pair, closest_points(curve(pair->a, placement.paths[pair->a]),
                                              curve(pair->b, placement.image(pair->b, pair->image)))
                                   .gap);
    }
  }
  return gaps;
}

ConstraintRules SuspensionContact::constraint_rules(const CloserGaps& closer) const {
  return {polygon_separation_, separation_, closer, relative_tolerance * separation_};
}

CloserGaps SuspensionContact::admit_start(const Placement& start) const {
  std::vector<std::string> overlaps, narrow;
  CloserGaps closer;
  for (const auto& [pair, gap] : gaps(start)) {
    const std::string name = name_contact_pair(solver_.scene(), pair);
    if (gap <= 0.0) {
      overlaps.push_back(name + " by " + short_number(-gap));
    } else {
      closer[pair] = gap;
      if (gap < (1.0 - relative_slack_of_starts) * separation_) {
        narrow.push_back(name + " are " + short_number(gap) + " apart");
      }
    }
  }
  if (!overlaps.empty())
    throw ConfigurationError("bodies overlap at the start: " + joined(overlaps));
  if (!narrow.empty() && !solver_.scene().contact->allow_close) {
    throw ConfigurationError("pairs are closer at the start than contact.minimum_separation = " +
                             short_number(separation_) + ": " + joined(narrow) +
                             "; set contact.allow_close = true, or move them");
  }
  return closer;
}

CloserGaps SuspensionContact::update_closer(const CloserGaps& closer,
                                            const Placement& placement) const {
  if (closer.empty()) return {};
  CloserGaps result;
  for (const auto& [pair, gap] : gaps(placement)) {
    const auto earlier = closer.find(pair);
    if (earlier != closer.end()) result[pair] = std::max(earlier->second, gap);
  }
  return result;
}

std::string SuspensionContact::too_close(const Placement& placement,
                                         const CloserGaps& closer) const {
  const ConstraintRules rules = constraint_rules(closer);
  std::vector<std::string> pairs;
  for (const auto& [pair, gap] : gaps(placement)) {
    // Twice the tolerance of the contact loop, whose closest points differ by rounding: they were
    // found from other starting points.
    const double least = rules.between(pair, separation_) - 2.0 * rules.tolerance;
    if (gap >= least) continue;
    pairs.push_back(name_contact_pair(solver_.scene(), pair) + " are " + short_number(gap) +
                    " apart");
  }
  return joined(pairs);
}

double SuspensionContact::relative_displacement(const Placement& start, const VectorXd& velocity,
                                                double dt,
                                                const std::optional<Lattice>& end_lattice) const {
  const PathImages images = path_images(shapes_, straight_paths(start.paths, velocity, dt),
                                        lattice_step(start.lattice, end_lattice),
                                        listed_separations * polygon_separation_);
  const auto area_over_perimeter = [this](std::size_t k) {
    const Curve& curve = solver_.discretisation()[k]->curve;
    return area(curve) / perimeter(curve);
  };
  double largest = 0.0;
  for (const Contact& contact : constraint_rules({}).find(images).contacts) {
    const std::optional<ContactPair> pair = images.pair(contact.a, contact.b);
    if (!pair || !is_movable_pair(solver_.discretisation(), pair->a, pair->b)) continue;
    const double length = RelativePath(images.paths[contact.a], images.paths[contact.b])
                              .speed_bound(shapes_[pair->a]->radius);
    const double width = std::min(area_over_perimeter(pair->a), area_over_perimeter(pair->b));
    largest = std::max(largest, length / width);
  }
  return largest;
}

ContactOutcome SuspensionContact::resolve(const ContactStage& stage,
                                          ContactMobility& mobility) const {
  const ConstraintRules rules = constraint_rules(stage.closer);
  GapConstraints constraints(stage, solver_.discretisation(), shapes_, rules);
  const ContactStep step{
      .free_velocity = stage.free_velocity,
      .dt = stage.dt,
      .separation = separation_,
      .tolerance = rules.tolerance,
      .rows = {},
      .respond = [&](const Eigen::SparseMatrix<double>& forces) -> Eigen::MatrixXd {
        return stage.share * mobility(forces);
      },
      .refine = [&](const VectorXd& multipliers) { return mobility.refine(multipliers); },
      .guess =
          stage.guess.size() > 0 ? stage.free_velocity + stage.share * stage.guess : VectorXd{},
      .name =
          [&](const ContactKey& key) {
            return name_contact_pair(solver_.scene(), constraints.at(key).pair);
          }};
  ContactOutcome outcome{};
  const auto attempt = [&] {
    outcome.result = constraints.resolve(step);
    outcome.iterations += outcome.result.iterations;
  };
  attempt();
  // A second run begins with all pairs that the first one found, and often succeeds if the first
  // one has nearly converged.
  if (outcome.result.status == ContactStatus::not_converged &&
      outcome.result.violations.back() < separation_) {
    attempt();
  }
  while (improve(mobility, outcome.result.status)) attempt();
  const ContactResult& result = outcome.result;
  if (outcome.is_resolved()) outcome.correction = mobility.relative_correction(result.multipliers);
  outcome.forces =
      contact_forces(solver_.scene(), result, constraints, rules, stage.acting.lattice);
  outcome.unresolved = unresolved_pairs(outcome, constraints, solver_.scene().solver.tolerance);
  // A force F on a acts as -F on the image of b, at the distance w of b and with its own velocity.
  double torque_of_images = 0.0;
  if (const auto lattice = lattice_step(stage.start.lattice, stage.end_lattice)) {
    for (const ContactForce& contact : outcome.forces) {
      const Complex force = contact.force * contact.normal;
      torque_of_images += cross(contact.shift, force);
      outcome.result.power -= dot(force, lattice->displacement(contact.image)) / stage.dt;
    }
  }
  outcome.imbalance = imbalance(result.force, stage.acting.paths, shapes_, torque_of_images);
  outcome.kkt_residual = result.kkt_residual / separation_;
  return outcome;
}

}  // namespace stokesbook
