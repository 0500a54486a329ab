// Check of exercise 13.4: the exact spectrum, quadratures, and solutions that are known beforehand.
#include "chapters/check.hpp"

#include <numbers>

#include <Eigen/LU>

using namespace stokesbook;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;
using exercise::text;
using std::numbers::pi;

double distance_rate(double gap);
double pore_pressure(double viscosity, double flux, double gap, double radius);
VectorXd released(const MatrixXd& held_inverse, const VectorXd& K, const VectorXd& Pi,
                  const VectorXd& r);
VectorXd compressed(const VectorXd& q, double beta, const VectorXd& x);
double forces_left_out(double density, double inner, double outer);

namespace {

// The mean logarithm of the distances of all eight eigenvalues (13.2) of a mode.
double mean_logarithm(double gap, int mode) {
  const double alpha = std::acosh(1.0 + 0.5 * gap);
  const double turn = std::asinh(mode * std::sinh(2.0 * alpha));
  double sum = 0.0;
  for (const double sign : {-1.0, 1.0})
    sum += std::log(std::exp(-2.0 * mode * alpha + sign * turn));
  return sum / 2.0;
}

void check_rate(double gap) {
  const double mode = mean_logarithm(gap, 4) - mean_logarithm(gap, 5), exact = mode / 8.0;
  expect({.what = "g = " + text(gap),
          .got = distance_rate(gap),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {
              {mode, "this is the rate from mode to mode: a mode has eight eigenvalues"},
              {mode / 4.0, "each mode has a sine as well as a cosine, eight eigenvalues in all"},
              {std::acosh(1.0 + gap) / 4.0,
               "cosh(alpha) is 1 + g/2, half of the distance of the "
               "centres"},
              {std::sqrt(gap) / 4.0, "alpha is the root of the gap only if the gap is small"},
              {mode / 2.0, "this is alpha"}}});
}

// The angle y with x = sqrt(g a) tan(y) makes the integrand a power of the cosine.
void check_pore(double gap, double radius) {
  constexpr double viscosity = 2.0, flux = 0.3;
  constexpr int n = 16;
  const double unit = std::sqrt(gap * radius);
  double exact = 0.0;
  for (int j = 0; j < n; ++j) {
    const double angle = pi * ((j + 0.5) / n - 0.5), x = unit * std::tan(angle);
    const double height = gap + x * x / radius, dx = unit / std::pow(std::cos(angle), 2) * pi / n;
    exact += 12.0 * viscosity * flux / std::pow(height, 3) * dx;
  }
  expect({.what = "mu = 2, q = 0.3, g = " + text(gap) + ", a = " + text(radius),
          .got = pore_pressure(viscosity, flux, gap, radius),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{exact * gap,
                        "this has the power of a pair that approaches; a flux through the gap "
                        "has one power of 1/g more"},
                       {0.5 * exact, "the pressure falls on both sides of the narrowest place"},
                       {exact / unit,
                        "the substitution changes dx, too: the gap is narrow over the length "
                        "sqrt(g a)"},
                       {exact / std::sqrt(radius),
                        "the root of the radius is missing: the gap is narrow "
                        "over the length sqrt(g a)"},
                       {exact / 12.0, "the factor 12 of the rate is missing"}}});
}

// The operator for the free body is A = A_h - (A_h K + K) Pi, and the solution is known.
void check_released(const VectorXd& solution) {
  const MatrixXd held{{2.0, 0.3, -0.4}, {0.1, 1.5, 0.2}, {-0.3, 0.5, 1.8}}, H = held.inverse();
  const VectorXd K{{1.0, 2.0, -1.0}}, Pi{{0.5, 0.5, 0.5}};  // Pi K = 1
  const VectorXd r = held * solution - (held * K + K) * Pi.dot(solution);
  const double V = -Pi.dot(solution);
  expect({.what = "r = (" + text(r[0]) + ", " + text(r[1]) + ", " + text(r[2]) + ")",
          .got = released(H, K, Pi, r),
          .expected = solution,
          .tolerance = 1e-11,
          .mistakes = {{VectorXd(solution + 2.0 * V * K),
                        "the density of a motion is minus the motion: the last term is -K V"},
                       {VectorXd(solution + V * H * K),
                        "subtract the motions from the data before the second solve"},
                       {VectorXd(solution + V * K), "the rigid part -K V is missing"},
                       {VectorXd(H * r), "this is the solution for the held body"}}});
}

void check_compressed(double angle, double beta, const VectorXd& solution) {
  const VectorXd q{{std::cos(angle), 0.0, std::sin(angle)}};
  const VectorXd x = solution + beta * q.dot(solution) * q;
  const double along = q.dot(x);
  expect({.what = "q = (" + text(q[0]) + ", 0, " + text(q[2]) + "), beta = " + text(beta) +
                  ", x = (" + text(x[0]) + ", " + text(x[1]) + ", " + text(x[2]) + ")",
          .got = compressed(q, beta, x),
          .expected = solution,
          .tolerance = 1e-12,
          .mistakes = {{VectorXd(along / (1.0 + beta) * q),
                        "everything outside of the direction q is unchanged, and not zero"},
                       {VectorXd(x - beta * along * q),
                        "this is the first term of the series of the inverse, for small beta"},
                       {VectorXd(x + along / (1.0 + beta) * q),
                        "the part along q is in x already: subtract q (q . x) first"},
                       {VectorXd(x + beta * along * q), "this is the matrix, not its inverse"}}});
}

// By Simpson's rule.
void check_forces(double density, double inner, double outer) {
  constexpr int n = 20000;
  const double h = (outer - inner) / n;
  double sum = 0.0;
  for (int k = 0; k <= n; ++k) {
    const double rho = inner + k * h, weight = k == 0 || k == n ? 1.0 : k % 2 == 0 ? 2.0 : 4.0;
    sum += weight * h / 3.0 * density * (2.0 * pi * rho) / (rho * rho);
  }
  expect({.what = "n = " + text(density) + ", from " + text(inner) + " to " + text(outer),
          .got = forces_left_out(density, inner, outer),
          .expected = sum,
          .tolerance = 1e-10,
          .mistakes = {{2.0 * pi * density * (1.0 / inner - 1.0 / outer),
                        "wide rings have more disks: their number grows like rho"},
                       {sum / (2.0 * pi), "the circumference is 2 pi rho: 2 pi is missing"},
                       {sum / density, "the number of disks is missing"},
                       {-sum, "the sum is positive: the outer radius is the larger one"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the rate of the distances",
        .formula = "alpha/4 with cosh(alpha) = 1 + g/2",
        .hint = "the mean logarithm in the mode n is -2 n alpha; a mode has eight eigenvalues",
        .check =
            [] {
              for (const double gap : {0.2, 0.5, 2.0}) check_rate(gap);
            }},
       {.title = "the pressure in a pore",
        .formula = "(9/2) pi mu q sqrt(a) g^(-5/2)",
        .hint = "12 mu q times the integral of dx/h^3, with x = sqrt(g a) y",
        .check =
            [] {
              check_pore(0.1, 1.0);
              check_pore(0.01, 1.0);
              check_pore(0.05, 3.0);
            }},
       {.title = "hold, then release",
        .formula = "A_h^-1 (r - K V) - K V, V = Pi A_h^-1 r/(Pi A_h^-1 K)",
        .hint = "the four steps below (13.5)",
        .check =
            [] {
              check_released(VectorXd{{1.0, -0.5, 2.0}});
              check_released(VectorXd{{-0.25, 3.0, 0.5}});
            }},
       {.title = "a compressed inverse",
        .formula = "x - q (q . x) + q (q . x)/(1 + beta)",
        .hint = "only the part along q is divided by 1 + beta",
        .check =
            [] {
              check_compressed(0.5, 0.8, VectorXd{{1.0, 2.0, -0.5}});
              check_compressed(2.0, -0.4, VectorXd{{0.3, -1.0, 1.5}});
            }},
       {.title = "the reach of forces",
        .formula = "2 pi n log(outer/inner)",
        .hint = "integrate rho^-2 n 2 pi rho",
        .check = [] {
          check_forces(0.25, 2.0, 4.0);
          check_forces(0.1, 1.0, 8.0);
        }}});
}
