// Check of exercise 09.3: sweeps over two circles by the solver of the library, and powers of
// complex numbers.
#include "chapters/check.hpp"

#include <numbers>

#include <Eigen/LU>

#include "suspension/solver/solver.hpp"

using namespace stokesbook;
using Eigen::VectorXd;
using exercise::expect;
using std::numbers::pi;

using Linear = std::function<VectorXd(const VectorXd&)>;

struct System {
  Linear a;
  Linear inverse_m;
  VectorXd b;
};

VectorXd sweeps(const System& system, const VectorXd& before, int count);
double contraction(double gap);
double breaking_gap(int k);
double error_after_reversal(double gap, int k, double dt);
double growth(int n);

namespace {

void check_sweeps(int count) {
  const Eigen::Matrix3d a{{2.0, 0.5, 0.0}, {0.3, 3.0, 1.0}, {0.4, 0.0, 1.0}};
  const Eigen::Vector3d m = a.diagonal(), b{1.0, -2.0, 0.5}, before{0.3, 0.1, -1.0};
  const System system{[&](const VectorXd& x) -> VectorXd { return a * x; },
                      [&](const VectorXd& x) -> VectorXd { return x.cwiseQuotient(m); }, b};
  // eta_k = eta + (1 - M^-1 A)^k (eta' - eta).
  const Eigen::Matrix3d once = Eigen::Matrix3d::Identity() - m.cwiseInverse().asDiagonal() * a;
  const Eigen::Vector3d solution = a.inverse() * b;
  Eigen::Vector3d error = before - solution, forgotten = before;
  for (int k = 0; k < count; ++k) {
    error = (once * error).eval();
    forgotten = ((b - a * forgotten).cwiseQuotient(m)).eval();
  }
  const Eigen::Vector3d frozen = solution + once * (before - solution);
  expect({.what = std::to_string(count) + " sweeps over three unknowns",
          .got = sweeps(system, before, count),
          .expected = solution + error,
          .tolerance = 1e-12,
          .mistakes = {
              {forgotten, "the density before is missing in the sum: eta' + M^-1 (b - A eta')"},
              {frozen, "every sweep starts from the density of the step before: use the latest"},
              {solution, "this is the solution: sweeps do not get there"}}});
}

double factor_at(double alpha) {
  return std::exp(-4.0 * alpha + std::asinh(2.0 * std::sinh(2.0 * alpha)));
}

void check_contraction(double gap) {
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  expect({.what = "gap " + exercise::text(gap),
          .got = contraction(gap),
          .expected = factor_at(alpha),
          .tolerance = 1e-12,
          .mistakes = {
              {factor_at(std::acosh(1.0 + gap)),
               "half of the gap belongs to each circle: "
               "cosh a = 1 + g/2; the gap is not the distance of "
               "the centres less one radius"},
              {1.0 - 8.0 * std::pow(gap, 1.5), "this is the law for small gaps"},
              {1.0 - factor_at(alpha), "this is what a sweep takes away: rho is what it leaves"}}});
}

// What k sweeps leave of the density of two circles in extension, which is an error of 1 at first.
double left_by_the_book(double gap, int k) {
  Scene scene;
  scene.flow = ExtensionalFlow{1.0};
  for (const double side : {-1.0, 1.0}) {
    scene.bodies.push_back(
        {.shape = Circle{1.0}, .position = side * (1.0 + 0.5 * gap), .n_nodes = 96});
  }
  scene.solver.preconditioner = PreconditionerKind::block_diagonal;
  scene.solver.tolerance = 1e-3;
  const SuspensionSolver solver(scene);
  const Instant still = solver.start();
  const ComplexVector exact = solver.solve(still).density;
  ComplexVector density = ComplexVector::Zero(exact.size());
  const auto error_after = [&](int count) {
    for (int sweep = 0; sweep < count; ++sweep) {
      const auto before = [&](const Discretisation&) { return density; };
      density = solver.solve_lagged(still, before).density;
    }
    return (density - exact).norm();
  };
  // The first sweeps leave the slowest mode alone.
  const double first = error_after(6);
  return error_after(k) / first;
}

void check_breaking_gap(int k) {
  const double got = breaking_gap(k);
  double low = 1e-6, high = 10.0;
  for (int bisection = 0; bisection < 60; ++bisection) {
    const double middle = std::sqrt(low * high);
    (std::pow(factor_at(std::acosh(1.0 + 0.5 * middle)), k) > 0.5 ? low : high) = middle;
  }
  const std::string what = std::to_string(k) + (k == 1 ? " sweep" : " sweeps");
  const double asymptotic = std::pow((1.0 - std::pow(0.5, 1.0 / k)) / 8.0, 2.0 / 3.0);
  expect({.what = what,
          .got = got,
          .expected = low,
          .tolerance = 1e-6,
          .mistakes = {{asymptotic,
                        "the law for small gaps does not hold there: solve rho^k = 1/2 itself"}}});
  for (const double part : {2.0, 0.5}) {
    const double left = left_by_the_book(part * got, k);
    if ((left < 0.5) == (part > 1.0)) continue;
    throw exercise::Rejection{exercise::line("for", what + " of the solver") +
                              exercise::line("got", exercise::text(left) + " of the error left")};
  }
}

void check_error_after_reversal(double gap, int k) {
  const double exact = 2.0 * std::pow(factor_at(std::acosh(1.0 + 0.5 * gap)), k);
  for (const double dt : {0.1, 1e-8}) {
    expect({.what = "gap " + exercise::text(gap) + ", " + std::to_string(k) +
                    " sweeps, dt = " + exercise::text(dt),
            .got = error_after_reversal(gap, k, dt),
            .expected = exact,
            .tolerance = 1e-9,
            .mistakes = {{dt * exact, "the time step does not help: the jump is as large as ever"},
                         {0.5 * exact, "the density before is -eta, not 0: |-eta - eta| = 2 |eta|"},
                         {dt, "the time step does not help: no power of dt is in the error"}}});
  }
}

void check_growth(int n) {
  const double h = 2.0 * pi / n;
  const double exact = std::abs(std::pow(Complex{1.0, h}, n));
  expect({.what = std::to_string(n) + " steps",
          .got = growth(n),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {
              {exact * exact, "this is the square of the modulus"},
              {std::sqrt(1.0 + h * h), "this is the growth of a step, not of a turn"},
              {1.0, "Euler does not stay on circles"},
              {std::exp(2.0 * pi), "a turn is q' = i q: the rate is at a right angle to q"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "sweeps",
                         .formula = "eta_(k+1) = eta_k + M^-1 (b - A eta_k)",
                         .hint = "the density before is the first eta_k",
                         .check =
                             [] {
                               for (const int count : {1, 3}) check_sweeps(count);
                             }},
                        {.title = "the contraction",
                         .formula = "exp(-4 a + asinh(2 sinh 2 a)), cosh a = 1 + g/2",
                         .hint = "std::acosh() gives a",
                         .check =
                             [] {
                               for (const double gap : {1.0, 0.1, 0.01}) check_contraction(gap);
                             }},
                        {.title = "the gap that breaks it",
                         .builds_on = {2},
                         .formula = "rho^k = 1/2",
                         .hint = "bisect: rho grows as the gap closes",
                         .check =
                             [] {
                               for (const int k : {1, 2, 4}) check_breaking_gap(k);
                             }},
                        {.title = "after a reversal",
                         .builds_on = {2},
                         .formula = "|eta_k - eta| = rho^k |eta' - eta|",
                         .hint = "eta' = -eta",
                         .check =
                             [] {
                               check_error_after_reversal(0.5, 1);
                               check_error_after_reversal(0.05, 3);
                             }},
                        {.title = "the growth",
                         .formula = "|1 + i h|^n, h = 2 pi/n",
                         .hint = "the modulus of 1 + i h is sqrt(1 + h^2)",
                         .check = [] {
                           for (const int n : {10, 100}) check_growth(n);
                         }}});
}
