// Compares residuals of GMRES with closed forms, on matrices with known spectra (05.6)-(05.8).
#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "krylov/gmres.hpp"

namespace stokesbook::verification::krylov {

using namespace study;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double radius = 0.5;   // radius of the disk of eigenvalues about 1
constexpr double spread = 25.0;  // quotient of the largest and the least eigenvalue of the interval

/// Holds a system with a known operator, and its right-hand side.
struct System {
  LinearMap apply;
  VectorXd rhs;
};

VectorXd shifted(const VectorXd& v) {
  VectorXd result(v.size());
  result << v.tail(1), v.head(v.size() - 1);
  return result;
}

/// Returns a system with the operator centre + radius S, in which S is the cyclic shift. The
/// eigenvalues of this operator are equidistant on a circle.
/// The right-hand side is the sum of all eigenvectors with equal weights.
System circle_of_eigenvalues(double centre, double circle) {
  return {[=](const VectorXd& v) -> VectorXd { return centre * v + circle * shifted(v); },
          VectorXd::Unit(matrix_order, 0)};
}

/// Returns a system whose eigenvalues are the Chebyshev points of [1, spread]. The right-hand side
/// has equal parts of all eigenvectors.
System interval_of_eigenvalues() {
  VectorXd eigenvalues(matrix_order);
  for (Index j = 0; j < matrix_order; ++j) {
    const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / matrix_order;
    eigenvalues[j] = 0.5 * (spread + 1.0) + 0.5 * (spread - 1.0) * std::cos(angle);
  }
  return {[=](const VectorXd& v) -> VectorXd { return eigenvalues.cwiseProduct(v); },
          VectorXd::Ones(matrix_order)};
}

/// Returns a system with the circle of eigenvalues about 1 and a few eigenvalues far outside the
/// disk of this circle.
System disk_and_outliers() {
  VectorXd outliers(6);
  outliers << 1e-3, 1e-2, 0.1, -0.3, 3.0, 10.0;
  VectorXd rhs(matrix_order + outliers.size());
  rhs << VectorXd::Unit(matrix_order, 0), VectorXd::Ones(outliers.size());
  return {[=](const VectorXd& v) -> VectorXd {
            VectorXd result(v.size());
            const VectorXd disk = v.head(matrix_order);
            result << disk + radius * shifted(disk), outliers.cwiseProduct(v.tail(outliers.size()));
            return result;
          },
          rhs};
}

/// Returns the residual after k iterations for the circle about 1 (05.7): the least mean square on
/// the circle of a polynomial with p(0) = 1.
double least_on_circle(int k) {
  double sum = 0.0;
  for (int j = 0; j <= k; ++j) sum += std::pow(radius, -2.0 * j);
  return 1.0 / std::sqrt(sum);
}

/// Returns the residual after k iterations for the interval. The formula uses the orthonormal
/// polynomials sqrt(2) T_j of the interval.
double least_on_interval(int k) {
  const double at_zero = std::acosh((spread + 1.0) / (spread - 1.0));
  double sum = 1.0;
  for (int j = 1; j <= k; ++j) sum += 2.0 * std::pow(std::cosh(j * at_zero), 2.0);
  return 1.0 / std::sqrt(sum);
}

std::vector<double> history_of(const System& system, int iterations) {
  return gmres(system.apply, {}, system.rhs, {1e-15, iterations}).history;
}

std::vector<Measurement> as_measurements(const std::vector<double>& history, int products = 1) {
  std::vector<Measurement> measurements;
  for (std::size_t k = 1; k < history.size(); ++k) {
    measurements.push_back(
        {.x = products * static_cast<double>(k), .error = history[k], .unknowns = matrix_order});
  }
  return measurements;
}

Measure history(const System& system, int iterations) {
  return [=](Size) { return as_measurements(history_of(system, iterations)); };
}

Measure restarted_history(const System& system, int iterations, int length) {
  return [=](Size) {
    return as_measurements(restarted(system.apply, {}, system.rhs, length, iterations));
  };
}

/// Applies the naive symmetric method: solves (1 + r S)^T (1 + r S) x = (1 + r S)^T b by GMRES.
/// Each iteration requires two products.
std::vector<Measurement> normal_equations(Size) {
  const System system = circle_of_eigenvalues(1.0, radius);
  const auto transposed = [](const VectorXd& v) -> VectorXd {
    VectorXd back(v.size());
    back << v.tail(v.size() - 1), v.head(1);
    return v + radius * back;
  };
  const System normal{[=](const VectorXd& v) { return transposed(system.apply(v)); },
                      transposed(system.rhs)};
  return as_measurements(history_of(normal, 25), 2);
}

/// Restarts, as a planted defect, after every five iterations, so that the earlier Krylov space is
/// lost.
std::vector<double> restarted_history_of(const System& system, int iterations) {
  return restarted(system.apply, {}, system.rhs, 5, iterations);
}

using History = std::vector<double> (*)(const System& system, int iterations);

Measure against(const System& system, double (*exact)(int), History history) {
  return [=](Size) {
    const std::vector<double> residuals = history(system, 20);
    std::vector<Measurement> measurements;
    for (std::size_t k = 1; k < residuals.size(); ++k) {
      measurements.push_back({.x = static_cast<double>(k),
                              .error = std::abs(residuals[k] / exact(static_cast<int>(k)) - 1.0)});
    }
    return measurements;
  };
}

Line closed_form(const std::string& key, const std::string& label, const std::string& id,
                 const System& system, double (*exact)(int), const std::string& reason) {
  return {.key = key,
          .label = label,
          .measure = against(system, exact, history_of),
          .claim =
              Claim{.id = id,
                    .statement = "The residual of GMRES is the least mean square of a "
                                 "polynomial with p(0) = 1 over the spectrum, " +
                                 label + ".",
                    .law = Identity{1e-13},
                    .reason =
                        reason + "; 1e-13: the recurrence multiplies sines, 20 of them to rounding",
                    .api = {"stokesbook::gmres"}},
          .control = Control{"restarted after every five iterations",
                             against(system, exact, restarted_history_of)}};
}

}  // namespace

Experiment known_spectra() {
  const double interval_rate = std::log((std::sqrt(spread) + 1.0) / (std::sqrt(spread) - 1.0));
  const System disk = circle_of_eigenvalues(1.0, radius);
  return {
      .key = "known",
      .title = "Residuals where the spectrum is known",
      .x = "matrix-vector products k",
      .error = "residual, relative to the right-hand side",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "disk",
           .label = "disk of radius 1/2 about 1",
           .measure = history(disk, 45),
           .claim = Claim{.id = "05_1",
                          .statement = "With eigenvalues in a disk of radius r about 1 the "
                                       "residual falls as r^k, whatever the order of the matrix.",
                          .law = Geometric{-std::log(radius), 0.01},
                          .window = {.from = 4.0, .floor = 1e-15},
                          .reason = "(1 - z)^k is at most r^k on the disk, and 1 at 0; no "
                                    "polynomial of its degree does better",
                          .api = {"stokesbook::gmres"}},
           .control = Control{"the normal equations, whose iterations take two products",
                              normal_equations}},
          {.key = "interval",
           .label = "interval from 1 to 25",
           .measure = history(interval_of_eigenvalues(), 60),
           .claim = Claim{.id = "05_2",
                          .statement = "With eigenvalues on an interval whose ends have the "
                                       "quotient c the residual falls as ((sqrt(c) - 1) / "
                                       "(sqrt(c) + 1))^k.",
                          .law = Geometric{interval_rate, 0.01},
                          .window = {.from = 5.0, .floor = 1e-15},
                          .reason = "Chebyshev's polynomials, scaled to 1 at 0",
                          .api = {"stokesbook::gmres"}},
           .control = Control{"restarted after every iteration",
                              restarted_history(interval_of_eigenvalues(), 60, 1)}},
          {.key = "outliers",
           .label = "the disk, and six eigenvalues outside",
           .measure = history(disk_and_outliers(), 60),
           .claim = Claim{.id = "05_3",
                          .statement = "A few eigenvalues outside the disk delay convergence, and "
                                       "leave its rate.",
                          .law = Geometric{-std::log(radius), 0.03},
                          .window = {.from = 32.0, .floor = 1e-15},
                          .reason = "a factor 1 - z / z_j of the polynomial removes an outlier for "
                                    "one iteration each",
                          .api = {"stokesbook::gmres"}},
           .control = Control{"restarted after every five iterations",
                              restarted_history(disk_and_outliers(), 60, 5)}},
          {.key = "around_zero",
           .label = "circle around 0, condition number 1",
           .measure = history(circle_of_eigenvalues(0.0, 1.0), 60)}}};
}

Experiment least_residuals() {
  return {.key = "least",
          .title = "Residuals against their closed forms",
          .x = "iterations k",
          .error = "relative difference of the residual from the least mean square",
          .axes = Axes::semi_log,
          .lines = {closed_form("disk", "on a circle about 1", "05_4",
                                circle_of_eigenvalues(1.0, radius), least_on_circle,
                                "orthonormal polynomials ((z - 1) / r)^j; the least is the inverse "
                                "root of the sum of their squares at 0"),
                    closed_form("interval", "on an interval", "05_5", interval_of_eigenvalues(),
                                least_on_interval,
                                "orthonormal polynomials sqrt(2) T_j of Chebyshev's points")}};
}

}  // namespace stokesbook::verification::krylov
