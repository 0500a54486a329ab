// Check of exercise 13.3: held and released bodies against the book's matrices; the experiment.
#include "chapters/check.hpp"

#include <fstream>
#include <numbers>
#include <utility>

#include "closure/bordered_system.hpp"
#include "krylov/block_diagonal.hpp"
#include "krylov/gmres.hpp"
#include "preconditioning/cluster_preconditioner.hpp"
#include "study/plot.hpp"
#include "support/dense.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;
using std::numbers::pi;

struct Bodies {
  MatrixXd free, flows, modes, projection;
};

MatrixXd held_inverse(const Bodies& bodies);
MatrixXd resistance(const MatrixXd& inverse_of_held, const Bodies& bodies);
VectorXd release(const MatrixXd& inverse_of_held, const MatrixXd& resistances, const Bodies& bodies,
                 const VectorXd& r);
VectorXd preconditioned(const MatrixXd& nearly_inverse, const Bodies& bodies, const VectorXd& r);

MatrixXd inverse(const MatrixXd& matrix) {
  return test::inverse(matrix);
}

VectorXd solve(const MatrixXd& matrix, const VectorXd& rhs) {
  return test::solve(matrix, rhs);
}

namespace {

// Free bodies, and the same bodies held, with their matrices.
struct Scene {
  std::string name;
  StokesProblem problem, held;
  Bodies bodies;
  MatrixXd matrix_of_held;

  std::size_t count() const { return problem.components.size(); }
};

Scene scene_of(const std::string& name, const std::vector<Component>& components) {
  Scene scene{name, {components, 1.0, {}, {}}, {components, 1.0, {}, {}}, {}, {}};
  scene.held.gauge_length = held_gauge(scene.problem);
  for (Component& component : scene.held.components) {
    component.kind = ComponentKind::prescribed;
    component.velocity = ComplexVector::Zero(component.curve.size());
  }
  const std::vector<Index> offsets = node_offsets(scene.problem);
  const Index n = offsets.back(), motions = 3 * static_cast<Index>(scene.count());
  const Closure closure(scene.held);
  Bodies& bodies = scene.bodies;
  bodies.flows = MatrixXd::Zero(2 * n, motions);
  bodies.modes = MatrixXd::Zero(2 * n, motions);
  bodies.projection = MatrixXd::Zero(motions, 2 * n);
  for (std::size_t k = 0; k < scene.count(); ++k) {
    const Component& component = components[k];
    const RigidModeMatrices rigid = rigid_mode_matrices(component.curve, component.centre);
    const Index first = 2 * offsets[k], size = 2 * component.curve.size();
    const Index motion = 3 * static_cast<Index>(k);
    bodies.modes.block(first, motion, size, 3) = rigid.modes;
    bodies.projection.block(motion, first, 3, size) = rigid.projection;
    bodies.flows.middleCols(motion, 3) = closed_modes(closure, rigid.modes, offsets[k], n);
  }
  bodies.free = assemble(scene.problem, ClosureForm::reduced).matrix;
  scene.matrix_of_held = assemble(scene.held, ClosureForm::reduced).matrix;
  return scene;
}

Component body(const Curve& reference, Complex centre, double angle) {
  return {ComponentKind::free_body, place(reference, centre, angle), centre, {}, 0.0, {}};
}

Scene two_disks() {
  return scene_of("two disks",
                  {body(sample(Circle{1.0}, 20, Side::fluid_outside), {}, 0.0),
                   body(sample(Circle{0.6}, 16, Side::fluid_outside), {2.0, 1.1}, 0.0)});
}

Scene three_bodies() {
  const Curve ellipse = sample(Ellipse{1.0, 0.6}, 24, Side::fluid_outside);
  return scene_of("three bodies",
                  {body(ellipse, {}, 0.4), body(ellipse, {0.3, 2.6}, -0.9),
                   body(sample(Circle{0.7}, 20, Side::fluid_outside), {2.2, 1.2}, 0.0)});
}

VectorXd as_vector(const MatrixXd& matrix) {
  return matrix.reshaped();
}

// Data without a symmetry, which are no motion of the bodies.
VectorXd generic_data(Index size) {
  return VectorXd::NullaryExpr(size, [](Index i) {
    const auto x = static_cast<double>(i);
    return std::sin(0.7 * x + 0.03 * x * x);
  });
}

void check_size(const std::string& what, const MatrixXd& got, Index size) {
  if (got.rows() == size && got.cols() == size) return;
  throw exercise::Rejection{
      exercise::line("for", what + ": number of rows, columns") +
      exercise::line("got", std::to_string(got.rows()) + ", " + std::to_string(got.cols())) +
      exercise::line("expected", std::to_string(size) + ", " + std::to_string(size))};
}

void check_held(const Scene& scene) {
  const Bodies& bodies = scene.bodies;
  const MatrixXd got = held_inverse(bodies);
  check_size(scene.name, got, bodies.free.rows());
  if (!(got.norm() < 1e8)) {
    throw exercise::Rejection{
        exercise::line("for", scene.name) +
        exercise::line("mistake",
                       "A + K Pi is singular: without the flows of their loads, held bodies have "
                       "no condition on their rigid parts")};
  }
  const MatrixXd added = (bodies.flows + bodies.modes) * bodies.projection;
  expect(
      {.what = scene.name + ": A_h^-1, column by column",
       .got = as_vector(got),
       .expected = as_vector(test::inverse(scene.matrix_of_held)),
       .tolerance = 1e-9,
       .mistakes = {{as_vector(test::inverse(bodies.free + bodies.flows * bodies.projection)),
                     "the motions -K Pi of free bodies are still in it"},
                    {as_vector(test::inverse(bodies.free - added)),
                     "both terms have the other sign: A = A_h - (S + K) Pi"},
                    {as_vector(test::inverse(bodies.free)), "this is the inverse for free bodies"},
                    {as_vector(bodies.free + added), "this is A_h, not its inverse"}}});
}

// Loads of the held bodies, one of which moves: -F / (4 pi mu) and -L / (4 pi mu a).
MatrixXd loads_of_moved_bodies(const Scene& scene) {
  const Index motions = scene.bodies.modes.cols();
  MatrixXd loads(motions, motions);
  for (Index motion = 0; motion < motions; ++motion) {
    const VectorXd density = test::solve(scene.matrix_of_held, scene.bodies.modes.col(motion));
    const Completion completion = complete_dense(scene.held, ClosureForm::reduced, density);
    for (std::size_t k = 0; k < scene.count(); ++k) {
      const Component& component = scene.problem.components[k];
      const double radius = RigidModes(component.curve, component.centre).gyration_radius();
      const auto& [force, torque] = completion.loads[k];
      loads.col(motion).segment<3>(3 * static_cast<Index>(k)) =
          -Eigen::Vector3d{force.real(), force.imag(), torque / radius} / (4.0 * pi);
    }
  }
  return loads;
}

void check_resistance(const Scene& scene) {
  const Bodies& bodies = scene.bodies;
  const MatrixXd held = test::inverse(scene.matrix_of_held);
  const MatrixXd got = resistance(held, bodies), exact = loads_of_moved_bodies(scene);
  check_size(scene.name, got, exact.rows());
  const MatrixXd unit = MatrixXd::Identity(exact.rows(), exact.cols());
  expect({.what = scene.name + ": R, column by column",
          .got = as_vector(got),
          .expected = as_vector(exact),
          .tolerance = 1e-9,
          .mistakes = {
              {as_vector(-unit),
               "this is the matrix of free bodies: without loads they move as the data, with -K"},
              {as_vector(unit), "the data of bodies that move are K, not S: A_h^-1 S is K"},
              {as_vector(test::inverse(exact)), "this is the inverse of R, the mobility matrix"},
              {as_vector(-exact), "the sign: R = Pi A_h^-1 K has no minus"}}});
}

void check_release(const Scene& scene) {
  const Bodies& bodies = scene.bodies;
  const MatrixXd held = test::inverse(scene.matrix_of_held);
  const MatrixXd resistances = bodies.projection * held * bodies.modes;
  const VectorXd r = generic_data(held.rows()), first = held * r;
  const VectorXd loads = bodies.projection * first;
  const VectorXd velocities = bodies.modes * test::solve(resistances, loads);
  const VectorXd multiplied = bodies.modes * (resistances * loads);
  expect({.what = scene.name + ": A^-1 r",
          .got = release(held, resistances, bodies, r),
          .expected = test::solve(bodies.free, r),
          .tolerance = 1e-9,
          .mistakes = {
              {(held * (r + velocities) + velocities).eval(),
               "the sign of V: subtract the motions from the data, and -K V is the rigid part"},
              {(first - velocities).eval(),
               "solve once more with held bodies: the data without the motions are r - K V"},
              {(held * (r - velocities)).eval(), "the rigid part -K V is missing"},
              {(held * (r - velocities) + velocities).eval(), "the sign of the rigid part: -K V"},
              {first, "these bodies are still held: their loads are not zero"},
              {(held * (r - multiplied) - multiplied).eval(),
               "V is the solution of R V = loads, not R times the loads"}}});
}

// The distance of two bodies, between their centres.
double distance(const Scene& scene, std::size_t i, std::size_t j) {
  return std::abs(scene.problem.components[i].centre - scene.problem.components[j].centre);
}

// The rows of each body from the inverse of A_h for this body and all that are near it.
MatrixXd neighbours_inverse(const Scene& scene, double near) {
  const std::vector<Index> offsets = node_offsets(scene.problem);
  MatrixXd result = MatrixXd::Zero(2 * offsets.back(), 2 * offsets.back());
  for (std::size_t own = 0; own < scene.count(); ++own) {
    std::vector<Index> entries, rows;
    for (std::size_t other = 0; other < scene.count(); ++other) {
      if (distance(scene, own, other) > near) continue;
      for (Index i = 2 * offsets[other]; i < 2 * offsets[other + 1]; ++i) {
        if (other == own) rows.push_back(std::ssize(entries));
        entries.push_back(i);
      }
    }
    const MatrixXd of_cluster = test::inverse(scene.matrix_of_held(entries, entries));
    result(Eigen::seq(2 * offsets[own], 2 * offsets[own + 1] - 1), entries) =
        of_cluster(rows, Eigen::all);
  }
  return result;
}

// (13.5) with an approximate inverse H is the inverse of H^-1 (1 - (K + H K) Pi).
void check_preconditioned(const Scene& scene, double near) {
  const Bodies& bodies = scene.bodies;
  const MatrixXd held = test::inverse(scene.matrix_of_held);
  const MatrixXd nearly = neighbours_inverse(scene, near);
  const VectorXd r = generic_data(nearly.rows());
  const MatrixXd own = bodies.modes + nearly * bodies.modes;
  const MatrixXd unit = MatrixXd::Identity(nearly.rows(), nearly.rows());
  const VectorXd exact = test::solve(unit - own * bodies.projection, nearly * r);
  const VectorXd loads = bodies.projection * (nearly * r);
  const VectorXd velocities =
      bodies.modes * test::solve(bodies.projection * held * bodies.modes, loads);
  const VectorXd got = preconditioned(nearly, bodies, r);
  const std::string what = scene.name + ", neighbours up to " + exercise::text(near);
  expect(
      {.what = what,
       .got = got,
       .expected = exact,
       .tolerance = 1e-9,
       .mistakes = {{(nearly * (r - velocities) - velocities).eval(),
                     "this R belongs to another inverse: take the resistances of the given matrix"},
                    {(nearly * r).eval(), "these bodies are still held: release them"},
                    {test::solve(bodies.free, r),
                     "the matrix that was given is not used: this is the exact solution"}}});
}

Scene hexagon() {
  constexpr double gap = 0.4;
  const Curve disk = sample(Circle{1.0}, 28, Side::fluid_outside);
  std::vector<Component> disks{body(disk, {}, 0.0)};
  for (int k = 0; k < 6; ++k) {
    disks.push_back(body(disk, std::polar(2.0 + gap, pi * k / 3.0), 0.0));
  }
  return scene_of("seven disks", disks);
}

// Residuals of GMRES; writes residuals.csv and residuals.svg.
void check_experiment() {
  const Scene scene = hexagon();
  const Bodies& bodies = scene.bodies;
  const MatrixXd held = held_inverse(bodies), exact = resistance(held, bodies);
  const MatrixXd nearly = neighbours_inverse(scene, 2.5);
  const VectorXd data = generic_data(bodies.free.rows());
  const auto residuals = [&](const LinearMap& precondition) {
    return gmres([&](const VectorXd& v) -> VectorXd { return bodies.free * v; }, precondition, data,
                 {1e-9, 60})
        .history;
  };
  const std::vector<std::pair<std::string, std::vector<double>>> courses{
      {"no preconditioner", residuals({})},
      {"held disks, their own resistances",
       residuals([&](const VectorXd& v) { return preconditioned(nearly, bodies, v); })},
      {"held disks, exact resistances",
       residuals([&](const VectorXd& v) { return release(nearly, exact, bodies, v); })},
      {"held disks, exact inverse",
       residuals([&](const VectorXd& v) { return release(held, exact, bodies, v); })}};
  std::ofstream table("residuals.csv");
  table << "preconditioner,iteration,residual\n";
  std::vector<study::PlotLine> lines;
  for (const auto& [name, history] : courses) {
    study::PlotLine line{name};
    for (std::size_t k = 0; k < history.size(); ++k) {
      line.points.push_back({static_cast<double>(k), history[k]});
      table << '"' << name << "\"," << k << ',' << history[k] << '\n';
    }
    lines.push_back(line);
  }
  std::ofstream("residuals.svg") << study::draw_plot({.title = "Residuals of GMRES, seven disks",
                                                      .x_label = "iteration",
                                                      .y_label = "relative residual",
                                                      .log_x = false,
                                                      .lines = lines});
  const auto iterations = [&](std::size_t course) {
    return std::ssize(courses[course].second) - 1;
  };
  const auto require = [](bool holds, const std::string& mistake) {
    if (holds) return;
    throw exercise::Rejection{exercise::line("for", "seven disks") +
                              exercise::line("mistake", mistake)};
  };
  require(iterations(3) <= 2, "the exact inverse takes " + std::to_string(iterations(3)) +
                                  " iterations, more than two: see tasks 1 to 3");
  require(iterations(1) < iterations(2),
          "its own resistances take " + std::to_string(iterations(1)) +
              " iterations, and the exact ones " + std::to_string(iterations(2)) +
              ": the own ones should take fewer, see task 4");
}

}  // namespace

int main() {
  return exercise::run({{.title = "the inverse for held bodies",
                         .formula = "A = A_h - (S + K) Pi",
                         .hint = "add what A lacks, then inverse()",
                         .check =
                             [] {
                               check_held(two_disks());
                               check_held(three_bodies());
                             }},
                        {.title = "the resistances",
                         .formula = "R = Pi A_h^-1 K",
                         .hint = "the data K, the density A_h^-1 K, its rigid parts",
                         .check =
                             [] {
                               check_resistance(two_disks());
                               check_resistance(three_bodies());
                             }},
                        {.title = "the release",
                         .formula = "R V = Pi A_h^-1 r, A^-1 r = A_h^-1 (r - K V) - K V",
                         .hint = "solve() for the motions; two products with A_h^-1",
                         .check =
                             [] {
                               check_release(two_disks());
                               check_release(three_bodies());
                             }},
                        {.title = "the preconditioner",
                         .builds_on = {2, 3},
                         .formula = "(13.5) with H for A_h^-1 everywhere, also in R = Pi H K",
                         .hint = "two calls of your own functions",
                         .check =
                             [] {
                               check_preconditioned(two_disks(), 1.0);
                               check_preconditioned(three_bodies(), 2.55);
                             }},
                        {.title = "the experiment",
                         .builds_on = {1, 2, 3, 4},
                         .formula = "the residual of GMRES after each iteration, for the two R",
                         .hint = "look at residuals.svg; the tasks before come first",
                         .check = check_experiment}});
}
