// Computes with the libraries the numbers that the twins of the chapters compute in NumPy. Each
// line of its output has the chapter, the name and the values. Each function has the problem of its
// twin.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "closure/bordered_system.hpp"
#include "closure/rigid_modes.hpp"
#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "fmm/translations.hpp"
#include "krylov/gmres.hpp"
#include "lcp/lemke.hpp"
#include "near_singular/cauchy.hpp"
#include "periodic/far_sums.hpp"
#include "preconditioning/cluster_preconditioner.hpp"
#include "stiv/contacts.hpp"
#include "stress/stress.hpp"
#include "stress/stresslet.hpp"
#include "stress/traction.hpp"
#include "support/cells.hpp"
#include "support/dense.hpp"
#include "support/spectra.hpp"
#include "support/walls.hpp"
#include "suspension/solver/solver.hpp"
#include "time_stepping/stepper.hpp"
#include "trapezoid/fourier.hpp"

using namespace stokesbook;
using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

const char* chapter = "";  // whose numbers are printed

void print(const std::string& name, const VectorXd& values) {
  std::printf("%s %s", chapter, name.c_str());
  for (const double value : values) std::printf(" %.17g", value);
  std::puts("");
}

void print(const std::string& name, double value) {
  print(name, VectorXd::Constant(1, value));
}

std::string text(double value) {
  char written[32];
  std::snprintf(written, sizeof written, "%g", value);
  return written;
}

// All components 1 of plane vectors, then all components 2.
VectorXd by_component(const ComplexVector& v) {
  VectorXd values(2 * v.size());
  values << v.real(), v.imag();
  return values;
}

VectorXd values_of(const RigidMotion& motion) {
  return VectorXd{{motion.velocity.real(), motion.velocity.imag(), motion.omega}};
}

Component free_body(const Curve& curve, Complex centre) {
  return {ComponentKind::free_body, curve, centre, {}, 0.0, {}};
}

VectorXd solve_reduced(const StokesProblem& problem) {
  const DenseSystem system = assemble(problem, ClosureForm::reduced);
  return test::solve(system.matrix, system.rhs);
}

void chapter_01() {
  const auto ellipse = [](Index n) { return sample(Ellipse{2.0, 0.4}, n, Side::fluid_outside); };
  VectorXd perimeters(5);
  for (Index k = 0; k < 5; ++k) perimeters[k] = perimeter(ellipse(Index{8} << k));
  print("perimeters", perimeters);
  print("area", area(ellipse(32)));
  print("curvature_at_tip", curvatures(ellipse(32))[0]);
  ComplexVector f(24);
  for (Index j = 0; j < 24; ++j) {
    f[j] = 1.0 / (std::cosh(0.5) - std::cos(pi / 12.0 * static_cast<double>(j)));
  }
  print("derivative", differentiate(f)[3].real());
}

void chapter_02() {
  constexpr double mu = 1.3, torque = 0.7;
  const Complex source{0.3, 0.1}, force{1.0, -2.0};
  const Curve curve = sample(Ellipse{1.0, 0.5}, 64, Side::fluid_outside);
  const auto point_flow = [&](const ComplexVector& x, Complex at, double of_point) {
    return ComplexVector(x.unaryExpr([&](Complex z) {
      return stokeslet(z - at, force, mu, 1.0) + rotlet(z - at, of_point, mu);
    }));
  };
  const double of_centre = torque + cross(source, force);
  const RigidModeMatrices rigid = rigid_mode_matrices(curve, 0.0);
  const MatrixXd matrix = double_layer_matrix(curve) - rigid.modes * rigid.projection -
                          0.5 * MatrixXd::Identity(128, 128);
  print("condition", test::condition_number(matrix));
  const ComplexVector data =
      point_flow(curve.x, source, torque) - point_flow(curve.x, 0.0, of_centre);
  const VectorXd density = test::solve(matrix, interleaved(data));
  const ComplexVector targets{{{0.0, 1.5}, {0.0, 0.7}, {0.0, 0.56}}};
  print("velocities", by_component(StressletSum({curve})(targets, deinterleaved(density)) +
                                   point_flow(targets, 0.0, of_centre)));
}

void chapter_03() {
  const Curve own = sample(Ellipse{1.0, 0.4}, 128, Side::fluid_outside);
  StokesProblem problem{{free_body(place(own, 0.0, 0.6), 0.0)}, 1.3, {}, 20.0};
  Component& body = problem.components[0];
  const auto print_motion = [&](const std::string& name) {
    const VectorXd solution = solve_reduced(problem);
    print("motion_by_" + name,
          values_of(complete_dense(problem, ClosureForm::reduced, solution).motions[0]));
  };
  body.force = 1.0;
  print_motion("force_1");
  body.force = imaginary;
  print_motion("force_2");
  body.force = 0.0;
  body.torque = 1.0;
  print_motion("torque");
  body.torque = 0.0;
  problem.background = body.curve.x.imag().cast<Complex>();
  print_motion("shear");
}

void chapter_04() {
  const Index n = 192;
  Component shaft = free_body(sample(Circle{1.0}, n, Side::fluid_outside), 0.0), bushing;
  shaft.kind = ComponentKind::prescribed;
  shaft.velocity = imaginary * shaft.curve.x;
  bushing.kind = ComponentKind::enclosing_wall;
  bushing.centre = {0.0, 0.5};
  bushing.curve = place(sample(Circle{2.0}, n, Side::fluid_inside), bushing.centre, 0.0);
  bushing.velocity = ComplexVector::Zero(n);
  const StokesProblem problem{{shaft, bushing}, 1.0, {}, {}};
  const DenseSystem system = test::assemble_bounded(problem, ClosureForm::reduced);
  const VectorXd solution = test::solve(system.matrix, system.rhs);
  const Load load = complete_dense(problem, ClosureForm::reduced, solution).loads[0];
  print("load_of_shaft", VectorXd{{load.force.real(), load.force.imag(), load.torque}});
  print("condition", test::condition_number(system.matrix));
}

void chapter_05() {
  for (const Index n : {48, 96, 192}) {
    const Curve circle = sample(Circle{1.0}, n, Side::fluid_outside);
    StokesProblem problem{
        {free_body(circle, 0.0), free_body(place(circle, 2.5, 0.0), 2.5)}, 1.0, {}, {}};
    problem.background = imaginary * all_nodes(curves_of(problem)).conjugate();
    const DenseSystem system = assemble(problem, ClosureForm::reduced);
    const GmresResult result =
        gmres([&](const VectorXd& v) -> VectorXd { return system.matrix * v; }, {}, system.rhs,
              {.tolerance = 1e-10});
    print("iterations_" + std::to_string(n), result.iterations);
    print("residuals_" + std::to_string(n), VectorXd::Map(&result.history[1], 7));
  }
}

void chapter_06() {
  const Index n = 96;
  ComplexVector density(n);
  for (Index j = 0; j < n; ++j) {
    const double t = 2.0 * pi * static_cast<double>(j) / static_cast<double>(n);
    density[j] = {std::exp(0.5 * std::sin(t)), std::cos(2.0 * t)};
  }
  const CauchyCurve cauchy(sample(Ellipse{2.0, 1.0}, n, Side::fluid_outside));
  const CauchyData data = cauchy.data(density);
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (const auto& [name, distance] : {std::pair{"1.0", 1.0}, {"0.01", 1e-2}, {"1e-06", 1e-6}}) {
    const ComplexVector target{{Complex{2.0 * c, s} + distance * Complex{c, 2.0 * s}}};
    const Complex u = cauchy.velocity(data, 0, target)[0];
    const double pressure = cauchy.derivatives(cauchy.derivative_data(data), 0, target)[0].pressure;
    print(std::string("flow_at_") + name, VectorXd{{u.real(), u.imag(), pressure}});
  }
}

void chapter_07() {
  constexpr double mu = 1.3;
  const Curve own = sample(Ellipse{1.0, 0.5}, 128, Side::fluid_outside);
  const Curve curve = place(own, 0.0, 0.5);
  const StokesProblem problem{{free_body(curve, 0.0)}, mu, curve.x.conjugate(), {}};
  const SolvedFlow flow(problem, cauchy_curves(problem), deinterleaved(solve_reduced(problem)));
  const Complex strain = 2.0;  // of the flow (x, -y)
  std::vector<FlowDerivatives> at_nodes = flow.derivatives(curve.x);
  for (FlowDerivatives& at : at_nodes) at += {0.0, 0.0, strain};
  const ComplexVector traction = boundary_traction(problem, at_nodes);
  const Complex stresslet = body_stresslet(curve, flow.density(), mu),
                of_traction =
                    -0.5 * (traction.array() * curve.x.array() * weights(curve).array()).sum();
  print("stresslets", by_component(ComplexVector{{stresslet, of_traction}}));
  print("intrinsic_viscosity", intrinsic_viscosity(stresslet, strain, 0.5 * pi, mu));
  VectorXd pressures(5);
  for (std::size_t j = 0; j < 5; ++j) {
    pressures[static_cast<Index>(j)] = mu * at_nodes[j].pressure;
  }
  print("pressures", pressures);
  print("tractions", interleaved(traction).head(10));
}

void chapter_08() {
  constexpr int nodes = 50, order = 12;
  const ArrayXd j = ArrayXd::LinSpaced(nodes, 0.0, nodes - 1.0);
  const Box from{.first = 0, .last = nodes, .centre = {1.0, 2.0}, .radius = 0.5},
      to{.first = 0, .last = nodes, .centre = {2.4, 1.4}, .radius = 0.5};
  const ArrayXd radius = 0.5 * ((j + 0.5) / nodes).sqrt();
  const VectorXd x = 1.0 + radius * (2.4 * j).cos(), y = 2.0 + radius * (2.4 * j).sin(),
                 nx = 0.1 / pi * j.cos(), ny = 0.1 / pi * j.sin(),
                 least2 = VectorXd::Constant(nodes, 0.05 * 0.05), ex = j.cos(),
                 ey = (3.0 * j).sin();
  const StressletBlock block{x.data(),      y.data(), nx.data(), ny.data(),
                             least2.data(), nodes,    ex.data(), ey.data()};
  Expansions multipole(1, 1, order), local(1, 1, order);
  multipole.clear(0);
  local.clear(0);
  p2m(from, block, multipole(0, 0));
  const std::vector<Index> list{0};
  Translations(order).m2l({from}, multipole, list, 0, to, local(0, 0));
  const auto print_rows = [](const std::string& name, const MatrixXd& two_rows) {
    print(name, two_rows.reshaped());
  };
  print_rows("A", multipole(0, 0).topRows(2).rightCols(order).matrix());
  print_rows("B", multipole(0, 0).bottomRows(2).rightCols(order).matrix());
  print_rows("lambda", local(0, 0).topRows(2).matrix());
  print_rows("mu", local(0, 0).bottomRows(2).matrix());
  const VectorXd target_x = 2.4 + radius * (2.4 * j).cos(),
                 target_y = 1.4 - radius * (2.4 * j).sin();
  const VectorGroup targets = group_of(target_x, target_y, 0, nodes);
  const auto print_velocities = [](const std::string& name, const VectorGroup& u) {
    print(name, VectorXd{{u.x[0], u.y[0], u.x[1], u.y[1], u.x[2], u.y[2]}});
  };
  std::array<VectorGroup, 1> direct{};
  add_velocities<1>(block, targets, direct);
  print_velocities("direct", direct[0]);
  VectorGroup sum;
  l2p(to, local(0, 0), targets, sum);
  print_velocities("velocity_12", sum);
}

void chapter_09() {
  const Rate carried = [](double, const VectorXd& q) -> VectorXd {  // (09.12)
    const double x = q[0], y = q[1], r2 = q.squaredNorm();
    const double strain = 0.5 * (1.0 - 1.0 / (r2 * r2)),
                 radial = -2.0 * x * y * (r2 - 1.0) / (r2 * r2 * r2);
    return VectorXd{{0.5 * y + strain * y + radial * x, -0.5 * x + strain * x + radial * y}};
  };
  for (const double tolerance : {1e-7, 1e-5, 1e-3}) {
    const Stepper stepper({.method = SteppingMethod::bogacki_shampine32,
                           .dt = 0.1,
                           .bound = {tolerance, VectorXd::Ones(2)}},
                          {carried, carried});
    const VectorXd start{{-5.0, 0.2}};
    TimePoint now{0.0, start, carried(0.0, start)};
    StepMemory memory;
    int steps = 0, rejected = 0;
    for (; now.t < 34.0; ++steps) {
      StepResult taken = stepper.advance(now, std::move(memory), 34.0);
      now = taken.step.end;
      memory = std::move(taken.memory);
      rejected += taken.rejected;
    }
    print("steps_" + text(tolerance), VectorXd{{1.0 * steps, 1.0 * rejected}});
    print("end_" + text(tolerance), now.state);
  }
}

void chapter_10() {
  const auto ellipse = [](double a, double b) {
    return std::make_shared<ContactShape>(
        contact_shape(sample(Ellipse{a, b}, 120, Side::fluid_outside)));
  };
  const ContactShapes shapes{ellipse(1.2, 0.5), ellipse(0.6, 0.9)};
  const PathPair paths{
      0, 1, {{{-2.3, 0.3}, 0.2}, {4.5, -0.2}, -0.6}, {{{0.0, 0.2}, -0.1}, {0.3, 0.1}, 0.2}};
  const PairEvents pair = pair_events(shapes, paths, {0.1, 1e-9, 0.4, 0.0});
  double first = 1.0, deepest = 0.0, volume = 0.0;
  for (const auto* events : {&pair.events_a, &pair.events_b}) {
    for (const VertexEvent& event : *events) {
      first = std::min(first, event.time);
      deepest = std::min(deepest, event.gap);
    }
  }
  for (const Contact& contact : connected_contacts(pair, 1e-9, RowChoice::deepest)) {
    volume += contact.volume;
  }
  print("first_contact", first);
  print("deepest_gap_and_volume", VectorXd{{deepest, volume}});
}

void chapter_11() {
  MatrixXd chain = 2.0 * MatrixXd::Identity(9, 9);
  chain.diagonal(1).setConstant(-1.0);
  chain.diagonal(-1).setConstant(-1.0);
  const LcpResult row = lemke({chain, ArrayXd::LinSpaced(9, 0.0, 8.0).cos() + 0.1});
  print("forces", row.z);
  print("pivots_of_chain", row.iterations);
  for (const Index m : {4, 6, 8}) {
    MatrixXd murty = MatrixXd::Identity(m, m);
    murty.triangularView<Eigen::StrictlyLower>().setConstant(2.0);
    print("pivots_of_murty_" + std::to_string(m),
          lemke({murty, VectorXd::Constant(m, -1.0)}).iterations);
  }
  print("two_forces", lemke({MatrixXd{{1.0, -0.4}, {-0.4, 0.8}}, VectorXd{{-1.0, -0.3}}}).z);
}

void chapter_12() {
  Scene scene;
  scene.flow = ShearFlow{.rate = 1.0};
  scene.solver.tolerance = 1e-11;
  scene.bodies = {Body{.shape = Circle{1.0}, .position = {-3.0, 0.8}},
                  Body{.shape = Ellipse{1.2, 0.5}, .position = {3.0, -0.8}, .orientation = 0.6}};
  const SuspensionSolver solver(scene);
  const auto velocities = [&](const VectorXd& state) -> VectorXd {
    const Solution solution = solver.solve(solver.instant(to_configuration(state)));
    VectorXd values(6);
    values << values_of(solution.motions[0]), values_of(solution.motions[1]);
    return values;
  };
  const VectorXd start = to_state(solver.start().configuration), rate = velocities(start);
  print("velocities", rate);
  print("state_after_a_step", start + 0.05 * (rate + velocities(start + 0.1 * rate)));
}

void chapter_13() {
  for (const auto& [name, gap, n] :
       {std::tuple{"2.0", 2.0, 48}, {"1.0", 1.0, 72}, {"0.5", 0.5, 96}, {"0.2", 0.2, 192}}) {
    const CauchyCurve circle(sample(Circle{1.0}, n, Side::fluid_outside));
    const Index size = 2 * n;
    const MatrixXd inverse = invert_block(self_block(free_body(circle.curve(), 0.0)));
    const RigidModeMatrices rigid = rigid_mode_matrices(circle.curve(), 0.0);
    MatrixXd matrix = MatrixXd::Identity(2 * size, 2 * size);
    for (const Index target : {0, 1}) {
      const Complex shift = (target == 0 ? -1.0 : 1.0) * (2.0 + gap);
      const MatrixXd layer = circle.velocity_rows(circle.curve().x.array() + shift);
      matrix.block(target * size, (1 - target) * size, size, size) =
          (layer - layer * rigid.modes * rigid.projection) * inverse;
    }
    const VectorXd eigenvalues = test::eigenvalues(matrix).real();
    print(std::string("least_and_largest_") + name,
          VectorXd{{eigenvalues.minCoeff(), eigenvalues.maxCoeff()}});
  }
}

void chapter_14() {
  for (const auto& [name, shear] :
       {std::pair{"0.0", 0.0}, {"0.1", 0.1}, {"0.3", 0.3}, {"0.5", 0.5}}) {
    test::Cell cell = test::disk_in_a_cell(1.0, {shear, 1.0}, 0.3, 96);
    test::set_shear(cell);
    const test::CellMotion disk = test::solve(cell, {44, 100000}).bodies[0];
    print(std::string("disk_at_") + name,
          VectorXd{{disk.omega, disk.stresslet.imag(), 2.0 * disk.stresslet.real()}});
    constexpr double small = 0.2;  // radius of a disk without near images
    const Complex sum = far_sums(cell.lattice, small, 1).s[2] / (small * small);
    print(std::string("sum_at_") + name, VectorXd{{1.0 + sum.real(), sum.imag()}});
  }
}

}  // namespace

int main() {
  const std::vector<std::pair<const char*, void (*)()>> chapters{
      {"01", chapter_01}, {"02", chapter_02}, {"03", chapter_03}, {"04", chapter_04},
      {"05", chapter_05}, {"06", chapter_06}, {"07", chapter_07}, {"08", chapter_08},
      {"09", chapter_09}, {"10", chapter_10}, {"11", chapter_11}, {"12", chapter_12},
      {"13", chapter_13}, {"14", chapter_14}};
  for (const auto& [number, compute] : chapters) {
    chapter = number;
    compute();
  }
}
