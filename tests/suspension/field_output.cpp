// Tests fields on grids (chapter 12): the grid points, which of them lie in the fluid, and the flow
// there.

#include <array>

#include "suspension/scenes.hpp"
#include "suspension/solver/fields.hpp"

namespace stokesbook::test {

BOOST_AUTO_TEST_SUITE(field_output)

namespace {

using Eigen::Index;
using enum FieldQuantity;

Field field_of(Scene scene, const FieldSettings& settings) {
  scene.output.fields = settings;
  const Solved solved(scene);
  return evaluate_field(solved.solver, solved.solution);
}

FieldSettings everything(const std::array<double, 4>& box, int resolution) {
  return {box, resolution, {velocity, pressure, vorticity, shear_stress, dissipation}};
}

// Returns the mean pressure over the outer wall, at points between its nodes.
double mean_pressure(const Solved& solved, const Curve& wall) {
  const auto flow = solved.solver.derivatives(solved.solution, wall.x);
  const Eigen::VectorXd w = weights(wall);
  double sum = 0.0;
  for (Index j = 0; j < w.size(); ++j) sum += w[j] * flow[static_cast<std::size_t>(j)].pressure;
  return sum / w.sum();
}

}  // namespace

BOOST_AUTO_TEST_CASE(grids_cover_their_boxes) {
  const auto is = [](const FieldGrid& grid, Complex corner, double spacing, Index columns,
                     Index rows) {
    BOOST_TEST(std::abs(grid.corner - corner) < 1e-14);
    BOOST_TEST(grid.spacing == spacing, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(grid.columns == columns);
    BOOST_TEST(grid.rows == rows);
    BOOST_TEST(grid.points().size() == columns * rows);
    const Complex far =
        corner + spacing * Complex(static_cast<double>(columns - 1), static_cast<double>(rows - 1));
    BOOST_TEST(std::abs(grid.points()[columns * rows - 1] - far) < 1e-13);
  };
  is(field_grid({{-1, 2, 2, 3}, 4, {}}), {-1, 2}, 1.0, 4, 2);
  is(field_grid({{-5, -5, 5, 5}, 200, {}}), {-5, -5}, 10.0 / 199, 200, 200);
  // On the shorter side, 3.3 cells become three, which are centred; 3.6 cells become four, which
  // extend beyond the box.
  is(field_grid({{0, 0, 10, 3.3}, 11, {}}), {0, 0.15}, 1.0, 11, 4);
  is(field_grid({{0, 0, 3.6, 10}, 11, {}}), {-0.2, 0}, 1.0, 5, 11);
  is(field_grid({{0, 0, 10, 1e-3}, 2, {}}), {0, 5e-4 - 5}, 10.0, 2, 2);
}

// The points lie 1e-12 off the curves, on both sides, between the nodes.
BOOST_AUTO_TEST_CASE(the_side_test_is_exact) {
  const Scene scene = test::scene({body(Star{0.7, 0.2, 5}, 200, {1.0, 0.5}, 0.4),
                                   body(Ellipse{1.5, 0.3}, 160, {-1.2, 0.3}, 2.0),
                                   body(lopsided_curve(0.6), 128, {0.3, -1.5}, 1.0)},
                                  {}, {outer_wall(Star{4.0, 0.1, 3}, 200, {}, {0.2, 0.1}, 0.3)});
  const SuspensionSolver solver(scene);
  const Configuration configuration = solver.start().configuration;
  for (std::size_t k = 0; k < 4; ++k) {
    const SmoothCurve curve = smooth_curve(*solver.discretisation()[k], configuration[k]);
    ComplexVector inner(500), outer(500);
    for (Index i = 0; i < 500; ++i) {
      const auto jet = curve.at(0.0123 + 2.0 * std::numbers::pi * static_cast<double>(i) / 500.0);
      const Complex out = -imaginary * jet.first / std::abs(jet.first);
      inner[i] = jet.value - 1e-12 * out;
      outer[i] = jet.value + 1e-12 * out;
    }
    const bool encloses = k == 3;
    for (const std::uint8_t side : in_fluid(configuration, solver.discretisation(), inner)) {
      BOOST_TEST(side == (encloses ? 1 : 0));
    }
    for (const std::uint8_t side : in_fluid(configuration, solver.discretisation(), outer)) {
      BOOST_TEST(side == (encloses ? 0 : 1));
    }
  }
  const ComplexVector far = ComplexVector::Constant(1, 1e3);
  BOOST_TEST(in_fluid(configuration, solver.discretisation(), far)[0] == 0);
}

// Between two rotating cylinders u = A r + B / r. The grid passes close to both walls.
BOOST_AUTO_TEST_CASE(fields_between_cylinders) {
  const double inner = 1.0, outer = 2.5, w1 = 0.4, w2 = -0.7, mu = 1.3;
  Scene cell = scene({}, {},
                     {outer_wall(Circle{outer}, 128, RotatingWall{w2}),
                      inner_wall(Circle{inner}, 128, RotatingWall{w1})});
  cell.viscosity = mu;
  const Field field = field_of(cell, everything({-2.6, -2.6, 2.6, 2.6}, 90));
  const double a = (w2 * outer * outer - w1 * inner * inner) / (outer * outer - inner * inner);
  const double b = (w1 - w2) * inner * inner * outer * outer / (outer * outer - inner * inner);
  const ComplexVector points = field.grid.points();
  for (Index i = 0; i < points.size(); ++i) {
    const double r = std::abs(points[i]);
    const bool fluid = r > inner && r < outer;
    BOOST_TEST(field.in_fluid[static_cast<std::size_t>(i)] == (fluid ? 1 : 0));
    if (!fluid) {
      BOOST_TEST(std::isnan(field.velocity[i].real()));
      for (const FieldScalar& scalar : field_scalars) {
        BOOST_TEST(std::isnan((field.*scalar.values)[i]));
      }
      continue;
    }
    const Complex across = imaginary * points[i] / r;
    const double shear = -2.0 * mu * b / (r * r);  // sigma_{r phi}
    BOOST_TEST(std::abs(field.velocity[i] - (a * r + b / r) * across) < 1e-12);
    BOOST_TEST(std::abs(field.pressure[i]) < 1e-10);
    BOOST_TEST(std::abs(field.vorticity[i] - 2.0 * a) < 1e-10);
    BOOST_TEST(std::abs(field.shear_stress[i] + shear * (across * across).real()) < 1e-10);
    BOOST_TEST(std::abs(field.dissipation[i] - shear * shear / mu) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(only_what_was_asked_for) {
  const Scene one = scene({body(Circle{1}, 64, 0.0)}, ShearFlow{1});
  const auto asked = [&](const std::vector<FieldQuantity>& quantities) {
    const Field field = field_of(one, {{-2, -2, 2, 2}, 5, quantities});
    std::vector<FieldQuantity> there;
    if (field.velocity.size() > 0) there.push_back(velocity);
    if (field.pressure.size() > 0) there.push_back(pressure);
    if (field.vorticity.size() > 0) there.push_back(vorticity);
    if (field.shear_stress.size() > 0) there.push_back(shear_stress);
    if (field.dissipation.size() > 0) there.push_back(dissipation);
    return there;
  };
  using Quantities = std::vector<FieldQuantity>;
  for (const Quantities& quantities :
       {Quantities{velocity}, Quantities{pressure}, Quantities{vorticity, dissipation},
        Quantities{velocity, shear_stress}}) {
    BOOST_TEST((asked(quantities) == quantities));
  }
  const Solved solved(one);
  BOOST_CHECK_THROW(evaluate_field(solved.solver, solved.solution), std::invalid_argument);
}

// For a disk of radius a in a straining flow of rate e, the pressure is -4 mu a^2 e Re z^-2 and the
// vorticity is 4 a^2 e Im z^-2. Far away, the strain is that of the undisturbed flow.
BOOST_AUTO_TEST_CASE(fields_around_a_disk) {
  const double a = 0.8, rate = 0.7, mu = 1.3;
  Scene disk = scene({body(Circle{a}, 64, 0.0)}, ExtensionalFlow{rate});
  disk.viscosity = mu;
  const Field field = field_of(disk, everything({-60.0, 0.0, 0.0, 40.0}, 61));
  const ComplexVector points = field.grid.points();
  for (Index i = 0; i < points.size(); ++i) {
    if (field.in_fluid[static_cast<std::size_t>(i)] == 0) continue;
    const Complex inverse_square = 1.0 / (points[i] * points[i]);
    BOOST_TEST(std::abs(field.pressure[i] + 4.0 * mu * rate * a * a * inverse_square.real()) <
               1e-11);
    BOOST_TEST(std::abs(field.vorticity[i] - 4.0 * rate * a * a * inverse_square.imag()) < 1e-11);
    if (std::abs(points[i]) < 30.0) continue;
    BOOST_TEST(field.dissipation[i] == 4.0 * mu * rate * rate,
               boost::test_tools::tolerance(8.0 * a * a / std::norm(points[i])));
  }
}

// In a container, the mean pressure over the outer wall is zero for all motions of the bodies, and
// also for the reversed flow.
BOOST_AUTO_TEST_CASE(datum_of_the_pressure) {
  Scene tank = scene({body(Circle{0.5}, 96, {-0.4, 1.2}, 0.0, {{0.3, -1.0}, 0.2})}, {},
                     {outer_wall(Ellipse{3.0, 2.5}, 192, {}, {0.1, 0.0})});
  tank.output.fields = everything({-3, -3, 3, 3}, 21);
  const Solved solved(tank);
  const Field field = evaluate_field(solved.solver, solved.solution);
  Index at = 0;
  while (field.in_fluid[static_cast<std::size_t>(at)] == 0) ++at;
  const Complex point = field.grid.points()[at];
  const double here =
      solved.solver.derivatives(solved.solution, ComplexVector{{point}})[0].pressure;
  // These points of the wall are not the solver's nodes.
  const Curve wall = place(sample(Ellipse{3.0, 2.5}, 150, Side::fluid_inside), {0.1, 0.0}, 0.0);
  BOOST_TEST(std::abs(field.pressure[at] - (here - mean_pressure(solved, wall))) < 1e-10);

  const auto& [configuration, forcing, cell, shifts] = solved.solution.instant;
  const Solution reversed = solved.solver.solve({configuration, scaled(-1.0, forcing)});
  const Field back = evaluate_field(solved.solver, reversed);
  BOOST_TEST(std::abs(back.pressure[at] + field.pressure[at]) < 1e-10);
}

// Returns a disk that is driven through a container with arms, where the stress peaks at the walls.
Scene lobed_container(int nodes_a_body, int nodes_a_wall, double tolerance) {
  Scene result = scene({body(Circle{0.6}, nodes_a_body, {0.5, 0.2}, 0.0, {1.0, 0.3})}, {},
                       {outer_wall(Star{2.0, 0.2, 5}, nodes_a_wall)});
  result.solver.tolerance = tolerance;
  result.output.fields = everything({-2.2, -2.2, 2.2, 2.2}, 25);
  return result;
}

EstimatedField estimated(const Scene& scene) {
  const Solved solved(scene);
  return estimated_field(solved.solver, solved.solution);
}

BOOST_AUTO_TEST_CASE(fields_on_automatic_nodes_meet_the_tolerance) {
  const Field right = estimated(lobed_container(automatic_nodes, automatic_nodes, 1e-8)).field;
  for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
    const EstimatedField found =
        estimated(lobed_container(automatic_nodes, automatic_nodes, tolerance));
    BOOST_TEST(found.errors.size() == 5u);
    for (const auto& [quantity, error] : field_differences(found.field, right)) {
      BOOST_TEST(found.errors.at(quantity) <= tolerance, quantity);
      BOOST_TEST(error <= tolerance, quantity << ": " << error << " for " << tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(fields_on_given_nodes_stay_and_are_estimated) {
  const Field right = estimated(lobed_container(automatic_nodes, automatic_nodes, 1e-8)).field;
  const Solved solved(lobed_container(32, 96, 1e-2));
  const EstimatedField found = estimated_field(solved.solver, solved.solution);
  const Field plain = evaluate_field(solved.solver, solved.solution);
  BOOST_TEST(found.solves == 1);
  for (const auto& [quantity, change] : field_differences(found.field, plain)) {
    BOOST_TEST(change == 0.0, quantity);
  }
  for (const auto& [quantity, error] : field_differences(found.field, right)) {
    BOOST_TEST(error <= 2.0 * found.errors.at(quantity), quantity);
    BOOST_TEST(error >= 0.02 * found.errors.at(quantity), quantity);
  }
}

// A disk that turns in an unbounded fluid has the traction 2 mu omega along its rim; the traction
// on each component adds up to its load; the mean normal traction on a container is that of the
// flow without its mean pressure.
BOOST_AUTO_TEST_CASE(values_at_nodes) {
  const double mu = 1.3, omega = 0.7;
  Scene turning = scene({held_body(Circle{0.8}, 64, {1.0, 2.0}, 0.0, {0.0, omega})});
  turning.viscosity = mu;
  const Solved one(turning);
  for (const NodeValues& node : node_values(one.solver, one.solution)) {
    BOOST_TEST(std::abs(node.traction - 2.0 * mu * omega * perp(-node.normal)) < 1e-11);
    BOOST_TEST(std::abs(node.position - Complex(1.0, 2.0) + 0.8 * node.normal) < 1e-14);
  }
  const Solved several(scene({body(Ellipse{0.9, 0.5}, 128, {-1.0, 0.2}, 0.4, {{1.0, 0.3}, 0.2}),
                              held_body(Circle{0.6}, 128, {1.1, -0.2})},
                             {}, {outer_wall(Ellipse{3.5, 3.0}, 192, RotatingWall{0.2})}));
  std::vector<Load> loads(3);
  double mean = 0.0, length = 0.0;
  Index k = 0;
  for (const auto& [party, position, normal, weight, traction, density] :
       node_values(several.solver, several.solution)) {
    const std::size_t component = party.is_wall ? 2 : party.number;
    const Complex centre = several.solution.instant.configuration[component].position;
    loads[component].force += weight * traction;
    loads[component].torque += weight * cross(position - centre, traction);
    BOOST_TEST((density == several.solution.density[k++]));
    if (!party.is_wall) continue;
    mean += weight * dot(normal, traction);
    length += weight;
  }
  for (std::size_t component = 0; component < 3; ++component) {
    const auto& [force, torque] = several.solution.loads[component];
    BOOST_TEST(std::abs(loads[component].force - force) < 1e-9);
    BOOST_TEST(std::abs(loads[component].torque - torque) < 1e-9);
  }
  // No fluid passes a wall that moves rigidly, where n . (sigma + p) n = 0 on the mean.
  BOOST_TEST(std::abs(mean / length) < 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
