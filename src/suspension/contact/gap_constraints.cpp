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

ContactKey key_of(const GapConstraint& row, std::size_t components) {
  constexpr std::int64_t more_than_vertices = std::int64_t{1} << 32;
  const bool of_b = row.row.key.vertex_of == row.b;
  return {static_cast<std::int64_t>(row.a * components + row.b),
          (of_b ? more_than_vertices : 0) + row.row.key.vertex};
}

// The parameter of a vertex. Vertices are equidistant in the parameter of the shape.
double parameter(const Polygon& polygon, Index vertex) {
  return 2.0 * std::numbers::pi * static_cast<double>(vertex) / static_cast<double>(polygon.size());
}

Index nearest_vertex(const Polygon& polygon, double parameter) {
  const double turns = parameter / (2.0 * std::numbers::pi);
  const Index vertex =
      std::lround((turns - std::floor(turns)) * static_cast<double>(polygon.size()));
  return vertex % polygon.size();
}

void add(GapGradient& gradient, Index i, std::size_t component, const Wrench& wrench) {
  const auto first = static_cast<Index>(3 * component);
  gradient.insert(i, first) = wrench.force.real();
  gradient.insert(i, first + 1) = wrench.force.imag();
  gradient.insert(i, first + 2) = wrench.torque;
}

Complex middle(const ClosestPoints& points) {
  return 0.5 * (points.point_a + points.point_b);
}

// The force on the first of two curves acts half way between the closest points.
ActingForce acting_force(const ClosestPoints& points) {
  return {middle(points), (points.point_a - points.point_b) / points.gap};
}

// Adds the row of unit forces that push two components apart at their closest points, with the
// torques about the components' positions.
void add(GapGradient& gradient, Index i, const RowKey& key, const ClosestPoints& points,
         const Configuration& at) {
  const ActingForce unit = acting_force(points);
  const auto wrench = [&](std::size_t k, Complex force) -> Wrench {
    return {force, cross(unit.point - at[k].position, force)};
  };
  add(gradient, i, key.vertex_of, wrench(key.vertex_of, unit.normal));
  add(gradient, i, key.polygon_of, wrench(key.polygon_of, -unit.normal));
}

}  // namespace

std::vector<RigidPath> straight_paths(const Configuration& start, const VectorXd& velocity,
                                      double dt) {
  std::vector<RigidPath> paths;
  for (std::size_t k = 0; k < start.size(); ++k) {
    const auto first = static_cast<Index>(3 * k);
    const Complex displacement = dt * Complex(velocity[first], velocity[first + 1]);
    paths.push_back({start[k], displacement, dt * velocity[first + 2]});
  }
  return paths;
}

GapConstraints::GapConstraints(const ContactStage& stage, const Discretisation& discretisation,
                               const ContactShapes& shapes, const ConstraintRules& rules)
    : stage_(stage), discretisation_(discretisation), shapes_(shapes), rules_(rules) {}

ContactResult GapConstraints::resolved(const ContactStep& step) {
  const ContactResult first = resolved(step, Linearisation::exact, stage_.most_iterations);
  const int left = stage_.most_iterations - first.iterations;
  if (first.status == ContactStatus::resolved || left <= 0) return first;
  ContactResult second = resolved(step, Linearisation::symmetric, left);
  second.iterations += first.iterations;
  return second;
}

ContactResult GapConstraints::resolved(ContactStep step, Linearisation linearisation,
                                       int most_iterations) {
  step.rows = [=, this](const VectorXd& velocity) { return rows(velocity, linearisation); };
  ContactLoopOptions options;
  options.max_iterations = std::min(options.max_iterations, most_iterations);
  return resolve_contact(step, options);
}

// Each constraint costs a solve: only pairs that are violated at some velocity have constraints.
std::vector<GapConstraint> GapConstraints::pressed_rows(const VectorXd& velocity,
                                                        const Configuration& end) {
  const Interferences found =
      interferences(shapes_, straight_paths(stage_.start, velocity, stage_.dt), rules_.polygons);
  std::map<ComponentPair, std::vector<GapConstraint>> near;
  for (const Contact& contact : found.contacts) {
    const std::size_t a = contact.a, b = contact.b;
    if (!rules_.concerns(a, b)) continue;
    if (contact.is_violated()) pressed_.emplace(a, b);
    for (const ContactRow& row : contact.rows) near[{a, b}].push_back({a, b, row});
  }
  std::vector<GapConstraint> pressed;
  for (auto& [pair, rows] : near) {
    const auto is_close = [this](const GapConstraint& row) { return row.row.gap < sags(row); };
    if (!pressed_.contains(pair) && std::ranges::none_of(rows, is_close)) continue;
    for (GapConstraint& row : rows) measure(row, end);
    if (!is_violated(rows)) look_for_missed(rows, end);
    add_former(rows, end);
    if (is_violated(rows)) pressed_.insert(pair);
    if (!pressed_.contains(pair)) continue;
    places_[pair].clear();
    for (const GapConstraint& row : rows) places_[pair].push_back(row.row.key);
    std::ranges::move(rows, std::back_inserter(pressed));
  }
  return pressed;
}

// A pair may have two local minima of the gap whose difference is below the sag of the polygons;
// the polygons then report only one of them. If the curves are still too close although every
// reported gap is open, the other minimum is constrained as well.
void GapConstraints::look_for_missed(const std::vector<GapConstraint>& rows,
                                     const Configuration& end) {
  RowKey key = rows.front().row.key;
  const ClosestPoints least = closest_points(curve(key.vertex_of, end), curve(key.polygon_of, end));
  const double kept = rules_.curves.between(key.vertex_of, key.polygon_of);
  if (least.gap <= 0.0 || least.gap - kept >= -rules_.polygons.tolerance) return;
  key.vertex = nearest_vertex(shapes_[key.vertex_of]->polygon, least.parameter_a);
  places_[{rows.front().a, rows.front().b}].push_back(key);
}

// A pair keeps the constraints that it had, as long as the curves have a minimum of the gap there.
void GapConstraints::add_former(std::vector<GapConstraint>& rows, const Configuration& end) const {
  const auto places = places_.find({rows.front().a, rows.front().b});
  if (places == places_.end()) return;
  for (const RowKey& key : places->second) {
    // Its polygon gap is taken to be that of the deepest constraint.
    GapConstraint row =
        *std::ranges::min_element(rows, {}, [](const GapConstraint& own) { return own.row.gap; });
    row.row.key = key;
    measure(row, end);
    const auto is_there = [&](const GapConstraint& other) {
      return other.points && std::abs(middle(*row.points) - middle(*other.points)) < sags(row);
    };
    if (row.points && std::ranges::none_of(rows, is_there)) rows.push_back(row);
  }
}

ContactRows GapConstraints::rows(const VectorXd& velocity, Linearisation linearisation) {
  const Configuration end = to_configuration(to_state(stage_.start) + stage_.dt * velocity);
  std::vector<GapConstraint> rows = pressed_rows(velocity, end);
  const auto m = static_cast<Index>(rows.size());
  const GapGradient none(m, velocity.size());
  ContactRows result{VectorXd(m), none, none, {}};
  for (Index i = 0; i < m; ++i) {
    GapConstraint& row = rows[static_cast<std::size_t>(i)];
    const RowKey& key = row.row.key;
    const ClosestPoints acting = closest(key, stage_.acting);
    add(result.force_gradient, i, key, acting, stage_.acting);
    row.on_a = acting_force(acting);
    if (key.vertex_of == row.b) row.on_a.normal = -row.on_a.normal;
    result.gap[i] = row.gap;
    if (linearisation == Linearisation::exact && row.points) {
      add(result.gradient, i, key, *row.points, end);
    } else if (linearisation == Linearisation::exact) {
      add(result.gradient, i, row.a, row.row.derivative.on_a);
      add(result.gradient, i, row.b, row.row.derivative.on_b);
    }
    result.keys.push_back(key_of(row, shapes_.size()));
    seen_.insert_or_assign(result.keys.back(), row);
  }
  if (linearisation == Linearisation::symmetric) result.gradient = result.force_gradient;
  return result;
}

// Measures a gap by the curves if it agrees with the gap of the polygons; else by the polygons.
void GapConstraints::measure(GapConstraint& row, const Configuration& end) const {
  const ClosestPoints points = closest(row.row.key, end);
  const double by_polygons = row.row.gap + rules_.polygons.separation.between(row.a, row.b);
  const double kept = rules_.curves.between(row.a, row.b);
  const bool same = points.gap > 0.0 && std::abs(points.gap - by_polygons) < sags(row);
  row.gap = (same ? points.gap : by_polygons) - kept;
  row.points = same ? std::optional(points) : std::nullopt;
}

bool GapConstraints::is_violated(const std::vector<GapConstraint>& rows) const {
  return std::ranges::any_of(
      rows, [this](const GapConstraint& row) { return row.gap < -rules_.polygons.tolerance; });
}

// The largest difference between a gap of polygons and of curves: twice the sags, since a vertex
// may lie beside the closest point; and twice that for safety.
double GapConstraints::sags(const GapConstraint& row) const {
  return 4.0 * (shapes_[row.a]->sag + shapes_[row.b]->sag);
}

SmoothCurve GapConstraints::curve(std::size_t component, const Configuration& at) const {
  return smooth_curve(*discretisation_[component], at[component]);
}

// The local closest points of the curves at a configuration.
ClosestPoints GapConstraints::closest(const RowKey& key, const Configuration& at) const {
  const SmoothCurve a = curve(key.vertex_of, at), b = curve(key.polygon_of, at);
  const double s = parameter(shapes_[key.vertex_of]->polygon, key.vertex);
  const Polygon& polygon = shapes_[key.polygon_of]->polygon;
  const Complex seen = std::polar(1.0, -b.orientation) * (a.at(s).value - b.position);
  const Index edge = polygon.closest(seen, std::numeric_limits<double>::infinity()).edge;
  return closest_points_near(a, b, s, parameter(polygon, edge));
}

}  // namespace stokesbook
