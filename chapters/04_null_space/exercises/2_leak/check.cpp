// Check of exercise 04.2: matrices, fluxes and mended data against the book's; the experiment.
#include "chapters/check.hpp"

#include <algorithm>
#include <fstream>
#include <numbers>

#include "closure/bordered_system.hpp"
#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"
#include "study/plot.hpp"
#include "support/dense.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;

Eigen::MatrixXd with_n0(const StokesProblem& problem);
double flux_of_data(const StokesProblem& problem);
StokesProblem mended(StokesProblem problem);
double tolerable_leak(double tolerance);

namespace {

enum class Order { shaft_first, wall_first };

// A speed through a circle: a mean, and parts that carry no flux.
ComplexVector through(const Curve& curve, double mean) {
  const ComplexVector n = normals(curve);
  return mean * n.array() * (1.0 + n.array().real() - 0.5 * n.array().imag());
}

// A porous shaft that turns and moves in an eccentric bushing; what comes in through the shaft goes
// out through the bushing, and a part `leak` of flux_scale() more.
StokesProblem bearing(double leak, Order order = Order::shaft_first) {
  constexpr Index nodes = 60;
  constexpr double blown = 0.3;
  Component shaft, bushing;
  shaft.kind = ComponentKind::prescribed;
  shaft.curve = sample(Circle{1.0}, nodes, Side::fluid_outside);
  shaft.velocity = Complex{0.3, -0.2} + (imaginary * shaft.curve.x).array();
  shaft.velocity -= blown / (2.0 * pi) * normals(shaft.curve);
  bushing.kind = ComponentKind::enclosing_wall;
  bushing.centre = {0.4, 0.3};
  bushing.curve = place(sample(Circle{2.0}, nodes + 4, Side::fluid_inside), bushing.centre, 0.0);
  bushing.velocity = through(bushing.curve, blown / (4.0 * pi));
  const double scale = flux_scale({{shaft, bushing}, 1.0, {}, {}});
  bushing.velocity += through(bushing.curve, leak * scale / (4.0 * pi));
  if (order == Order::wall_first) return {{bushing, shaft}, 1.0, {}, {}};
  return {{shaft, bushing}, 1.0, {}, {}};
}

Eigen::Vector3d load_of_shaft(const StokesProblem& problem, const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd rhs = assemble(problem, ClosureForm::reduced).rhs;
  const Completion completion =
      complete_dense(problem, ClosureForm::reduced, test::solve(matrix, rhs));
  const bool first = problem.components[0].kind == ComponentKind::prescribed;
  const Load load = completion.loads[first ? 0 : 1];
  return {load.force.real(), load.force.imag(), load.torque};
}

Eigen::MatrixXd matrix_without(const StokesProblem& problem) {
  return assemble(problem, ClosureForm::reduced).matrix;
}

double difference(const Eigen::Vector3d& load, const Eigen::Vector3d& exact) {
  return (load - exact).norm() / exact.norm();
}

// The load before anything leaked.
Eigen::Vector3d tight_load() {
  const StokesProblem tight = bearing(0.0);
  return load_of_shaft(tight, with_n0(tight));
}

}  // namespace

double load_error(double leak) {
  const StokesProblem problem = bearing(leak);
  return difference(load_of_shaft(problem, with_n0(problem)), tight_load());
}

namespace {

// What a matrix has in addition to that of assemble(), applied to normals on one component.
ComplexVector added(const StokesProblem& problem, const Eigen::MatrixXd& matrix, std::size_t on) {
  const std::vector<Index> offsets = node_offsets(problem);
  const Curve& curve = problem.components[on].curve;
  ComplexVector v = ComplexVector::Zero(offsets.back());
  v.segment(offsets[on], curve.size()) = normals(curve);
  const Eigen::VectorXd image = (matrix - matrix_without(problem)) * interleaved(v);
  return deinterleaved(image);
}

void check_matrix(Order order) {
  const StokesProblem problem = bearing(0.1, order);
  const std::size_t shaft = order == Order::shaft_first ? 0 : 1, wall = 1 - shaft;
  const Index nodes = node_offsets(problem).back();
  const Eigen::MatrixXd matrix = with_n0(problem);
  const std::string where = order == Order::shaft_first ? "the wall is the second component"
                                                        : "the wall is the first component";
  if (matrix.rows() != 2 * nodes || matrix.cols() != 2 * nodes) {
    throw exercise::Rejection{
        exercise::line("for", where) +
        exercise::difference(static_cast<double>(matrix.rows()), static_cast<double>(2 * nodes))};
  }
  const ComplexVector none = ComplexVector::Zero(nodes);
  ComplexVector normal_on_wall = none, normal_on_shaft = none;
  const std::vector<Index> offsets = node_offsets(problem);
  const auto place_normals = [&](ComplexVector& v, std::size_t k) {
    v.segment(offsets[k], problem.components[k].curve.size()) =
        normals(problem.components[k].curve);
  };
  place_normals(normal_on_wall, wall);
  place_normals(normal_on_shaft, shaft);
  const double length = perimeter(problem.components[wall].curve);
  expect(
      {.what = where + ": what N_0 makes of the normals of the wall",
       .got = added(problem, matrix, wall),
       .expected = ComplexVector(-normal_on_wall),
       .tolerance = 1e-11,
       .mistakes = {{none, "N_0 is missing: assemble() leaves it out"},
                    {normal_on_wall, "the sign is the other one"},
                    {ComplexVector(-length * normal_on_wall), "it is not divided by the length"}}});
  expect({.what = where + ": what N_0 makes of the normals of the shaft",
          .got = added(problem, matrix, shaft),
          .expected = none,
          .tolerance = 1e-11,
          .mistakes = {{ComplexVector(-normal_on_shaft), "N_0 acts on the enclosing wall only"}}});
}

void check_order() {
  const StokesProblem problem = bearing(0.1, Order::wall_first);
  const Eigen::MatrixXd matrix = with_n0(problem);
  const Curve& wall = problem.components[0].curve;
  const Index size = 2 * wall.size();
  Eigen::MatrixXd last = matrix_without(problem);
  if (matrix.rows() == last.rows() && matrix.cols() == last.cols()) {
    last.bottomRightCorner(size, size) += null_space_matrix(wall);
    if ((matrix - last).norm() < 1e-9) {
      throw exercise::Rejection{
          exercise::line("for", "the wall is the first component") +
          exercise::line("mistake", "here the wall is not the last component: use its offset")};
    }
  }
  check_matrix(Order::wall_first);
}

double flux_through(const Component& component) {
  return normals(component.curve)
      .conjugate()
      .cwiseProduct(component.velocity)
      .real()
      .dot(weights(component.curve));
}

void check_flux(double leak, Order order) {
  const StokesProblem problem = bearing(leak, order);
  const std::size_t wall = order == Order::shaft_first ? 1 : 0;
  double unweighted = 0.0, sum = 0.0;
  for (const Component& component : problem.components) {
    unweighted += normals(component.curve).dot(component.velocity).real();
    sum += std::abs(flux_through(component));
  }
  const double exact = net_flux(problem);
  expect(
      {.what = "leak " + exercise::text(leak),
       .got = flux_of_data(problem),
       .expected = exact,
       .tolerance = 1e-11,
       .mistakes = {{-exact, "this is what flows in"},
                    {flux_through(problem.components[wall]),
                     "the shaft is porous too: all prescribed velocities count"},
                    {unweighted, "the weights of the nodes are missing"},
                    {sum, "the normal of the shaft points out of the fluid: fluxes have signs"}}});
}

void check_mended(Order order) {
  const StokesProblem problem = bearing(0.05, order), got = mended(problem);
  const std::size_t wall = order == Order::shaft_first ? 1 : 0, shaft = 1 - wall;
  const auto without_own_flux = [&](std::size_t k) -> ComplexVector {
    const Component& component = problem.components[k];
    return component.velocity -
           flux_through(component) / perimeter(component.curve) * normals(component.curve);
  };
  expect({.what = "velocities of the shaft",
          .got = got.components[shaft].velocity,
          .expected = problem.components[shaft].velocity,
          .tolerance = 1e-12,
          .mistakes = {{without_own_flux(shaft),
                        "flow through the shaft is allowed: every curve keeps its own flux but the "
                        "enclosing wall"}}});
  const Curve& curve = problem.components[wall].curve;
  const ComplexVector& g = problem.components[wall].velocity;
  const ComplexVector n = normals(curve);
  const double flux = net_flux(problem), length = perimeter(curve);
  const ComplexVector exact = g - flux / length * n;
  const ComplexVector tight = g.array() - n.array() * (n.conjugate().array() * g.array()).real();
  expect({.what = "velocities of the wall",
          .got = got.components[wall].velocity,
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{g, "nothing is taken off"},
                       {tight, "this takes off all that passes through the wall"},
                       {without_own_flux(wall),
                        "this is the wall's own flux: the shaft's balances a part of it"},
                       {ComplexVector(g - flux * n), "the flux is not divided by the length"},
                       {ComplexVector(g + flux / length * n), "this doubles the leak"}}});
}

// Checks what the experiment needs of tasks 1 and 3: with a wrong sign in both, it would agree with
// itself.
void check_parts() {
  const StokesProblem leaky = bearing(0.05);
  expect({.what = "the net flux of the mended data, over that of the data",
          .got = net_flux(mended(leaky)) / net_flux(leaky),
          .expected = 0.0,
          .tolerance = 1e-11,
          .mistakes = {{1.0, "mended() leaves the flux as it is: see task 3"},
                       {2.0, "mended() doubles the leak: see task 3"}}});
  Eigen::MatrixXd matrix = matrix_without(leaky);
  const Curve& wall = leaky.components[1].curve;
  matrix.bottomRightCorner(2 * wall.size(), 2 * wall.size()) += null_space_matrix(wall);
  expect({.what = "the load of the shaft, a leak of 0.05",
          .got = load_of_shaft(leaky, with_n0(leaky)),
          .expected = load_of_shaft(leaky, matrix),
          .tolerance = 1e-10});
}

// Errors of the load over the leak; writes leak.csv and leak.svg.
void check_experiment() {
  check_parts();
  std::ofstream table("leak.csv");
  table << "leak,with_n0,without,against_mended\n";
  const Eigen::Vector3d tight = tight_load();
  study::PlotLine with{"with N_0"}, without{"without"}, repaired{"with N_0, against mended data"};
  for (int k = -13; k <= -1; ++k) {
    const double leak = std::pow(10.0, k);
    const StokesProblem problem = bearing(leak), patched = mended(problem);
    const Eigen::Vector3d load = load_of_shaft(problem, with_n0(problem));
    const Eigen::Vector3d bare = load_of_shaft(problem, matrix_without(problem));
    with.points.push_back({leak, difference(load, tight)});
    without.points.push_back({leak, difference(bare, tight)});
    repaired.points.push_back({leak, difference(load, load_of_shaft(patched, with_n0(patched)))});
    table << leak << ',' << with.points.back().y << ',' << without.points.back().y << ','
          << repaired.points.back().y << '\n';
  }
  std::ofstream("leak.svg") << study::draw_plot({.title = "Error of the load by the leak",
                                                 .x_label = "relative net flux of the data",
                                                 .y_label = "difference of the load, relative",
                                                 .lines = {with, without, repaired}});
  expect({.what = "the error with N_0, a leak of 1e-2 over one of 1e-6",
          .got = with.points[11].y / with.points[7].y,
          .expected = 1e4,
          .tolerance = 1e-5});
  double largest = 0.0;
  for (const study::PlotPoint& point : repaired.points) largest = std::max(largest, point.y);
  expect({.what = "the largest difference from the load of the mended data",
          .got = largest,
          .expected = 0.0,
          .tolerance = 1e-11});
}

void check_tolerable(double tolerance) {
  const double leak = tolerable_leak(tolerance);
  const double exact = 0.01 * tolerance / load_error(0.01);
  expect({.what = "tolerance " + exercise::text(tolerance),
          .got = leak,
          .expected = exact,
          .tolerance = 1e-5,
          .mistakes = {{tolerance, "an error is not as large as its leak: measure the factor"},
                       {load_error(tolerance), "this is the error of a leak, not the leak"},
                       {1e-3 * std::sqrt(tolerance / load_error(1e-3)),
                        "the error is proportional to the leak: no square root"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the matrix with N_0",
        .formula = "N_0 eta = -n/|Gamma_0| int n.eta ds, for targets and sources on the wall",
        .hint = "null_space_matrix(), at twice the offset of the enclosing wall",
        .check =
            [] {
              check_matrix(Order::shaft_first);
              check_order();
            }},
       {.title = "the flux of the data",
        .formula = "sum_j w_j n_j.g_j over all nodes with given velocities",
        .hint = "normals() point out of the fluid on every curve",
        .check =
            [] {
              check_flux(0.2, Order::shaft_first);
              check_flux(-0.01, Order::wall_first);
            }},
       {.title = "the mended data",
        .builds_on = {2},
        .formula = "g - n Q/|Gamma_0| on the enclosing wall",
        .hint = "Q is the net flux of task 2",
        .check =
            [] {
              for (Order order : {Order::shaft_first, Order::wall_first}) check_mended(order);
            }},
       {.title = "the experiment",
        .builds_on = {1, 3},
        .formula = "the load with N_0 is that of the mended data",
        .hint = "look at leak.svg; the tasks before come first",
        .check = check_experiment},
       {.title = "the tolerable leak",
        .builds_on = {1},
        .formula = "leak / tolerance = any leak / its error",
        .hint = "measure one error, of a leak that is neither tiny nor huge",
        .check = [] {
          for (double tolerance : {1e-2, 1e-6}) check_tolerable(tolerance);
        }}});
}
