// Check of exercise 04.3: rank, singularity and flows of what the reader adds; diagnoses.
#include "chapters/check.hpp"

#include <array>
#include <optional>

#include "closure/bordered_system.hpp"
#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"
#include "support/dense.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;

double share(const StokesProblem& problem, const MatrixXd& matrix, std::size_t k);
MatrixXd useless(const StokesProblem& problem);
MatrixXd elsewhere(const StokesProblem& problem);
std::string diagnose(const StokesProblem& problem, const MatrixXd& matrix);

namespace {

struct Case {
  std::string name;
  double inner, outer, eccentricity;
};

const std::vector<Case> cases{{"radii 1 and 2", 1.0, 2.0, 0.3},
                              {"radii 0.04 and 0.1", 0.04, 0.1, 0.0}};

// A circle that moves and turns in a wall at rest.
StokesProblem problem_of(const Case& c) {
  constexpr Index nodes = 48;
  Component circle, wall;
  circle.kind = ComponentKind::prescribed;
  circle.curve = sample(Circle{c.inner}, nodes, Side::fluid_outside);
  circle.velocity = Complex{0.3, -0.2} + (imaginary * circle.curve.x / c.inner).array();
  wall.kind = ComponentKind::enclosing_wall;
  wall.centre = {0.0, c.eccentricity};
  wall.curve = place(sample(Circle{c.outer}, nodes, Side::fluid_inside), wall.centre, 0.0);
  wall.velocity = ComplexVector::Zero(nodes);
  return {{circle, wall}, 1.0, {}, {}};
}

MatrixXd singular(const StokesProblem& problem) {
  return assemble(problem, ClosureForm::reduced).matrix;
}

// N_0 of a component in its block.
MatrixXd fix_of(const StokesProblem& problem, std::size_t k) {
  const Curve& curve = problem.components[k].curve;
  const std::vector<Index> offsets = node_offsets(problem);
  const Index size = 2 * curve.size();
  MatrixXd matrix = MatrixXd::Zero(2 * offsets.back(), 2 * offsets.back());
  matrix.block(2 * offsets[k], 2 * offsets[k], size, size) = null_space_matrix(curve);
  return matrix;
}

struct Addition {
  std::string name;
  std::function<MatrixXd(const StokesProblem&)> matrix;
};

const std::vector<Addition> additions{
    {"nothing", [](const StokesProblem& p) -> MatrixXd { return 0.0 * fix_of(p, 1); }},
    {"right", [](const StokesProblem& p) { return fix_of(p, 1); }},
    {"sign", [](const StokesProblem& p) -> MatrixXd { return -fix_of(p, 1); }},
    {"unscaled",
     [](const StokesProblem& p) -> MatrixXd {
       return perimeter(p.components[1].curve) * fix_of(p, 1);
     }},
    {"inner", [](const StokesProblem& p) { return fix_of(p, 0); }}};

// n^T W A n_k over the block rows of one component, or of all for none.
double flux_of_image(const StokesProblem& problem, const MatrixXd& matrix, std::size_t k,
                     std::optional<std::size_t> rows) {
  const std::vector<Index> offsets = node_offsets(problem);
  ComplexVector left = ComplexVector::Zero(offsets.back()), right = left;
  for (std::size_t j = 0; j < problem.components.size(); ++j) {
    const Curve& curve = problem.components[j].curve;
    const ComplexVector normal = normals(curve);
    if (!rows || *rows == j) {
      left.segment(offsets[j], curve.size()) = normal.cwiseProduct(weights(curve));
    }
    if (k == j) right.segment(offsets[j], curve.size()) = normal;
  }
  const VectorXd image = matrix * interleaved(right);
  return interleaved(left).dot(image);
}

void check_share(const Case& c) {
  const StokesProblem problem = problem_of(c);
  for (std::size_t k : {0, 1}) {
    // Of a matrix that has all kinds of shares.
    const MatrixXd matrix = singular(problem) + 0.3 * fix_of(problem, 0) +
                            2.0 * fix_of(problem, 1) + 0.7 * MatrixXd::Identity(4 * 48, 4 * 48);
    const double length = perimeter(problem.components[k].curve);
    const double exact = flux_of_image(problem, matrix, k, {}) / length;
    expect({.what = c.name + ", component " + std::to_string(k),
            .got = share(problem, matrix, k),
            .expected = exact,
            .tolerance = 1e-10,
            .mistakes = {{flux_of_image(problem, matrix, k, k) / length,
                          "the integral is over both curves: a density on one makes velocities on "
                          "the other"},
                         {exact * length, "this is the integral, not divided by the length"},
                         {-exact, "the sign is the other one"}}});
  }
}

// 1 where a matrix is singular but for the error of 48 nodes and rounding.
double is_singular(const MatrixXd& matrix) {
  return test::inverse(matrix).norm() > 1e7 ? 1.0 : 0.0;
}

// Whether a matrix is u v^T, u v^T != 0; the size of the problem is right.
void check_rank_one(const std::string& name, const StokesProblem& problem, const MatrixXd& added) {
  const Index size = 2 * node_offsets(problem).back();
  expect(
      {.what = name + ", rows and columns",
       .got = Eigen::Vector2d{static_cast<double>(added.rows()), static_cast<double>(added.cols())},
       .expected = Eigen::Vector2d::Constant(static_cast<double>(size)),
       .tolerance = 0.0});
  if (!(added.norm() >= 0.1)) {
    throw exercise::Rejection{exercise::line("for", name) +
                              exercise::line("mistake", "this adds nothing, or next to nothing")};
  }
  Index row = 0, column = 0;
  added.cwiseAbs().maxCoeff(&row, &column);
  const MatrixXd rest = added - added.col(column) * added.row(row) / added(row, column);
  if (!(rest.norm() <= 1e-9 * added.norm())) {
    throw exercise::Rejection{
        exercise::line("for", name) +
        exercise::line("mistake", "this has more than one independent column: not of rank one")};
  }
}

void check_useless(const Case& c) {
  const StokesProblem problem = problem_of(c);
  const MatrixXd added = useless(problem);
  check_rank_one(c.name, problem, added);
  expect({.what = c.name + ", whether the sum is singular (1: yes)",
          .got = is_singular(singular(problem) + added),
          .expected = 1.0,
          .tolerance = 0.0,
          .mistakes = {{0.0,
                        "this repairs the system: let the column have no net flux, or the row "
                        "not see the invisible density"}}});
}

// Load of the circle for data with a net flux, of which a part is taken off by a normal velocity.
Eigen::Vector3d load(const StokesProblem& problem, const MatrixXd& matrix) {
  const VectorXd rhs = assemble(problem, ClosureForm::reduced).rhs;
  const Load result =
      complete_dense(problem, ClosureForm::reduced, test::solve(matrix, rhs)).loads[0];
  return {result.force.real(), result.force.imag(), result.torque};
}

StokesProblem leaking(const Case& c) {
  StokesProblem problem = problem_of(c);
  Component& wall = problem.components[1];
  const ComplexVector n = normals(wall.curve);
  wall.velocity = 0.2 * n.array() * (1.0 + n.array().real());
  return problem;
}

// The net flux taken off evenly, where `on` has true.
StokesProblem mended(StokesProblem problem, std::array<bool, 2> on) {
  const double flux = net_flux(problem);
  double length = 0.0;
  for (std::size_t k : {0, 1}) {
    if (on[k]) length += perimeter(problem.components[k].curve);
  }
  for (std::size_t k : {0, 1}) {
    Component& component = problem.components[k];
    if (on[k]) component.velocity -= flux / length * normals(component.curve);
  }
  return problem;
}

void check_elsewhere(const Case& c) {
  const StokesProblem problem = leaking(c);
  const MatrixXd added = elsewhere(problem), bare = singular(problem);
  check_rank_one(c.name, problem, added);
  expect({.what = c.name + ", whether the sum is singular (1: yes)",
          .got = is_singular(bare + added),
          .expected = 0.0,
          .tolerance = 0.0,
          .mistakes = {{1.0,
                        "the row does not see the invisible density, which lives on the wall; "
                        "or the column has no net flux"}}});
  const MatrixXd right = bare + fix_of(problem, 1);
  const auto exact = [&](std::array<bool, 2> on) { return load(mended(problem, on), right); };
  expect({.what = c.name + ", the load of data with a net flux",
          .got = load(problem, bare + added),
          .expected = exact({true, false}),
          .tolerance = 1e-8,
          .mistakes = {{exact({false, true}), "this takes the flux off on the wall: it is N_0"},
                       {exact({true, true}), "this takes the flux off on both curves"}}});
}

void check_diagnosis(const Case& c) {
  const StokesProblem problem = problem_of(c);
  for (const Addition& addition : additions) {
    const std::string got = diagnose(problem, singular(problem) + addition.matrix(problem));
    if (got == addition.name) continue;
    throw exercise::Rejection{
        exercise::line("for", c.name) + exercise::line("got", got) +
        exercise::line("expected", addition.name) +
        exercise::line("mistake", "found " + got + ", but it was " + addition.name)};
  }
}

// Calls a check for every case.
std::function<void()> for_all(void (*check)(const Case&)) {
  return [check] {
    for (const Case& c : cases) check(c);
  };
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the share of a component",
        .formula = "n^T W A n_k / |Gamma_k|, n and W on both curves",
        .hint = "sum over the rows of both components",
        .check = for_all(check_share)},
       {.title = "a useless matrix",
        .formula = "A + u v^T with int n.u ds = 0, or v without the wall's normal",
        .hint = "the tangent of the wall has no flux",
        .check = for_all(check_useless)},
       {.title = "the flux taken off elsewhere",
        .formula = "A + u v^T with u the normal of the circle, v that of the wall, weighted",
        .hint = "n from the left shows what is taken off the data: -u int v.eta",
        .check = for_all(check_elsewhere)},
       {.title = "the diagnosis",
        .builds_on = {1},
        .formula = "the shares are those of what was added",
        .hint = "task 1 holds all that is needed",
        .check = for_all(check_diagnosis)}});
}
