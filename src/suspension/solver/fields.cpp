// Evaluates velocity, pressure, vorticity, stress (07.1) and dissipation at the points of a grid
// that lie in the fluid, and estimates their errors by a solution on more nodes (chapter 12,
// section "Solver"). The side of a point follows from the divisor Delta of the barycentric
// formula: the point is in the fluid if Re Delta > 1/2 (06.15). An R-tree selects the components to
// test.
#include "suspension/solver/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "near_singular/barycentric.hpp"
#include "stress/stress.hpp"
#include "stress/traction.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// The test of the side of one component, or of an image, on which a point lies.
struct SideTest {
  std::size_t component;
  Complex position, turn;
  double sign, reach;       // points farther away than the reach are not covered
  Barycentric barycentric;  // in the component's frame
  Complex shift;            // from the component to this image; else 0

  // Returns whether the component covers a point that is moved towards the fluid first.
  bool covers(Complex point, double part) const {
    const Complex arm = (1.0 - sign * part) * (point - position);
    return std::abs(arm) <= reach && !(barycentric.side(arm * turn) > 0.5);
  }
};

// Returns the mean pressure on the outer wall, divided by the viscosity; zero if there is no outer
// wall.
double pressure_datum(const SuspensionSolver& solver, const Solution& solution) {
  const Configuration& configuration = solution.instant.configuration;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const DiscretisedShape& discretised = *solution.discretisation[k];
    if (is_inner(discretised)) continue;
    const auto [position, orientation] = configuration[k];
    const Curve wall = place(discretised.curve, position, orientation);
    const std::vector<FlowDerivatives> flow = solver.derivatives(solution, wall.x);
    const Eigen::VectorXd w = weights(wall);
    double sum = 0.0;
    for (Index j = 0; j < w.size(); ++j) sum += w[j] * flow[static_cast<std::size_t>(j)].pressure;
    return sum / w.sum();
  }
  return 0.0;
}

// Returns the largest difference of two fields of one quantity, over the largest value of q.
double relative_difference(const auto& p, const auto& q) {
  double difference = 0.0, largest = 0.0;
  for (Index i = 0; i < p.size(); ++i) {
    if (std::isnan(std::abs(p[i]))) continue;  // no fluid
    difference = std::max(difference, std::abs(p[i] - q[i]));
    largest = std::max(largest, std::abs(q[i]));
  }
  return largest > 0.0 ? difference / largest : 0.0;
}

FieldErrors unknown_errors(const Field& field) {
  FieldErrors errors = field_differences(field, field);
  for (auto& [quantity, error] : errors) error = std::numeric_limits<double>::infinity();
  return errors;
}

}  // namespace

FieldGrid field_grid(const FieldSettings& settings) {
  const auto [left, bottom, right, top] = settings.box;
  const double width = right - left, height = top - bottom;
  const double spacing = std::max(width, height) / (settings.resolution - 1);
  const auto cells = [&](double side) { return std::max(1.0, std::round(side / spacing)); };
  const Complex size(cells(width), cells(height));
  const Complex centre(0.5 * (left + right), 0.5 * (bottom + top));
  return {centre - 0.5 * spacing * size, spacing, static_cast<Index>(size.real()) + 1,
          static_cast<Index>(size.imag()) + 1};
}

std::vector<std::optional<Covering>> covering_components(const Configuration& configuration,
                                                         const Discretisation& discretisation,
                                                         const ComplexVector& points, double part,
                                                         const std::optional<PeriodicCell>& cell) {
  std::vector<SideTest> enclosing, others;
  std::vector<Rectangle> rectangles;  // squares about the others
  // In a periodic cell, points are replaced by their images in the Voronoi cell about some centre.
  const Complex centre = cell ? configuration.at(0).position : Complex{};
  const auto lattice = cell ? std::optional(lattice_of(*cell)) : std::nullopt;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Curve& curve = discretisation[k]->curve;
    const auto [position, orientation] = configuration[k];
    const Complex turn = std::polar(1.0, -orientation);
    const bool encloses = curve.side == Side::fluid_inside;
    const double reach =
        encloses ? std::numeric_limits<double>::infinity() : outer_radius(curve, 0.0);
    std::vector<Complex> shifts{0.0};
    if (lattice) {
      const double farthest = lattice->circumradius();
      shifts = lattice->vectors_into_disk(position, centre, farthest + reach);
    }
    for (const Complex shift : shifts) {
      (encloses ? enclosing : others)
          .push_back({k, position + shift, turn, curve.sign(), reach, Barycentric(curve), shift});
      if (!encloses) rectangles.push_back(square_about(position + shift, reach));
    }
  }
  const RectangleIndex index(rectangles);
  std::vector<std::optional<Covering>> covering(static_cast<std::size_t>(points.size()));
#pragma omp parallel for schedule(dynamic, 256)
  for (Index i = 0; i < points.size(); ++i) {
    const Complex point = lattice ? lattice->wrap(points[i], centre) : points[i];
    const auto test = [&](const SideTest& side) {
      if (!side.covers(point, part)) return;
      covering[static_cast<std::size_t>(i)] = {side.component, side.shift + (points[i] - point)};
    };
    for (const SideTest& side : enclosing) test(side);
    for (const std::size_t k : index.meeting({point, point})) test(others[k]);
  }
  return covering;
}

std::vector<std::uint8_t> in_fluid(const Configuration& configuration,
                                   const Discretisation& discretisation,
                                   const ComplexVector& points,
                                   const std::optional<PeriodicCell>& cell) {
  std::vector<std::uint8_t> result;
  for (const auto& component :
       covering_components(configuration, discretisation, points, 0.0, cell)) {
    result.push_back(component ? 0 : 1);
  }
  return result;
}

Field evaluate_field(const SuspensionSolver& solver, const Solution& solution) {
  if (!solver.scene().output.fields) {
    throw std::invalid_argument("evaluate_field: the scene requests no fields (output.fields)");
  }
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const FieldSettings& settings = *solver.scene().output.fields;
  const auto is_requested = [&](FieldQuantity quantity) {
    return std::ranges::count(settings.quantities, quantity) > 0;
  };
  Field field;
  field.grid = field_grid(settings);
  const ComplexVector all = field.grid.points();
  const Instant& instant = solution.instant;
  field.in_fluid = in_fluid(instant.configuration, solver.discretisation(), all, instant.cell);
  std::vector<Index> fluid;
  for (Index i = 0; i < all.size(); ++i) {
    if (field.in_fluid[static_cast<std::size_t>(i)] == 1) fluid.push_back(i);
  }
  const ComplexVector points = all(fluid);
  if (is_requested(FieldQuantity::velocity)) {
    field.velocity = ComplexVector::Constant(all.size(), {nowhere, nowhere});
    field.velocity(fluid) = solver.velocity(solution, points);
  }
  if (settings.quantities == std::vector{FieldQuantity::velocity}) return field;
  const std::vector<FlowDerivatives> flow = solver.derivatives(solution, points);
  const double mu = solver.scene().viscosity;
  const double datum = is_requested(FieldQuantity::pressure) ? pressure_datum(solver, solution) : 0;
  const auto fill = [&](FieldQuantity quantity, Eigen::VectorXd& values, const auto& value_of) {
    if (!is_requested(quantity)) return;
    values = Eigen::VectorXd::Constant(all.size(), nowhere);
    for (std::size_t i = 0; i < fluid.size(); ++i) values[fluid[i]] = value_of(flow[i]);
  };
  using At = const FlowDerivatives&;
  fill(FieldQuantity::pressure, field.pressure, [&](At at) { return mu * (at.pressure - datum); });
  fill(FieldQuantity::vorticity, field.vorticity, [](At at) { return at.vorticity; });
  fill(FieldQuantity::shear_stress, field.shear_stress, [&](At at) { return stress(at, mu).s12; });
  fill(FieldQuantity::dissipation, field.dissipation,
       [&](At at) { return dissipation_density(at, mu); });
  return field;
}

std::vector<NodeValues> node_values(const SuspensionSolver& solver, const Solution& solution) {
  const StokesProblem problem = solver.problem(solution.instant, solution.discretisation);
  std::vector<FlowDerivatives> flow = solver.derivatives(solution, all_nodes(curves_of(problem)));
  const double datum = pressure_datum(solver, solution);
  for (FlowDerivatives& at_node : flow) at_node.pressure -= datum;
  const ComplexVector traction = boundary_traction(problem, flow);
  std::vector<NodeValues> values;
  const std::size_t bodies = solver.scene().bodies.size();
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const ContactParty component{k >= bodies, k >= bodies ? k - bodies : k};
    const Curve& curve = problem.components[k].curve;
    const ComplexVector normal = normals(curve);
    const Eigen::VectorXd weight = weights(curve);
    for (Index j = 0; j < curve.size(); ++j) {
      const auto node = std::ssize(values);
      values.push_back(
          {component, curve.x[j], normal[j], weight[j], traction[node], solution.density[node]});
    }
  }
  return values;
}

FieldErrors field_differences(const Field& p, const Field& q) {
  FieldErrors differences;
  const auto compare = [&](std::string_view name, const auto& a, const auto& b) {
    if (a.size() > 0) differences[std::string(name)] = relative_difference(a, b);
  };
  compare("velocity", p.velocity, q.velocity);
  for (const FieldScalar& scalar : field_scalars) {
    compare(scalar.name, p.*scalar.values, q.*scalar.values);
  }
  return differences;
}

EstimatedField estimated_field(const SuspensionSolver& solver, const Solution& solution) {
  // If both solutions are resolved, the solution on more nodes is far more accurate; if they are
  // not, it has an error, too.
  constexpr double safety = 2.0;
  // Largest number of refinements, by a quarter each: to nearly four times as many nodes.
  constexpr int most_refinements = 6;
  EstimatedField found{evaluate_field(solver, solution), {}};
  bool may_refine = false;
  for (std::size_t k = 0; k < solution.discretisation.size(); ++k) {
    may_refine = may_refine || component_of(solver.scene(), k).has_automatic_nodes();
  }
  Solution latest = solution;
  while (true) {
    try {
      latest = solver.solve_refined(latest);
    } catch (const SolverError&) {
      if (found.solves == 0) found.errors = unknown_errors(found.field);
      return found;
    }
    ++found.solves;
    found.cost += {latest.gmres.iterations, latest.gmres.applications};
    Field finer = evaluate_field(solver, latest);
    found.errors = field_differences(found.field, finer);
    for (auto& [quantity, error] : found.errors) error *= safety;
    if (!may_refine) return found;
    found.field = std::move(finer);
    const bool is_met = std::ranges::all_of(found.errors, [&](const auto& error) {
      return error.second <= solver.scene().solver.tolerance;
    });
    if (is_met || found.solves == most_refinements) return found;
  }
}

}  // namespace stokesbook
