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
                                         const Separation& separation) {
  std::vector<ContactForce> forces;
  for (std::size_t i = 0; i < result.keys.size(); ++i) {
    const auto row = static_cast<Index>(i);
    if (result.multipliers[row] <= 0.0) continue;
    const GapConstraint& found = constraints.at(result.keys[i]);
    forces.push_back({contact_party(scene, found.a), contact_party(scene, found.b),
                      found.force_on_a.point, found.force_on_a.normal, result.multipliers[row],
                      separation.between(found.a, found.b) + result.gaps[row]});
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
    const GapConstraint& found = constraints.at(result.keys[i]);
    pairs.emplace_back(found.a, found.b);
  }
  return pairs;
}

}  // namespace

Imbalance imbalance(const VectorXd& force, const Configuration& acting,
                    const ContactShapes& shapes) {
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
  double torque = 0.0, largest = 0.0, farthest = 0.0, radius = 0.0;
  for (const std::size_t k : loaded) {
    const auto first = static_cast<Index>(3 * k);
    const Complex own(force[first], force[first + 1]), arm = acting[k].position - centre;
    net += own;
    torque += force[first + 2] + cross(arm, own);
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

// Finds the gaps of pairs that forces can move apart, and all overlaps.
std::vector<PolygonGap> SuspensionContact::gaps(const Configuration& configuration) const {
  std::vector<PolygonGap> gaps = polygon_gaps(shapes_, configuration, polygon_separation_);
  std::erase_if(gaps, [this](const PolygonGap& found) {
    return found.gap > 0.0 && !is_movable_pair(solver_.discretisation(), found.a, found.b);
  });
  return gaps;
}

double SuspensionContact::curve_gap(const PolygonGap& found,
                                    const Configuration& configuration) const {
  const auto curve = [&](std::size_t k) {
    return smooth_curve(*solver_.discretisation()[k], configuration[k]);
  };
  return closest_points(curve(found.a), curve(found.b)).gap;
}

ConstraintRules SuspensionContact::constraint_rules(const CloserPairs& closer) const {
  return {{{polygon_separation_, closer}, relative_tolerance * separation_}, {separation_, closer}};
}

CloserPairs SuspensionContact::admit_start(const Configuration& configuration) const {
  std::vector<std::string> overlaps, narrow;
  CloserPairs closer;
  for (const PolygonGap& found : gaps(configuration)) {
    const std::string pair = name_pair(solver_.scene(), found.a, found.b);
    if (found.gap <= 0.0) {
      overlaps.push_back(pair + " by " + short_number(-found.gap));
    } else {
      const double gap = curve_gap(found, configuration);
      closer[{found.a, found.b}] = gap;
      if (gap < (1.0 - relative_slack_of_starts) * separation_) {
        narrow.push_back(pair + " are " + short_number(gap) + " apart");
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

CloserPairs SuspensionContact::update_closer(const CloserPairs& closer,
                                             const Configuration& configuration) const {
  if (closer.empty()) return {};
  CloserPairs result;
  for (const PolygonGap& found : gaps(configuration)) {
    const auto earlier = closer.find({found.a, found.b});
    if (earlier == closer.end()) continue;
    result[earlier->first] = std::max(earlier->second, curve_gap(found, configuration));
  }
  return result;
}

std::string SuspensionContact::too_close(const Configuration& configuration,
                                         const CloserPairs& closer) const {
  const Separation kept{separation_, closer};
  std::vector<std::string> pairs;
  for (const PolygonGap& found : gaps(configuration)) {
    const double gap = found.gap > 0.0 ? curve_gap(found, configuration) : found.gap;
    // Twice the tolerance of the contact loop, whose closest points differ by rounding: they were
    // found from other starting points.
    const double least = kept.between(found.a, found.b) - 2.0 * relative_tolerance * separation_;
    if (gap >= least) continue;
    pairs.push_back(name_pair(solver_.scene(), found.a, found.b) + " are " + short_number(gap) +
                    " apart");
  }
  return joined(pairs);
}

double SuspensionContact::relative_displacement(const Configuration& start,
                                                const VectorXd& velocity, double dt) const {
  const std::vector<RigidPath> paths = straight_paths(start, velocity, dt);
  const auto area_over_perimeter = [this](std::size_t k) {
    const Curve& curve = solver_.discretisation()[k]->curve;
    return area(curve) / perimeter(curve);
  };
  double largest = 0.0;
  for (const Contact& contact :
       interferences(shapes_, paths, constraint_rules({}).polygons).contacts) {
    const std::size_t a = contact.a, b = contact.b;
    if (!is_movable_pair(solver_.discretisation(), a, b)) continue;
    const double length = RelativePath(paths[a], paths[b]).speed_bound(shapes_[a]->radius);
    const double width = std::min(area_over_perimeter(a), area_over_perimeter(b));
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
      .tolerance = rules.polygons.tolerance,
      .rows = {},
      .respond = [&](const Eigen::SparseMatrix<double>& forces) -> Eigen::MatrixXd {
        return stage.share * mobility(forces);
      },
      .refine = [&](const VectorXd& multipliers) { return mobility.refine(multipliers); },
      .name =
          [&](const ContactKey& key) {
            const GapConstraint& constraint = constraints.at(key);
            return name_pair(solver_.scene(), constraint.a, constraint.b);
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
  outcome.forces = contact_forces(solver_.scene(), result, constraints, rules.curves);
  outcome.unresolved = unresolved_pairs(outcome, constraints, solver_.scene().solver.tolerance);
  outcome.imbalance = imbalance(result.force, stage.acting, shapes_);
  outcome.kkt_residual = result.kkt_residual / separation_;
  return outcome;
}

}  // namespace stokesbook
