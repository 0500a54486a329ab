// Chapter 04: the load of a shaft in a bushing whose data leak, by solves with and without N_0.
#include <cmath>
#include <complex>

#include <Eigen/LU>

#include "closure/bordered_system.hpp"
#include "interactive/numbers.hpp"
#include "null_space/null_space.hpp"

namespace {

using stokesbook::Complex;

stokesbook::StokesProblem bearing_problem(Complex shaft_centre, double leak, Eigen::Index n) {
  using namespace stokesbook;
  Component shaft, bushing;
  shaft.kind = ComponentKind::prescribed;
  shaft.curve = place(sample(Circle{1.0}, n, Side::fluid_outside), shaft_centre, 0.0);
  shaft.centre = shaft_centre;
  shaft.velocity = imaginary * (shaft.curve.x.array() - shaft_centre);
  bushing.kind = ComponentKind::enclosing_wall;
  bushing.curve = sample(Circle{1.5}, n, Side::fluid_inside);
  const ComplexVector normal = normals(bushing.curve);
  bushing.velocity = leak * (1.0 + normal.array().real()) * normal.array();
  return {{shaft, bushing}, 1.0, {}, {}};
}

// The force of the fluid on the shaft, by the system with a multiple of N_0.
Complex force_on_shaft(const stokesbook::StokesProblem& problem, double factor) {
  using namespace stokesbook;
  DenseSystem system = assemble(problem, ClosureForm::reduced);
  const Curve& wall = problem.components[1].curve;
  const Eigen::Index size = 2 * wall.size();
  system.matrix.bottomRightCorner(size, size) += factor * null_space_matrix(wall);
  const Eigen::VectorXd solution = system.matrix.partialPivLu().solve(system.rhs);
  return -complete_dense(problem, ClosureForm::reduced, solution).loads[0].force;
}

}  // namespace

std::vector<interactive::Case> interactive::bearing() {
  std::vector<Case> cases;
  struct Settings {
    double x, y, leak;
    int n;
  };
  for (const auto& [x, y, leak, n] :
       {Settings{0.0, -0.25, 0.001, 32}, {0.3, 0.12, 0.004, 40}, {-0.08, 0.06, 0.001, 16}}) {
    const Complex at{x, y};
    const double e = std::abs(at), d = std::log(1.5 / (1.0 + e));
    const double tau = std::acosh((1.0 + 1.5 * 1.5 - e * e) / 3.0);
    const Eigen::Index needed =
        2 * static_cast<Eigen::Index>(std::ceil(24.0 / std::min(tau, 2.0 * d)));
    const Complex across = stokesbook::imaginary * at / e;
    const Complex resolved = force_on_shaft(bearing_problem(at, 0.0, needed), 1.0);
    const auto problem = bearing_problem(at, leak, n);
    const Complex with_n0 = force_on_shaft(problem, 1.0), without = force_on_shaft(problem, 0.0);
    cases.push_back({.settings = {{"x", x}, {"y", y}, {"leak", leak}, {"N", n}},
                     .numbers = {{"exact", stokesbook::dot(resolved, across)},
                                 {"across", stokesbook::dot(with_n0, across)},
                                 {"along", stokesbook::dot(with_n0, at / e)},
                                 {"alongWithout", stokesbook::dot(without, at / e)},
                                 {"nodes", static_cast<double>(needed)}}});
  }
  return cases;
}
