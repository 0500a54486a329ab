#include "suspension/contact.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include "double_layer/double_layer.hpp"
#include "record/number_text.hpp"
#include "suspension/gaps.hpp"
#include "suspension/stepping.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Parts of the separation: how far polygons lie from their curves, and how exactly gaps are kept.
constexpr double relative_sag = 1e-3, relative_tolerance = 1e-5;

double mean_spacing(const Scene& scene, const References& references) {
  double length = 0.0, nodes = 0.0;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    length += weights(references[k]->curve).sum();
    nodes += static_cast<double>(references[k]->curve.size());
  }
  return length / nodes;
}

double separation_of(const SuspensionSolver& solver) {
  const ContactSettings& contact = *solver.scene().contact;
  const double unit = contact.in_spacings ? mean_spacing(solver.scene(), solver.references()) : 1.0;
  return unit * contact.minimum_separation;
}

// The numbers that tell shapes apart.
struct ShapeNumbers {
  using Numbers = std::vector<double>;
  Numbers operator()(const Circle& circle) const { return {0.0, circle.radius}; }
  Numbers operator()(const Ellipse& ellipse) const { return {1.0, ellipse.a, ellipse.b}; }
  Numbers operator()(const Star& star) const {
    return {2.0, star.radius, star.amplitude, static_cast<double>(star.arms)};
  }
  Numbers operator()(const Superellipse& shape) const {
    return {3.0, shape.a, shape.b, static_cast<double>(shape.power)};
  }
  Numbers operator()(const NodalCurve& curve) const {
    Numbers numbers{4.0};
    for (const Complex x : curve.points) numbers.insert(numbers.end(), {x.real(), x.imag()});
    return numbers;
  }
};

// Components of one shape and side share their polygon.
ContactShapes shapes_of(const References& references, double sag_limit) {
  std::map<std::pair<Side, std::vector<double>>, std::shared_ptr<const ContactShape>> distinct;
  ContactShapes shapes;
  for (const auto& reference : references) {
    const Side side = reference->curve.side;
    auto& shape = distinct[{side, std::visit(ShapeNumbers{}, reference->shape)}];
    if (!shape) {
      shape =
          std::make_shared<const ContactShape>(contact_shape(reference->shape, side, sag_limit));
    }
    shapes.push_back(shape);
  }
  return shapes;
}

std::vector<Pose> poses_of(const Configuration& configuration) {
  std::vector<Pose> poses;
  for (const auto& [position, orientation] : configuration) {
    poses.push_back({position, orientation});
  }
  return poses;
}

double area_over_perimeter(const ContactShape& shape) {
  double twice_the_area = 0.0;
  Complex before = shape.polygon.vertex(shape.polygon.size() - 1);
  for (Index i = 0; i < shape.polygon.size(); ++i) {
    const Complex vertex = shape.polygon.vertex(i);
    twice_the_area += cross(before, vertex);
    before = vertex;
  }
  return 0.5 * std::abs(twice_the_area) / shape.weights.sum();
}

// Where a velocity that is packed as a rate leads to.
Configuration moved(const Configuration& start, const VectorXd& velocity, double dt) {
  return to_configuration(to_state(start) + dt * velocity);
}

// Straight paths there.
std::vector<RigidPath> paths(const Configuration& start, const VectorXd& velocity, double dt) {
  std::vector<RigidPath> paths;
  for (std::size_t k = 0; k < start.size(); ++k) {
    const auto first = static_cast<Index>(3 * k);
    const Complex displacement = dt * Complex(velocity[first], velocity[first + 1]);
    paths.push_back(
        {{start[k].position, start[k].orientation}, displacement, dt * velocity[first + 2]});
  }
  return paths;
}

// Where a force acts, and its direction on a component.
struct ActingForce {
  Complex point, normal;
};

// A row as the loop of the nonlinear problem names and weighs it.
struct LoopRow {
  std::size_t a, b;
  ContactRow row;
  ActingForce on_a{};
};

ContactKey key_of(const LoopRow& row, std::size_t components) {
  constexpr std::int64_t more_than_vertices = std::int64_t{1} << 32;
  const bool of_b = row.row.key.vertex_of == row.b;
  return {static_cast<std::int64_t>(row.a * components + row.b),
          (of_b ? more_than_vertices : 0) + row.row.key.vertex};
}

// Parameter of a point on a polygon whose vertices are equidistant in the shape's.
double parameter(const Polygon& polygon, Index vertex) {
  return 2.0 * std::numbers::pi * static_cast<double>(vertex) / static_cast<double>(polygon.size());
}

// By which derivative the loop linearises gaps: the exact one converges fast; that of the forces makes
// its linear problems symmetric, hence solvable, however far a step goes astray.
enum class Linearisation { exact, symmetric };

// Geometry of a stage as the loop asks for it; remembers all rows that it has returned.
class StageRows {
 public:
  using Concerns = std::function<bool(std::size_t a, std::size_t b)>;

  // What does not concern contact is left out.
  StageRows(const ContactStage& stage, const References& references, const ContactShapes& shapes,
            const ContactRules& rules, const Separation& kept, Concerns concerns)
      : stage_(stage),
        references_(references),
        shapes_(shapes),
        rules_(rules),
        kept_(kept),
        concerns_(std::move(concerns)) {}

  // By the exact derivative, or else by that of the forces.
  ContactResult resolved(const ContactStep& step) {
    const ContactResult first = resolved(step, Linearisation::exact);
    if (first.status == ContactStatus::resolved) return first;
    ContactResult second = resolved(step, Linearisation::symmetric);
    second.iterations += first.iterations;
    return second;
  }

  const LoopRow& seen(const ContactKey& key) const { return seen_.at(key); }

 private:
  ContactResult resolved(ContactStep step, Linearisation linearisation) {
    step.rows = [=, this](const VectorXd& velocity) { return rows(velocity, linearisation); };
    return resolve_contact(step);
  }

  ContactRows rows(const VectorXd& velocity, Linearisation linearisation) {
    const Interferences found =
        interferences(shapes_, paths(stage_.start, velocity, stage_.dt), rules_);
    const Configuration end = moved(stage_.start, velocity, stage_.dt);
    std::vector<LoopRow> rows;
    for (const Contact& contact : found.contacts) {
      const auto& [a, b, volume, own] = contact;
      if (!concerns_(a, b)) continue;
      if (is_violated(contact, end)) pressed_.emplace(a, b);
      // Each row costs a solve: those that merely come near have none.
      if (!pressed_.contains({a, b})) continue;
      for (const ContactRow& row : own) rows.push_back({a, b, row});
    }
    const auto m = static_cast<Index>(rows.size());
    const GapGradient none(m, velocity.size());
    ContactRows result{VectorXd(m), none, none, {}};
    for (Index i = 0; i < m; ++i) {
      LoopRow& row = rows[static_cast<std::size_t>(i)];
      const RowKey& key = row.row.key;
      // Forces act where their configuration has the closest points: those at the end of the step
      // would cost an order.
      const ClosestPoints acting = closest(key, stage_.acting);
      add(result.force_gradient, i, key, acting, stage_.acting);
      row.on_a = acting_force(acting);
      if (key.vertex_of == row.b) row.on_a.normal = -row.on_a.normal;
      const auto [gap, points] = gap_at(end, row);
      result.gap[i] = gap;
      if (linearisation == Linearisation::exact) {
        points ? add(result.gradient, i, key, *points, end)
               : add_derivative(result.gradient, i, row);
      }
      result.keys.push_back(key_of(row, shapes_.size()));
      seen_.insert_or_assign(result.keys.back(), row);
    }
    if (linearisation == Linearisation::symmetric) result.gradient = result.force_gradient;
    return result;
  }

  static void add(GapGradient& gradient, Index i, std::size_t component, const Wrench& wrench) {
    const auto first = static_cast<Index>(3 * component);
    gradient.insert(i, first) = wrench.force.real();
    gradient.insert(i, first + 1) = wrench.force.imag();
    gradient.insert(i, first + 2) = wrench.torque;
  }

  // Of the curves, with their closest points, where it is the same as that of the polygons.
  struct Gap {
    double gap;
    std::optional<ClosestPoints> points;
  };

  Gap gap_at(const Configuration& end, const LoopRow& row) const {
    const ClosestPoints points = closest(row.row.key, end);
    const double by_polygons = row.row.gap + rules_.separation.between(row.a, row.b);
    const double kept = kept_.between(row.a, row.b);
    const bool same = points.gap > 0.0 && std::abs(points.gap - by_polygons) < sags(row);
    return same ? Gap{points.gap - kept, points} : Gap{by_polygons - kept, {}};
  }

  // By the polygons, or by the curves, which come closer: a pair that is kept apart by the one
  // measure and let go by the other would jump to and fro.
  bool is_violated(const Contact& contact, const Configuration& end) const {
    return contact.is_violated() || std::ranges::any_of(contact.rows, [&](const ContactRow& own) {
             const LoopRow row{contact.a, contact.b, own};
             return own.gap < sags(row) && gap_at(end, row).gap < -rules_.tolerance;
           });
  }

  // By how much gaps of polygons and curves may differ; twice, since a vertex may lie beside the
  // closest point.
  double sags(const LoopRow& row) const {
    return 4.0 * (shapes_[row.a]->sag + shapes_[row.b]->sag);
  }

  static void add_derivative(GapGradient& gradient, Index i, const LoopRow& row) {
    add(gradient, i, row.a, row.row.derivative.on_a);
    add(gradient, i, row.b, row.row.derivative.on_b);
  }

  // Where the curves are closest, at a configuration.
  ClosestPoints closest(const RowKey& key, const Configuration& at) const {
    const SmoothCurve a = smooth_curve(*references_[key.vertex_of], at[key.vertex_of]);
    const SmoothCurve b = smooth_curve(*references_[key.polygon_of], at[key.polygon_of]);
    const double s = parameter(shapes_[key.vertex_of]->polygon, key.vertex);
    const Polygon& polygon = shapes_[key.polygon_of]->polygon;
    const Complex seen = std::polar(1.0, -b.orientation) * (a.at(s).value - b.position);
    const Index edge = polygon.closest(seen, std::numeric_limits<double>::infinity()).edge;
    return closest_points_near(a, b, s, parameter(polygon, edge));
  }

  // On the first of two curves, half way between the closest points.
  static ActingForce acting_force(const ClosestPoints& points) {
    return {0.5 * (points.point_a + points.point_b),
            (points.point_a - points.point_b) / points.gap};
  }

  // Unit forces at the closest points, that push the two apart; torques about their centres.
  static void add(GapGradient& gradient, Index i, const RowKey& key, const ClosestPoints& points,
                  const Configuration& at) {
    const ActingForce unit = acting_force(points);
    const auto wrench = [&](std::size_t k, Complex force) -> Wrench {
      return {force, cross(unit.point - at[k].position, force)};
    };
    add(gradient, i, key.vertex_of, wrench(key.vertex_of, unit.normal));
    add(gradient, i, key.polygon_of, wrench(key.polygon_of, -unit.normal));
  }

  const ContactStage& stage_;
  const References& references_;
  const ContactShapes& shapes_;
  const ContactRules& rules_;  // of the polygons
  const Separation& kept_;     // by the curves
  Concerns concerns_;
  std::set<std::pair<std::size_t, std::size_t>> pressed_;  // violated at some velocity
  std::map<ContactKey, LoopRow> seen_;
};

// Net force and torque of forces on all components, over the largest force and its distance.
std::pair<double, double> imbalance(const VectorXd& force, const Configuration& acting) {
  Complex net{};
  double torque = 0.0, largest = 0.0, farthest = 0.0;
  for (std::size_t k = 0; k < acting.size(); ++k) {
    const auto first = static_cast<Index>(3 * k);
    const Complex own(force[first], force[first + 1]);
    net += own;
    torque += force[first + 2] + cross(acting[k].position, own);
    largest = std::max(largest, std::abs(own));
    farthest = std::max(farthest, std::abs(acting[k].position));
  }
  if (largest == 0.0) return {0.0, 0.0};
  return {std::abs(net) / largest, std::abs(torque) / (largest * std::max(farthest, 1e-300))};
}

}  // namespace

VectorXd to_numbers(const CloserPairs& pairs) {
  VectorXd numbers(static_cast<Index>(3 * pairs.size()));
  Index i = 0;
  for (const auto& [pair, gap] : pairs) {
    numbers.segment<3>(i) << static_cast<double>(pair.first), static_cast<double>(pair.second), gap;
    i += 3;
  }
  return numbers;
}

CloserPairs to_pairs(const VectorXd& numbers) {
  CloserPairs pairs;
  for (Index i = 0; i < numbers.size(); i += 3) {
    pairs[{static_cast<std::size_t>(numbers[i]), static_cast<std::size_t>(numbers[i + 1])}] =
        numbers[i + 2];
  }
  return pairs;
}

SuspensionContact::SuspensionContact(const SuspensionSolver& solver)
    : solver_(solver),
      separation_(separation_of(solver)),
      shapes_(shapes_of(solver.references(), relative_sag * separation_)) {
  double sag = 0.0;
  for (const auto& shape : shapes_) sag = std::max(sag, shape->sag);
  polygon_separation_ = separation_ + 2.0 * sag;
}

bool SuspensionContact::is_free(std::size_t component) const {
  return solver_.references()[component]->kind == ComponentKind::free_body;
}

// Of pairs that can be moved apart, and of overlaps.
std::vector<PolygonGap> SuspensionContact::gaps(const Configuration& configuration) const {
  std::vector<PolygonGap> gaps =
      polygon_gaps(shapes_, poses_of(configuration), polygon_separation_);
  std::erase_if(gaps, [this](const PolygonGap& found) {
    return found.gap > 0.0 && !is_free(found.a) && !is_free(found.b);
  });
  return gaps;
}

double SuspensionContact::curve_gap(const PolygonGap& found,
                                    const Configuration& configuration) const {
  const auto curve = [&](std::size_t k) {
    return smooth_curve(*solver_.references()[k], configuration[k]);
  };
  return closest_points(curve(found.a), curve(found.b)).gap;
}

ContactParty SuspensionContact::party(std::size_t component) const {
  const std::size_t bodies = solver_.scene().bodies.size();
  return component < bodies ? ContactParty{false, component}
                            : ContactParty{true, component - bodies};
}

ContactRules SuspensionContact::rules(const CloserPairs& closer) const {
  return {{polygon_separation_, closer}, relative_tolerance * separation_};
}

CloserPairs SuspensionContact::admit_start(const Configuration& configuration) const {
  const Scene& scene = solver_.scene();
  std::string overlaps, narrow;
  CloserPairs closer;
  for (const PolygonGap& found : gaps(configuration)) {
    const std::string pair =
        component_name(scene, found.a) + " and " + component_name(scene, found.b);
    const auto add = [&](std::string& list, const std::string& text) {
      list += (list.empty() ? "" : ", ") + pair + text;
    };
    if (found.gap <= 0.0) {
      add(overlaps, " by " + short_number(-found.gap));
    } else {
      closer[{found.a, found.b}] = curve_gap(found, configuration);
      // A gap of just the separation is wide enough, though polygons keep a little more.
      if (found.gap < (1.0 - relative_sag) * separation_) {
        add(narrow, " are " + short_number(found.gap) + " apart");
      }
    }
  }
  if (!overlaps.empty()) throw ConfigurationRefused("bodies overlap at the start: " + overlaps);
  if (!narrow.empty() && !scene.contact->allow_close) {
    throw ConfigurationRefused("pairs are closer at the start than contact.minimum_separation = " +
                               short_number(separation_) + ": " + narrow +
                               "; set contact.allow_close = true, or move them");
  }
  return closer;
}

CloserPairs SuspensionContact::widened(const CloserPairs& closer,
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

bool SuspensionContact::admits(const Configuration& configuration,
                               const CloserPairs& closer) const {
  const Separation kept{separation_, closer};
  return std::ranges::all_of(gaps(configuration), [&](const PolygonGap& found) {
    if (found.gap <= 0.0) return false;
    // Twice the tolerance to which the loop resolves gaps: it found these curves' closest points from
    // elsewhere.
    return curve_gap(found, configuration) >=
           kept.between(found.a, found.b) - 2.0 * relative_tolerance * separation_;
  });
}

double SuspensionContact::relative_displacement(const Configuration& start,
                                                const VectorXd& velocity, double dt) const {
  const std::vector<RigidPath> paths = stokesbook::paths(start, velocity, dt);
  double largest = 0.0;
  for (const Contact& contact : interferences(shapes_, paths, rules({})).contacts) {
    const std::size_t a = contact.a, b = contact.b;
    if (!is_free(a) && !is_free(b)) continue;
    const double way = RelativePath(paths[a], paths[b]).speed_bound(shapes_[a]->radius);
    const double width =
        std::min(area_over_perimeter(*shapes_[a]), area_over_perimeter(*shapes_[b]));
    largest = std::max(largest, way / width);
  }
  return largest;
}

ContactOutcome SuspensionContact::resolve(const ContactStage& stage, LoadResponse& response,
                                          const CloserPairs& closer) const {
  const auto begun = std::chrono::steady_clock::now();
  const ContactRules rules = this->rules(closer);
  const Separation kept{separation_, closer};
  StageRows rows(stage, solver_.references(), shapes_, rules, kept,
                 [this](std::size_t a, std::size_t b) { return is_free(a) || is_free(b); });
  const ContactStep step{
      .free_velocity = stage.free_velocity,
      .dt = stage.dt,
      .separation = separation_,
      .tolerance = rules.tolerance,
      .rows = {},
      .respond = [&](const Eigen::SparseMatrix<double>& forces) -> Eigen::MatrixXd {
        return stage.share * response(forces);
      },
      .refine = [&](const VectorXd& multipliers) { return response.refine(multipliers); }};
  ContactOutcome outcome{};
  do {
    outcome.result = rows.resolved(step);
  } while (outcome.result.status != ContactStatus::resolved && response.tighten());
  const ContactResult& result = outcome.result;
  for (std::size_t i = 0; i < result.keys.size(); ++i) {
    const double force = result.multipliers[static_cast<Index>(i)];
    if (force <= 0.0) continue;
    const LoopRow& row = rows.seen(result.keys[i]);
    outcome.forces.push_back({party(row.a), party(row.b), row.on_a.point, row.on_a.normal, force,
                              kept.between(row.a, row.b) + result.gaps[static_cast<Index>(i)]});
  }
  std::tie(outcome.force_imbalance, outcome.torque_imbalance) =
      imbalance(result.force, stage.acting);
  outcome.kkt_residual = result.kkt_residual / separation_;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
  outcome.seconds = passed.count();
  return outcome;
}

Solution SuspensionContact::with_forces(Solution free, const ContactOutcome& outcome,
                                        const LoadResponse& response) const {
  if (outcome.forces.empty()) return free;
  const LoadSolution added = response.combined(outcome.result.multipliers);
  free.density += added.density;
  free.uniform_velocity += added.completion.uniform_velocity;
  for (std::size_t k = 0; k < free.motions.size(); ++k) {
    free.loads[k].force += added.completion.loads[k].force;
    free.loads[k].torque += added.completion.loads[k].torque;
    free.motions[k].velocity += added.completion.motions[k].velocity;
    free.motions[k].omega += added.completion.motions[k].omega;
  }
  return free;
}

}  // namespace stokesbook
