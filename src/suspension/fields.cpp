#include "suspension/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "stress/stress.hpp"
#include "suspension/side_test.hpp"

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

// Mean pressure over the viscosity on the outer wall; zero without one.
double pressure_datum(const SuspensionSolver& solver, const Configuration& configuration,
                      const Solution& solution, double drive) {
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Reference& reference = *solution.references[k];
    if (reference.kind != ComponentKind::enclosing_wall) continue;
    const auto [position, orientation] = configuration[k];
    const Curve wall = place(reference.curve, position, orientation);
    const std::vector<FlowDerivatives> flow =
        solver.derivatives(configuration, solution, wall.x, drive);
    const Eigen::VectorXd w = weights(wall);
    double sum = 0.0;
    for (Index j = 0; j < w.size(); ++j) sum += w[j] * flow[static_cast<std::size_t>(j)].pressure;
    return sum / w.sum();
  }
  return 0.0;
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

Field evaluate_field(const SuspensionSolver& solver, const Configuration& configuration,
                     const Solution& solution, double drive) {
  if (!solver.scene().output.fields) {
    throw std::invalid_argument("evaluate_field: the scene asks for no fields");
  }
  const FieldSettings& settings = *solver.scene().output.fields;
  const auto asked = [&](FieldQuantity quantity) {
    return std::ranges::count(settings.quantities, quantity) > 0;
  };
  Field field;
  field.grid = field_grid(settings);
  const ComplexVector all = field.grid.points();
  field.in_fluid = in_fluid(configuration, solver.references(), all);
  const std::vector<Index> fluid = fluid_indices(field.in_fluid);
  const ComplexVector points = all(fluid);
  if (asked(FieldQuantity::velocity)) {
    field.velocity = ComplexVector::Constant(all.size(), {nowhere, nowhere});
    field.velocity(fluid) = solver.velocity(configuration, solution, points, drive);
  }
  if (settings.quantities == std::vector{FieldQuantity::velocity}) return field;
  const std::vector<FlowDerivatives> flow =
      solver.derivatives(configuration, solution, points, drive);
  const double mu = solver.scene().viscosity;
  const auto fill = [&](FieldQuantity quantity, Eigen::VectorXd& values, const auto& value_of) {
    if (!asked(quantity)) return;
    values = Eigen::VectorXd::Constant(all.size(), nowhere);
    for (std::size_t i = 0; i < fluid.size(); ++i) values[fluid[i]] = value_of(flow[i]);
  };
  if (asked(FieldQuantity::pressure)) {
    const double datum = pressure_datum(solver, configuration, solution, drive);
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

}  // namespace stokesbook
