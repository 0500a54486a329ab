// Evaluates velocity, pressure, vorticity, stress (07.1) and dissipation on a grid, and estimates
// their errors by a solution on more nodes (chapter 12, section "How fine").
#include "suspension/solver/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "stress/stress.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/field_grid.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/solver/fluid_mask.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

std::vector<Index> fluid_indices(const std::vector<std::uint8_t>& in_fluid) {
  std::vector<Index> indices;
  for (std::size_t i = 0; i < in_fluid.size(); ++i) {
    if (in_fluid[i] == 1) indices.push_back(static_cast<Index>(i));
  }
  return indices;
}

// Returns the mean pressure on the outer wall, divided by the viscosity; zero if there is no outer
// wall.
double pressure_datum(const SuspensionSolver& solver, const Solution& solution) {
  const Configuration& configuration = solution.instant.configuration;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const DiscretisedShape& discretised = *solution.discretisation[k];
    if (discretised.kind != ComponentKind::enclosing_wall) continue;
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

// Safety factor: if both solutions are resolved, the solution on more nodes is far more accurate;
// if they are not, it has an error, too.
constexpr double safety_of_fields = 2.0;

FieldErrors errors_of(const Field& coarse, const Field& fine) {
  FieldErrors errors = field_differences(coarse, fine);
  for (auto& [quantity, error] : errors) error *= safety_of_fields;
  return errors;
}

FieldErrors unknown_errors(const Field& field) {
  FieldErrors errors = field_differences(field, field);
  for (auto& [quantity, error] : errors) error = std::numeric_limits<double>::infinity();
  return errors;
}

// Largest number of refinements, by a quarter each: to nearly four times as many nodes.
constexpr int most_raised = 6;

}  // namespace

Field evaluate_field(const SuspensionSolver& solver, const Solution& solution) {
  if (!solver.scene().output.fields) {
    throw std::invalid_argument("evaluate_field: the scene requests no fields (output.fields)");
  }
  const FieldSettings& settings = *solver.scene().output.fields;
  const auto asked = [&](FieldQuantity quantity) {
    return std::ranges::count(settings.quantities, quantity) > 0;
  };
  Field field;
  field.grid = field_grid(settings);
  const ComplexVector all = field.grid.points();
  field.in_fluid = in_fluid(solution.instant.configuration, solver.discretisation(), all);
  const std::vector<Index> fluid = fluid_indices(field.in_fluid);
  const ComplexVector points = all(fluid);
  if (asked(FieldQuantity::velocity)) {
    field.velocity = ComplexVector::Constant(all.size(), {nowhere, nowhere});
    field.velocity(fluid) = solver.velocity(solution, points);
  }
  if (settings.quantities == std::vector{FieldQuantity::velocity}) return field;
  const std::vector<FlowDerivatives> flow = solver.derivatives(solution, points);
  const double mu = solver.scene().viscosity;
  const auto fill = [&](FieldQuantity quantity, Eigen::VectorXd& values, const auto& value_of) {
    if (!asked(quantity)) return;
    values = Eigen::VectorXd::Constant(all.size(), nowhere);
    for (std::size_t i = 0; i < fluid.size(); ++i) values[fluid[i]] = value_of(flow[i]);
  };
  if (asked(FieldQuantity::pressure)) {
    const double datum = pressure_datum(solver, solution);
    fill(FieldQuantity::pressure, field.pressure,
         [&](const FlowDerivatives& at) { return mu * (at.pressure - datum); });
  }
  fill(FieldQuantity::vorticity, field.vorticity,
       [](const FlowDerivatives& at) { return at.vorticity; });
  fill(FieldQuantity::shear_stress, field.shear_stress,
       [&](const FlowDerivatives& at) { return stress(at, mu).s12; });
  fill(FieldQuantity::dissipation, field.dissipation,
       [&](const FlowDerivatives& at) { return dissipation_density(at, mu); });
  return field;
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
  EstimatedField found{evaluate_field(solver, solution), {}};
  bool may_raise = false;
  for (std::size_t k = 0; k < solution.discretisation.size(); ++k) {
    may_raise = may_raise || component_of(solver.scene(), k).has_automatic_nodes();
  }
  Solution latest = solution;
  while (true) {
    try {
      latest = solver.refined(latest);
    } catch (const SolverError&) {
      if (found.solves == 0) found.errors = unknown_errors(found.field);
      return found;
    }
    ++found.solves;
    found.cost += {latest.gmres.iterations, latest.gmres.applications};
    Field finer = evaluate_field(solver, latest);
    found.errors = errors_of(found.field, finer);
    if (!may_raise) return found;
    found.field = std::move(finer);
    const bool met = std::ranges::all_of(found.errors, [&](const auto& error) {
      return error.second <= solver.scene().solver.tolerance;
    });
    if (met || found.solves == most_raised) return found;
  }
}

}  // namespace stokesbook
