// Evaluates the gap functions of a stage and their Jacobian: the polygons of chapter 10 find the
// pairs in contact, the smooth curves measure their gaps (chapters 10 to 12).
#include "suspension/contact/gap_constraints.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/gaps.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// The lowest 12 bits of both numbers of an index tell the images apart that are near at one time.
ContactKey contact_key(const GapConstraint& constraint, std::size_t components) {
  constexpr std::int64_t more_than_vertices = std::int64_t{1} << 32, indices = 1 << 12;
  const auto& [a, b, image] = constraint.pair;
  const auto pair = static_cast<std::int64_t>(a * components + b);
  const auto last_bits = [](std::int64_t number) { return number & (indices - 1); };
  return {(pair * indices + last_bits(image.first)) * indices + last_bits(image.second),
          (constraint.nearest.of_b ? more_than_vertices : 0) + constraint.nearest.vertex};
}

// Vertices are equidistant in the parameter of the shape.
double parameter(const Polygon& polygon, Index vertex) {
  return 2.0 * std::numbers::pi * static_cast<double>(vertex) / static_cast<double>(polygon.size());
}

Index nearest_vertex(const Polygon& polygon, double parameter) {
  const double turns = parameter / (2.0 * std::numbers::pi);
  const Index vertex =
      std::lround((turns - std::floor(turns)) * static_cast<double>(polygon.size()));
  return vertex % polygon.size();
}

// A component that touches its own image has both wrenches in the same entries.
void insert_row(GapGradient& gradient, Index i, const ContactPair& pair, const PairWrench& row) {
  for (const bool is_a : {true, false}) {
    const Wrench& wrench = is_a ? row.on_a : row.on_b;
    const auto first = static_cast<Index>(3 * (is_a ? pair.a : pair.b));
    gradient.coeffRef(i, first) += wrench.force.real();
    gradient.coeffRef(i, first + 1) += wrench.force.imag();
    gradient.coeffRef(i, first + 2) += wrench.torque;
  }
}

Complex middle(const ClosestPoints& points) {
  return 0.5 * (points.point_a + points.point_b);
}

// The force acts half way between the closest points.
UnitForce unit_force_on_a(const GapConstraint& constraint, const ClosestPoints& points) {
  const Complex on_vertex = (points.point_a - points.point_b) / points.gap;
  return {middle(points), constraint.nearest.of_b ? -on_vertex : on_vertex};
}

// A component, or an image of it.
struct PosedComponent {
  std::size_t component;
  Pose pose;
};

// Returns the two components of a constraint, first the one with the vertex.
std::pair<PosedComponent, PosedComponent> posed_pair(const GapConstraint& constraint,
                                                     const Placement& at) {
  const auto& [a, b, image] = constraint.pair;
  const PosedComponent posed_a{a, at.paths[a]}, posed_b{b, at.image(b, image)};
  return constraint.nearest.of_b ? std::pair(posed_b, posed_a) : std::pair(posed_a, posed_b);
}

// Returns unit forces that push two components apart, with the torques about their positions.
PairWrench unit_wrenches(const ContactPair& pair, const UnitForce& on_a, const Placement& at) {
  const auto wrench = [&](const Pose& pose, Complex force) {
    return Wrench{force, cross(on_a.point - pose.position, force)};
  };
  return {wrench(at.paths[pair.a], on_a.normal),
          wrench(at.image(pair.b, pair.image), -on_a.normal)};
}

}  // namespace

ContactShapes contact_shapes(const Discretisation& discretisation, double sag_limit) {
  ContactShapes shapes;
  for (const auto& discretised : discretisation) {
    const auto is_equal = [&](const std::shared_ptr<const DiscretisedShape>& earlier) {
      return earlier->shape == discretised->shape && earlier->curve.side == discretised->curve.side;
    };
    const auto known = static_cast<std::size_t>(std::ranges::find_if(discretisation, is_equal) -
                                                discretisation.begin());
    shapes.push_back(known < shapes.size()
                         ? shapes[known]
                         : std::make_shared<const ContactShape>(contact_shape(
                               discretised->shape, discretised->curve.side, sag_limit)));
  }
  return shapes;
}

std::vector<RigidPath> straight_paths(const Configuration& start, const VectorXd& velocity,
                                      double dt) {
  const Configuration motion = to_configuration(dt * velocity);
  std::vector<RigidPath> paths;
  for (std::size_t k = 0; k < start.size(); ++k) {
    paths.push_back({start[k], motion[k].position, motion[k].orientation});
  }
  return paths;
}

bool is_movable_pair(const Discretisation& discretisation, std::size_t a, std::size_t b) {
  return discretisation[a]->kind == ComponentKind::free_body ||
         discretisation[b]->kind == ComponentKind::free_body;
}

double ConstraintRules::between(const ContactPair& pair, double everywhere) const {
  const auto own = closer.find(pair);
  return own == closer.end() ? everywhere : std::min(everywhere, own->second);
}

Interferences ConstraintRules::find(const PathImages& images) const {
  return interferences(images.shapes, images.paths,
                       {{polygons, images.numbered(closer)}, tolerance});
}

GapConstraints::GapConstraints(const ContactStage& stage, const Discretisation& discretisation,
                               const ContactShapes& shapes, const ConstraintRules& rules)
    : stage_(stage), discretisation_(discretisation), shapes_(shapes), rules_(rules) {}

ContactResult GapConstraints::resolve(ContactStep step) {
  const auto run_loop = [&](int most_iterations) {
    ContactLoopOptions options;
    options.max_iterations = std::min(options.max_iterations, most_iterations);
    return resolve_contact(step, options);
  };
  step.rows = [this](const VectorXd& velocity) { return rows(velocity); };
  const ContactResult first = run_loop(stage_.most_iterations);
  const int left = stage_.most_iterations - first.iterations;
  if (first.status == ContactStatus::resolved || left <= 0) return first;
  step.rows = [this](const VectorXd& velocity) {
    ContactRows symmetric = rows(velocity);
    symmetric.gradient = symmetric.force_gradient;
    return symmetric;
  };
  ContactResult second = run_loop(left);
  second.iterations += first.iterations;
  return second;
}

ContactRows GapConstraints::rows(const VectorXd& velocity) {
  const Placement end{to_configuration(to_state(stage_.start.paths) + stage_.dt * velocity),
                      stage_.end_lattice};
  std::vector<GapConstraint> active = active_constraints(velocity, end);
  const auto m = static_cast<Index>(active.size());
  const GapGradient none(m, velocity.size());
  ContactRows result{VectorXd(m), none, none, {}, VectorXd::Zero(m)};
  const auto lattice = lattice_step(stage_.start.lattice, stage_.end_lattice);
  for (Index i = 0; i < m; ++i) {
    GapConstraint& constraint = active[static_cast<std::size_t>(i)];
    const ContactPair& pair = constraint.pair;
    constraint.force_on_a = unit_force_on_a(constraint, closest(constraint, stage_.acting));
    insert_row(result.force_gradient, i, pair,
               unit_wrenches(pair, constraint.force_on_a, stage_.acting));
    const PairWrench derivative =
        constraint.points
            ? unit_wrenches(pair, unit_force_on_a(constraint, *constraint.points), end)
            : constraint.row.derivative;
    insert_row(result.gradient, i, pair, derivative);
    result.gap[i] = constraint.gap;
    if (lattice) result.at_rest[i] = dot(derivative.on_b.force, lattice->displacement(pair.image));
    result.keys.push_back(contact_key(constraint, shapes_.size()));
    constraints_.insert_or_assign(result.keys.back(), constraint);
  }
  return result;
}

// Each constraint costs a solve: only pairs that are violated at some velocity have constraints.
std::vector<GapConstraint> GapConstraints::active_constraints(const VectorXd& velocity,
                                                              const Placement& end) {
  const PathImages images = path_images(
      shapes_, straight_paths(stage_.start.paths, velocity, stage_.dt),
      lattice_step(stage_.start.lattice, stage_.end_lattice), listed_separations * rules_.polygons);
  std::map<ContactPair, std::vector<GapConstraint>> near;
  for (const Contact& contact : rules_.find(images).contacts) {
    const std::optional<ContactPair> pair = images.pair(contact.a, contact.b);
    if (!pair || !is_movable_pair(discretisation_, pair->a, pair->b)) continue;
    for (const ContactRow& row : contact.rows) {
      near[*pair].push_back({*pair, {row.key.vertex_of == contact.b, row.key.vertex}, row});
    }
  }
  std::vector<GapConstraint> active;
  for (auto& [pair, constraints] : near) {
    const auto is_close = [this](const GapConstraint& constraint) {
      return constraint.row.gap < polygon_error(constraint);
    };
    if (!active_.contains(pair) && std::ranges::none_of(constraints, is_close)) continue;
    for (GapConstraint& constraint : constraints) measure(constraint, end);
    if (!is_violated(constraints)) find_missed_minimum(constraints.front(), end);
    add_earlier(constraints, end);
    if (is_violated(constraints)) active_.insert(pair);
    if (!active_.contains(pair)) continue;
    std::vector<PairVertex>& vertices = vertices_[pair];
    vertices.clear();
    for (const GapConstraint& constraint : constraints) vertices.push_back(constraint.nearest);
    std::ranges::move(constraints, std::back_inserter(active));
  }
  return active;
}

// A pair may have two local minima of the gap whose difference is below the sag of the polygons;
// the polygons then report only one of them. If the curves are still too close although every
// reported gap is open, the other minimum is constrained as well.
void GapConstraints::find_missed_minimum(const GapConstraint& reported, const Placement& end) {
  const auto [with_vertex, other] = posed_pair(reported, end);
  const ClosestPoints least = closest_points(curve(with_vertex.component, with_vertex.pose),
                                             curve(other.component, other.pose));
  const double kept = rules_.between(reported.pair, rules_.curves);
  if (least.gap <= 0.0 || least.gap - kept >= -rules_.tolerance) return;
  const Polygon& polygon = shapes_[with_vertex.component]->polygon;
  const Index vertex = nearest_vertex(polygon, least.parameter_a);
  vertices_[reported.pair].push_back({reported.nearest.of_b, vertex});
}

// A pair keeps the constraints that it had, as long as the curves have a minimum of the gap there.
void GapConstraints::add_earlier(std::vector<GapConstraint>& constraints,
                                 const Placement& end) const {
  const auto vertices = vertices_.find(constraints.front().pair);
  if (vertices == vertices_.end()) return;
  for (const PairVertex& vertex : vertices->second) {
    // The polygon gap of an earlier constraint is taken to be that of the deepest constraint.
    GapConstraint earlier = *std::ranges::min_element(
        constraints, {}, [](const GapConstraint& present) { return present.row.gap; });
    earlier.nearest = vertex;
    measure(earlier, end);
    const auto is_there = [&](const GapConstraint& other) {
      return other.points &&
             std::abs(middle(*earlier.points) - middle(*other.points)) < polygon_error(earlier);
    };
    if (earlier.points && std::ranges::none_of(constraints, is_there)) {
      constraints.push_back(earlier);
    }
  }
}

// Measures a gap by the curves if it agrees with the gap of the polygons; else by the polygons.
void GapConstraints::measure(GapConstraint& constraint, const Placement& end) const {
  const ClosestPoints points = closest(constraint, end);
  const double by_polygons = constraint.row.gap + rules_.between(constraint.pair, rules_.polygons);
  const double kept = rules_.between(constraint.pair, rules_.curves);
  const bool same =
      points.gap > 0.0 && std::abs(points.gap - by_polygons) < polygon_error(constraint);
  constraint.gap = (same ? points.gap : by_polygons) - kept;
  constraint.points = same ? std::optional(points) : std::nullopt;
}

bool GapConstraints::is_violated(const std::vector<GapConstraint>& constraints) const {
  return std::ranges::any_of(constraints, [this](const GapConstraint& constraint) {
    return constraint.gap < -rules_.tolerance;
  });
}

// Bounds the difference between a gap of polygons and of curves: twice the sags, since a vertex may
// lie beside the closest point; and twice that for safety.
double GapConstraints::polygon_error(const GapConstraint& constraint) const {
  return 4.0 * (shapes_[constraint.pair.a]->sag + shapes_[constraint.pair.b]->sag);
}

// Finds the closest points of the curves near a vertex.
ClosestPoints GapConstraints::closest(const GapConstraint& constraint, const Placement& at) const {
  const auto [with_vertex, other] = posed_pair(constraint, at);
  const SmoothCurve a = curve(with_vertex.component, with_vertex.pose),
                    b = curve(other.component, other.pose);
  const double s = parameter(shapes_[with_vertex.component]->polygon, constraint.nearest.vertex);
  const Polygon& polygon = shapes_[other.component]->polygon;
  const Complex in_frame_of_b = std::polar(1.0, -b.orientation) * (a.at(s).value - b.position);
  const Index edge = polygon.closest(in_frame_of_b, std::numeric_limits<double>::infinity()).edge;
  return closest_points_near(a, b, s, parameter(polygon, edge));
}

SmoothCurve GapConstraints::curve(std::size_t component, const Pose& pose) const {
  return smooth_curve(*discretisation_[component], pose);
}

}  // namespace stokesbook
