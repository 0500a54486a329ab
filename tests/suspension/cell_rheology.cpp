// Checks the rheology of periodic cells: against published and independent numbers, against the
// stress over the edges of a cell and quadratures over the fluid, and in all descriptions of one
// physical problem.
#include "suspension/solver/cell_rheology.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/test/unit_test.hpp>

#include "cell_scenes.hpp"
#include "stress/stress.hpp"
#include "suspension/bodies/cell.hpp"
#include "suspension/solver/rheology.hpp"
#include "trajectories.hpp"

namespace stokesbook::test {

namespace {

using Eigen::Index;
using Eigen::Matrix2d;
using std::numbers::pi;

Rheology rheology_of(const Solved& solved) {
  return Rheometer(solved.solver)(solved.solution);
}

CellRheology measured(const Scene& scene) {
  return *rheology_of(Solved(scene)).cell;
}

// One free disk in a unit cell that is sheared by gamma, in the shear u = (y, 0).
Scene sheared_disk(double area_fraction, double gamma, double tolerance = 1e-11) {
  return cell_scene({disk(std::sqrt(area_fraction / pi), 0.0)}, 1.0, {gamma, 1.0}, ShearFlow{1.0},
                    tolerance);
}

// The forces on the three bodies have the sum zero.
Scene balanced_bodies() {
  Scene made = three_bodies();
  made.bodies[2].force = {-0.7, -0.7};
  made.solver.tolerance = 1e-12;
  return made;
}

Matrix2d dyad(Complex a, Complex b) {
  return Matrix2d{{a.real() * b.real(), a.real() * b.imag()},
                  {a.imag() * b.real(), a.imag() * b.imag()}};
}

void check_tensor(const Matrix2d& found, const Matrix2d& exact, double tolerance) {
  BOOST_TEST((found - exact).cwiseAbs().maxCoeff() < tolerance * exact.cwiseAbs().maxCoeff(),
             found << "\nis not\n"
                   << exact);
}

// Both values of the dissipation, with that of the undisturbed flow in the cell.
void check_dissipation(const Rheology& found, double undisturbed, double exact, double tolerance) {
  check(found.dissipation + undisturbed, exact, tolerance);
  check(found.cell->dissipation_by_traction + undisturbed, exact, tolerance);
}

// Integrates (sigma nu)_i x_j over the edges of the parallelogram about the origin, by Gauss's rule
// with 60 points on each edge.
Matrix2d stress_over_edges(const Solved& solved, Complex a1, Complex a2) {
  using Rule = boost::math::quadrature::gauss<double, 60>;
  const Complex corners[] = {-a1 - a2, a1 - a2, a1 + a2, a2 - a1, -a1 - a2};
  Matrix2d sum = Matrix2d::Zero();
  for (std::size_t edge = 0; edge < 4; ++edge) {
    const Complex middle = 0.25 * (corners[edge] + corners[edge + 1]),
                  half = 0.25 * (corners[edge + 1] - corners[edge]);
    std::vector<Complex> points;
    std::vector<double> weights;
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      for (const double sign : {1.0, -1.0}) {
        points.push_back(middle + sign * Rule::abscissa()[k] * half);
        weights.push_back(Rule::weights()[k] * std::abs(half));
      }
    }
    const ComplexVector x = ComplexVector::Map(points.data(), std::ssize(points));
    const auto flow = solved.solver.derivatives(solved.solution, x);
    const Complex normal = -imaginary * half / std::abs(half);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double mu = solved.solver.scene().viscosity;
      sum += weights[k] * dyad(traction(flow[k], normal, mu), points[k]);
    }
  }
  return sum / std::abs(cross(a1, a2));
}

// A quadrature over the fluid in a cell with one disk: Gauss's rule and the trapezoid rule in a
// ring about the disk, and a grid along the lattice vectors for the rest, with a smooth cut-off.
struct RingAndGrid {
  ComplexVector points;
  std::vector<double> weights;

  RingAndGrid(Complex centre, double radius, double outer, Complex a1, Complex a2) {
    using Rule = boost::math::quadrature::gauss<double, 60>;
    const auto cut_off = [=](double r) {
      return 0.5 * std::erfc(5.25 * (2.0 * (r - radius) / (outer - radius) - 1.0));
    };
    std::vector<Complex> all;
    const auto add = [&](Complex point, double weight) {
      all.push_back(point);
      weights.push_back(weight);
    };
    constexpr int around = 80, along = 110;
    const double middle = 0.5 * (radius + outer), half = 0.5 * (outer - radius);
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      for (const double sign : {1.0, -1.0}) {
        const double r = middle + sign * half * Rule::abscissa()[k];
        const double weight = Rule::weights()[k] * half * r * 2.0 * pi / around * cut_off(r);
        for (int j = 0; j < around; ++j) add(centre + std::polar(r, 2.0 * pi * j / around), weight);
      }
    }
    const Lattice lattice(a1, a2);
    for (int i = 0; i < along; ++i) {
      for (int j = 0; j < along; ++j) {
        const Complex z = (a1 * static_cast<double>(i) + a2 * static_cast<double>(j)) /
                          static_cast<double>(along);
        const double r = std::abs(lattice.wrap(z, centre) - centre);
        const double weight = (1.0 - cut_off(r)) * lattice.area() / (along * along);
        if (r > radius && weight > 0.0) add(z, weight);
      }
    }
    points = ComplexVector::Map(all.data(), std::ssize(all));
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(cell_rheology)

// Three loaded bodies: the stress and the dissipation from the boundary of a cell.
BOOST_AUTO_TEST_CASE(bulk_stress_of_loaded_bodies) {
  const Solved solved(balanced_bodies());
  const Rheology found = rheology_of(solved);
  check_tensor(found.cell->stress,
               Matrix2d{{0.9451158303519, 1.2770327180985}, {1.3424080207619, -0.9281666778095}},
               1e-10);
  const double undisturbed = 2.0 * 1.3 * 4.13 * 0.325;  // 2 mu V E:E
  check_dissipation(found, undisturbed, 5.531024337247, 1e-9);
  check(found.cell->dissipation_by_traction, found.dissipation, 1e-11);
  check_tensor(found.cell->stress, stress_over_edges(solved, {2.2, 0.1}, {0.5, 1.9}), 1e-9);
}

// With a net force, the stress is that over the edges of the cell about x_0, in which the pressure
// is linear.
BOOST_AUTO_TEST_CASE(bulk_stress_with_a_net_force) {
  Scene net = three_bodies();
  net.solver.tolerance = 1e-12;
  const Solved solved(net);
  const Rheology found = rheology_of(solved);
  check_tensor(found.cell->stress, stress_over_edges(solved, {2.2, 0.1}, {0.5, 1.9}), 1e-9);
  check(found.cell->dissipation_by_traction, found.dissipation, 1e-10);
  hold_disk(net);
  net.cell->mean_velocity = 0.0;
  net.cell->pressure_gradient = {0.5, -0.25};
  const Solved held(net);
  const Rheology driven = rheology_of(held);
  check_tensor(driven.cell->stress, stress_over_edges(held, {2.2, 0.1}, {0.5, 1.9}), 1e-9);
  check(driven.cell->dissipation_by_traction, driven.dissipation, 1e-10);
}

// The power of a slip is part of both values of the dissipation.
BOOST_AUTO_TEST_CASE(dissipation_of_bodies_with_slip) {
  Scene slipping = balanced_bodies();
  slipping.bodies[2].slip = Squirmer{{0.4, 0.7}};
  const Rheology found = rheology_of(Solved(slipping));
  check(found.cell->dissipation_by_traction, found.dissipation, 1e-9);
  BOOST_TEST(std::abs(found.dissipation - rheology_of(Solved(balanced_bodies())).dissipation) >
             0.01);
}

BOOST_AUTO_TEST_CASE(sheared_arrays) {
  struct Row {
    double area_fraction, gamma, omega, s11, viscosity;
  };
  const Row rows[] = {{0.001, 0.0, -0.5, 0.0, 1.0019988116926},
                      {0.1, 0.0, -0.5, 0.0, 1.1922241876481},
                      {0.1, 0.3, -0.4934949184144, -0.0103051546494, 1.2041224204697},
                      {0.1, 0.5, -0.4902020042109, 0.0, 1.2099925798251},
                      {0.3, 0.0, -0.5, 0.0, 1.5981159774156},
                      {0.3, 0.3, -0.4784535908960, -0.1280598791163, 1.7140916371852},
                      {0.3, 0.5, -0.4683058369728, 0.0, 1.7652219275542},
                      {0.5, 0.0, -0.5, 0.0, 2.2550192331725},
                      {0.5, 0.3, -0.4586598081161, -0.6626107508110, 2.7889001098406},
                      {0.5, 0.5, -0.4396631436456, 0.0, 2.9762070354437}};
  for (const Row& row : rows) {
    BOOST_TEST_CONTEXT("area fraction " << row.area_fraction << ", gamma " << row.gamma) {
      const Solved solved(sheared_disk(row.area_fraction, row.gamma));
      const Rheology found = rheology_of(solved);
      check(solved.motion(0).omega, row.omega, 1e-10);
      check(found.cell->viscosity, row.viscosity, 1e-10);
      check(found.cell->normal_stress_difference(), 2.0 * row.s11, 1e-10);
      check(found.cell->stress(1, 0), row.viscosity, 1e-10);
      check(found.dissipation, row.viscosity - 1.0, 1e-10);
      check(found.cell->dissipation_by_traction, row.viscosity - 1.0, 1e-10);
    }
  }
}

// The fluid's mean pressure, by quadratures over the fluid.
BOOST_AUTO_TEST_CASE(particle_pressure_of_a_sheared_array) {
  const std::pair<double, double> rows[] = {{0.0, 0.0},
                                            {0.1, 0.0096643925763},
                                            {0.3, 0.0142421344075},
                                            {-0.3, -0.0142421344075},
                                            {0.5, 0.0}};
  for (const auto& [gamma, pressure] : rows) {
    check(measured(sheared_disk(0.3, gamma)).particle_pressure, -pressure, 1e-11);
  }
}

// A quadrature over the fluid of the dissipation and of the pressure around one disk with a torque,
// in a general linear flow whose centre lies elsewhere.
BOOST_AUTO_TEST_CASE(quadrature_over_the_fluid) {
  const double radius = std::sqrt(0.3 / pi);
  Scene loaded =
      cell_scene({disk(radius, {0.1, -0.2}, {{}, 0.3})}, 1.0, {0.3, 1.0},
                 LinearFlow{Eigen::Matrix2d{{0.2, 1.0}, {-0.3, -0.2}}, {0.2, 0.1}}, 1e-12);
  loaded.viscosity = 1.3;
  const Solved solved(loaded);
  const RingAndGrid rule({0.1, -0.2}, radius, 0.52, 1.0, {0.3, 1.0});
  const auto flow = solved.solver.derivatives(solved.solution, rule.points);
  double area = 0.0, dissipation = 0.0, pressure = 0.0;
  for (std::size_t k = 0; k < flow.size(); ++k) {
    area += rule.weights[k];
    dissipation += rule.weights[k] * dissipation_density(flow[k], 1.3);
    pressure += rule.weights[k] * 1.3 * flow[k].pressure;
  }
  check(area, 0.7, 1e-11);
  const Rheology found = rheology_of(solved);
  check_dissipation(found, 2.0 * 1.3 * 0.325, dissipation, 1e-10);
  check(found.cell->particle_pressure + 0.5 * found.cell->stress.trace(), -pressure / area, 1e-10);
  BOOST_TEST(std::abs(pressure) > 1e-3);
}

// The means over a period of the lattice, from runs: equal steps integrate periodic functions
// almost exactly. The disk does not leave its place.
BOOST_AUTO_TEST_CASE(period_of_a_sheared_array) {
  const std::array<double, 3> rows[] = {{0.3, 1.6853874693389, -0.4836994105976},
                                        {0.5, 2.6508437234253, -0.4687534250203}};
  for (const auto& [area_fraction, mean_viscosity, mean_omega] : rows) {
    Scene run = sheared_disk(area_fraction, 0.0);
    constexpr int steps = 24;
    run.time = TimeSettings{.t_final = 1.0, .dt = 1.0 / steps, .method = SteppingMethod::euler};
    double viscosity = 0.0, omega = 0.0, difference = 0.0;
    for (const Frame& frame : frames_of(run)) {
      if (frame.t == 0.0) continue;
      viscosity += frame.rheology.cell->viscosity / steps;
      difference += frame.rheology.cell->normal_stress_difference() / steps;
      omega += frame.bodies[0].omega / steps;
      check(frame.rheology.cell->dissipation_by_traction, frame.rheology.dissipation, 1e-9);
    }
    check(viscosity, mean_viscosity, 1e-10);
    check(omega, mean_omega, 1e-10);
    check(difference, 0.0, 1e-10);
  }
}

// Two disks, in a run across several wraps of the lattice: their viscosity and normal stress
// difference, and where their images lie.
BOOST_AUTO_TEST_CASE(rheology_in_time, *boost::unit_test::label("full")) {
  Scene run = two_disks();
  run.bodies[1].position += Complex{-4.0, 2.0};
  run.time =
      TimeSettings{.t_final = 2.0, .method = SteppingMethod::prince_dormand87, .tolerance = 1e-11};
  run.output.dt_write = 0.5;
  run.solver.tolerance = 1e-11;
  const std::vector<Frame> frames = frames_of(run);
  const std::pair<double, double> exact[] = {{1.59114101165, 0.09814191790},
                                             {1.52969178908, 0.01287418162},
                                             {1.56404897368, -0.03259087864},
                                             {1.55710343743, -0.01809952912},
                                             {1.62733562616, -0.10587799577}};
  BOOST_REQUIRE(frames.size() == 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const CellRheology& cell = *frames[k].rheology.cell;
    check(cell.viscosity, exact[k].first, 1e-9);
    check(cell.normal_stress_difference(), exact[k].second, 1e-9);
    check(cell.dissipation_by_traction, frames[k].rheology.dissipation, 1e-9);
    const Lattice lattice = lattice_of(*cell_at(run, frames[k].t));
    for (const std::size_t body : {0U, 1U}) {
      const Complex image = frames[k].cell->bodies[body].position;
      BOOST_TEST(std::abs(lattice.nearest(image)) == 0.0);
      const Complex w = frames[k].bodies[body].position - image;
      BOOST_TEST(std::abs(w - lattice.nearest(w)) < 1e-12);
    }
  }
}

// A worm that crosses the edges of its cell, and whose images it nearly meets, in a given pressure
// gradient.
BOOST_AUTO_TEST_CASE(worm_array) {
  const Index n = 140;
  NodalCurve worm{ComplexVector(n), {}};
  for (Index i = 0; i < n; ++i) {
    const double t = 2.0 * pi * static_cast<double>(i) / static_cast<double>(n);
    const double x = 0.7 * std::cos(t);
    worm.points[i] = {x, 0.15 * std::sin(t) + 0.3 * std::sin(2.0 * x)};
  }
  Scene array = cell_scene({held_body(worm, automatic_nodes, 0.0)}, 1.0, imaginary);
  array.viscosity = 0.7;
  array.cell->pressure_gradient = -1.0;
  const Solved along(array);
  check(along.solution.uniform_velocity, {0.008234042360237, 0.002263863756014}, 1e-11);
  check(along.velocity(ComplexVector{{Complex{0.1, 0.4}}})[0],
        {0.016778793238148, 0.005152952236958}, 1e-10);
  const Rheology found = rheology_of(along);
  check(found.cell->dissipation_by_traction, found.dissipation, 1e-10);
  check(found.dissipation, 0.008234042360237, 1e-11);  // -V P . u_c
  array.cell->pressure_gradient = -imaginary;
  check(Solved(array).solution.uniform_velocity, {0.002263863756014, 0.002195437715081}, 1e-11);
}

// Every description of one physical problem gives the same motions and the same stress.
BOOST_AUTO_TEST_CASE(invariances) {
  constexpr double rounding = 2e-12;
  Scene given = three_bodies();  // with a net force
  given.solver.tolerance = 1e-13;
  const Complex a1{2.2, 0.1}, a2{0.5, 1.9};
  const Solved exact(given);
  const CellRheology rheology = *rheology_of(exact).cell;
  // Compares motions of images in the cell, and the rheology, in a frame turned by an angle.
  const auto compare = [&](const Scene& changed, double angle = 0.0) {
    const Solved solved(changed);
    const Complex turn = std::polar(1.0, angle);
    for (std::size_t k = 0; k < 3; ++k) {
      check(solved.motion(k).velocity, turn * exact.motion(k).velocity, rounding);
      check(solved.motion(k).omega, exact.motion(k).omega, rounding);
    }
    const CellRheology found = *rheology_of(solved).cell;
    const Matrix2d rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
    check_tensor(found.stress, rotation * rheology.stress * rotation.transpose(), rounding);
    check(found.viscosity, rheology.viscosity, rounding);
    check(found.particle_pressure, rheology.particle_pressure, 10.0 * rounding);
    return solved;
  };
  const auto set_vectors = [](Scene& scene, Complex a, Complex b) {
    scene.cell->vectors << a.real(), a.imag(), b.real(), b.imag();
  };
  BOOST_TEST_CONTEXT("a body moved by a lattice vector") {
    Scene moved = given;
    moved.bodies[1].position += a1 - 2.0 * a2;
    compare(moved);
  }
  BOOST_TEST_CONTEXT("everything moved") {
    Scene moved = given;
    std::get<LinearFlow>(moved.flow).centre = {3.0, -7.0};
    for (Body& some : moved.bodies) some.position += Complex{3.0, -7.0};
    compare(moved);
  }
  for (const auto& [first, second] :
       {std::pair{a1, a2 + a1}, std::pair{a1 + 3.0 * a2, 2.0 * a1 + 7.0 * a2}}) {
    BOOST_TEST_CONTEXT("another basis, beginning with " << first) {
      Scene other = given;
      set_vectors(other, first, second);
      compare(other);
    }
  }
  BOOST_TEST_CONTEXT("the frame turned") {
    constexpr double angle = 0.6;
    const Complex turn = std::polar(1.0, angle);
    const Matrix2d rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
    Scene turned = given;
    set_vectors(turned, turn * a1, turn * a2);
    Matrix2d& gradient = std::get<LinearFlow>(turned.flow).gradient;
    gradient = rotation * gradient * rotation.transpose();
    turned.cell->mean_velocity *= turn;
    for (Body& some : turned.bodies) {
      some.position *= turn;
      some.orientation += angle;
      some.force *= turn;
    }
    compare(turned, angle);
  }
  // The stress of bodies with forces depends on the images that lie in the larger cell.
  BOOST_TEST_CONTEXT("two cells as one") {
    Scene once = given;
    for (Body& some : once.bodies) some.force = 0.0;
    Scene twice = once;
    set_vectors(twice, 2.0 * a1, a2);
    for (Body copy : once.bodies) {
      copy.position += a1;
      twice.bodies.push_back(copy);
    }
    const Rheology one = rheology_of(Solved(once)), two = rheology_of(Solved(twice));
    check_tensor(two.cell->stress, one.cell->stress, rounding);
    check(two.cell->particle_pressure, one.cell->particle_pressure, 10.0 * rounding);
    check(two.dissipation, 2.0 * one.dissipation, rounding);
    check(two.cell->dissipation_by_traction, 2.0 * one.dissipation, rounding);
  }
}

// Two disks and a contact force between the first one and the image of the second that is moved by
// -a2: the viscosity is published in no paper, it was computed with another program.
BOOST_AUTO_TEST_CASE(contact_with_an_image) {
  const Complex a1 = 1.0, a2{0.3, 1.0}, normal = std::polar(1.0, 0.75 * pi);
  const double force = 2.405072329390;
  Scene pair =
      cell_scene({disk(0.2, {0.1, -0.35}, {force * normal, 0.0}),
                  disk(0.2, {0.6899137802864845, 0.3600862197135155}, {-force * normal, 0.0})},
                 a1, a2, ShearFlow{1.0});
  for (const Complex moved : {Complex{}, a1 - 2.0 * a2}) {
    pair.bodies[1].position += moved;
    const Solved solved(pair);
    const ContactForce contact{.a = {false, 0},
                               .b = {false, 1},
                               .point = {},
                               .normal = normal,
                               .force = force,
                               .gap = 0.0,
                               .image = {},
                               .shift = -a2 - moved};
    const CellRheology found = *Rheometer(solved.solver)(solved.solution, {contact}).cell;
    check(found.viscosity, 1.973898474955, 1e-9);
    const Complex apart = pair.bodies[0].position - pair.bodies[1].position - contact.shift;
    check(found.contact_stress(0, 1), -force * normal.real() * apart.imag(), 1e-12);
    check(found.stress(1, 0), found.stress(0, 1), 1e-11);
  }
}

// A contact away from the centres of two ellipses within a cell: no force crosses the edges of the
// cell but that of the fluid. The stress does not depend on the names of the images.
BOOST_AUTO_TEST_CASE(contact_within_a_cell) {
  const Complex a1{2.2, 0.1}, a2{0.5, 1.9}, force{1.0, -0.4}, point{-0.05, 0.1};
  Scene pair = three_bodies();
  pair.bodies.pop_back();
  pair.solver.tolerance = 1e-12;
  for (Body& some : pair.bodies) {
    const double sign = &some == &pair.bodies[0] ? 1.0 : -1.0;
    some.force = sign * force;
    some.torque = cross(point - some.position, some.force);
  }
  ContactForce contact{.a = {false, 0},
                       .b = {false, 1},
                       .point = point,
                       .normal = force / std::abs(force),
                       .force = std::abs(force),
                       .gap = 0.0,
                       .image = {},
                       .shift = {}};
  const Solved within(pair);
  const CellRheology exact = *Rheometer(within.solver)(within.solution, {contact}).cell;
  check_tensor(exact.stress, stress_over_edges(within, a1, a2), 1e-9);
  BOOST_TEST(std::abs(exact.stress(0, 1) - exact.stress(1, 0)) < 1e-13);
  pair.bodies[0].position += 2.0 * a2;
  pair.bodies[1].position -= a1;
  contact.shift = a1 + 2.0 * a2;
  const Solved across(pair);
  const CellRheology found = *Rheometer(across.solver)(across.solution, {contact}).cell;
  check_tensor(found.stress, exact.stress, 1e-11);
  check_tensor(found.contact_stress, exact.contact_stress, 1e-12);
  check(found.particle_pressure, exact.particle_pressure, 1e-11);
}

// A repulsion through an edge of the cell carries the stress of a contact force of this size.
BOOST_AUTO_TEST_CASE(repulsion_through_an_edge) {
  Scene repelled = cell_scene({disk(0.2, {-0.29, 0.0}), disk(0.2, {0.29, 0.1})}, 1.0, {0.3, 1.0},
                              ShearFlow{1.0});
  repelled.repulsion = Repulsion{500.0, 0.005};
  const Solved solved(repelled);
  const CellRheology found = *rheology_of(solved).cell;
  // The image of disk 1 lies at the left of disk 0.
  const Complex apart = Complex{-0.29, 0.0} - Complex{0.29 - 1.0, 0.1};
  const double force = 500.0 * std::exp(-(std::abs(apart) - 0.4) / 0.005);
  check(solved.load(0).force, force * apart / std::abs(apart), 1e-10);
  check_tensor(found.contact_stress, -force / std::abs(apart) * dyad(apart, apart), 1e-10);
  BOOST_TEST(found.contact_stress.norm() > 0.1);
  repelled.repulsion = {};
  const Complex load = force * apart / std::abs(apart);
  repelled.bodies[0].force = load;
  repelled.bodies[1].force = -load;
  const Solved loaded(repelled);
  const ContactForce contact{.a = {false, 0},
                             .b = {false, 1},
                             .point = {},
                             .normal = apart / std::abs(apart),
                             .force = force,
                             .gap = 0.0,
                             .image = {},
                             .shift = -1.0};
  check_tensor(found.stress, Rheometer(loaded.solver)(loaded.solution, {contact}).cell->stress,
               1e-10);
}

// Two rows of ellipses are sheared past each other, and touch images above and below. Without
// external torques the stress is symmetric: contact forces and torques of a pair balance where its
// images are.
BOOST_AUTO_TEST_CASE(contact_in_a_run) {
  Scene rows = cell_scene({body(Ellipse{0.34, 0.3}, automatic_nodes, {0.2, 0.0}, 0.4),
                           body(Ellipse{0.32, 0.28}, automatic_nodes, {-0.3, 0.66}, -0.3)},
                          1.5, {0.0, 1.32}, ShearFlow{1.0}, 1e-5);
  rows.contact = ContactSettings{.minimum_separation = 0.16};
  rows.time = TimeSettings{.t_final = 1.5, .dt = 0.05, .method = SteppingMethod::euler};
  std::size_t images = 0;
  for (const Frame& frame : frames_of(rows)) {
    const CellRheology& found = *frame.rheology.cell;
    BOOST_TEST(std::abs(found.stress(0, 1) - found.stress(1, 0)) < 1e-12 * found.stress.norm());
    check(found.dissipation_by_traction, frame.rheology.dissipation, 1e-5);
    Matrix2d expected = Matrix2d::Zero();
    for (const ContactForce& contact : frame.contacts) {
      const Complex apart = frame.bodies[contact.a.number].position -
                            frame.bodies[contact.b.number].position - contact.shift;
      expected -= contact.force / 1.98 * dyad(contact.normal, apart);
      if (contact.shift != 0.0) ++images;
    }
    const Matrix2d symmetric = 0.5 * (expected + expected.transpose());
    BOOST_TEST((found.contact_stress - symmetric).norm() < 1e-12 * (1.0 + symmetric.norm()));
  }
  BOOST_TEST(images > 3u);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
