// Check of exercise 01.2: for an ellipse the rule's result is known, x'/(x - z) being a rational
// function of exp(i t).
#include "chapters/check.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <numbers>

#include "study/plot.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

Complex winding_number(const Curve& curve, Complex z);
double predicted_rate(const Ellipse& ellipse, Complex z);
double measured_rate(const Eigen::VectorXd& n, const Eigen::VectorXd& errors);
double safe_distance(double tolerance);

namespace {

const Ellipse ellipse{2.0, 1.0};

std::string at(Complex z) {
  return "half axes 2 and 1, z = " + exercise::text(z);
}

// exp(i t) at the complex parameters t with x(t) = z.
std::array<Complex, 2> roots(Complex z) {
  const double a = ellipse.a, b = ellipse.b;
  const Complex root = std::sqrt(z * z - (a * a - b * b));
  return {(z + root) / (a + b), (z - root) / (a + b)};
}

void check_winding_number(Complex z, int n) {
  // x'/(x - z) = i (-1 + w/(w - w_1) + w/(w - w_2)), and the mean of w/(w - q) over the N-th roots
  // of unity is 1/(1 - q^N).
  Complex exact = -1.0;
  for (const Complex q : roots(z)) exact += 1.0 / (1.0 - std::pow(q, n));
  const Curve curve = sample(ellipse, n, Side::fluid_inside);
  const double h = 2.0 * pi / n;
  const Complex by_arclength =
      (weights(curve).array() / (curve.x.array() - z)).sum() / (2.0 * pi * imaginary);
  const Complex undirected = curve.dx.cwiseQuotient(curve.x).sum() * h / (2.0 * pi * imaginary);
  expect(
      {.what = at(z) + ", N = " + std::to_string(n),
       .got = winding_number(curve, z),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{by_arclength, "this integrates over the arclength, with |x'| instead of x'"},
                    {-exact, "the sign is the other one: the denominator is x - z"},
                    {exact / h, "the weight 2 pi / N is missing"},
                    {2.0 * pi * imaginary * exact, "the factor 1/(2 pi i) is missing"},
                    {imaginary * exact, "the factor is 1/(2 pi i), not 1/(2 pi)"},
                    {undirected, "z is missing in the denominator"}}});
}

void check_predicted_rate(Complex z) {
  const auto [w_1, w_2] = roots(z);
  const double one = -std::log(std::abs(w_1)), other = -std::log(std::abs(w_2));
  const double exact = std::min(one, other);
  // As a reader would: over nodes.
  const Curve curve = sample(ellipse, 2000, Side::fluid_inside);
  Eigen::Index nearest;
  const double distance = (curve.x.array() - z).abs().minCoeff(&nearest);
  expect({.what = at(z),
          .got = predicted_rate(ellipse, z),
          .expected = exact,
          .tolerance = 1e-6,
          .mistakes = {
              {std::max(one, other), "this is the pole farther away; the nearest one counts"},
              {distance,
               "this is the distance of z from the curve; it is the distance of t from "
               "the real axis that counts"},
              {distance / std::abs(curve.dx[nearest]),
               "this takes the curve for a straight line, which holds only for small distances"},
              {2.0 * exact, "twice the rate"},
              {0.5 * exact, "half of the rate"},
              {-exact, "a rate of decay is positive: error = exp(-rho N)"},
              {exact / std::numbers::ln10, "this counts in decades: use the natural logarithm"}}});
}

// Slope of a least-squares line through the first entries.
double slope(const Eigen::VectorXd& n, const Eigen::VectorXd& y, Eigen::Index entries) {
  const Eigen::VectorXd x = n.head(entries).array() - n.head(entries).mean();
  return x.dot(y.head(entries)) / x.squaredNorm();
}

void check_measured_rate(double rate) {
  // Errors 3 exp(-rho N) that end in rounding errors.
  const Eigen::VectorXd n = Eigen::VectorXd::LinSpaced(20, 10.0, 200.0);
  Eigen::VectorXd errors = 3.0 * (-rate * n.array()).exp();
  const Eigen::Index resolved = (errors.array() >= 1e-13).count();
  for (Eigen::Index i = resolved; i < n.size(); ++i) errors[i] = i % 2 == 0 ? 1e-16 : 4e-16;
  const Eigen::VectorXd y = errors.array().log();
  expect({.what = "errors 3 exp(-" + exercise::text(rate) + " N), rounded",
          .got = measured_rate(n, errors),
          .expected = rate,
          .tolerance = 1e-10,
          .mistakes = {
              {-slope(n, y, n.size()),
               "this fits the rounding errors too: leave out what is below 1e-13"},
              {-rate, "a rate of decay is positive: error = exp(-rho N)"},
              {rate / std::numbers::ln10, "this counts in decades: use the natural logarithm"}}});
}

struct Target {
  std::string name;
  Complex z;
};

// Measures the rates at two distances, near the tip and near the flat side of the ellipse; writes
// rates.csv and rates.svg.
void check_experiment() {
  const std::array<Target, 4> targets{{{"tip, d = 0.2", 1.8},
                                       {"tip, d = 0.1", 1.9},
                                       {"side, d = 0.2", 0.8 * imaginary},
                                       {"side, d = 0.1", 0.9 * imaginary}}};
  const Eigen::VectorXd n = Eigen::VectorXd::LinSpaced(40, 16.0, 640.0);
  std::ofstream table("rates.csv");
  table << "target,rate_predicted,rate_measured\n";
  study::Plot plot{.title = "Error of the winding number by number of nodes",
                   .x_label = "nodes N",
                   .y_label = "error of the winding number; dashed: predicted",
                   .log_x = false};
  for (const Target& target : targets) {
    study::PlotLine line{target.name};
    Eigen::VectorXd errors(n.size());
    for (Eigen::Index i = 0; i < n.size(); ++i) {
      const Curve curve = sample(ellipse, static_cast<Eigen::Index>(n[i]), Side::fluid_inside);
      errors[i] = std::abs(winding_number(curve, target.z) - 1.0);
      line.points.push_back({n[i], errors[i]});
    }
    const double predicted = predicted_rate(ellipse, target.z), measured = measured_rate(n, errors);
    table << '"' << target.name << "\"," << predicted << ',' << measured << '\n';
    const double end = std::min(640.0, std::log(1e16) / predicted);
    plot.guides.push_back({plot.lines.size(), {0.0, 1.0}, {end, std::exp(-predicted * end)}});
    plot.lines.push_back(line);
    // The second pole, and the factor 1/(1 - q^N), count at small N only: 2 %.
    expect({.what = target.name, .got = measured, .expected = predicted, .tolerance = 0.02});
  }
  std::ofstream("rates.svg") << study::draw_plot(plot);
}

void check_safe_distance(double tolerance) {
  // On the unit circle the error is |z|^N / (1 - |z|^N): solved for 1 - |z|, in spacings 2 pi / N.
  constexpr double n = 1e6;
  const double modulus = std::pow(tolerance / (1.0 + tolerance), 1.0 / n);
  const double exact = (1.0 - modulus) * n / (2.0 * pi);
  expect(
      {.what = "tolerance = " + exercise::text(tolerance),
       .got = safe_distance(tolerance),
       .expected = exact,
       .tolerance = 0.01,
       .mistakes = {
           {2.0 * pi * exact, "this is the distance in units of |x'|/N; a spacing is 2 pi of them"},
           {exact / std::numbers::ln10, "this takes decades: use the natural logarithm"},
           {2.0 * exact, "twice the distance: the error is exp(-2 pi d/h), not exp(-pi d/h)"},
           {-exact, "a distance is positive"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the winding number",
        .formula = "1/(2 pi i) sum_j x'(t_j)/(x(t_j) - z) 2 pi/N",
        .hint = "curve.dx has x' at the nodes",
        .check =
            [] {
              for (int n : {8, 20}) {
                check_winding_number({1.2, 0.5}, n);
                check_winding_number({-0.3, -0.9}, n);
              }
            }},
       {.title = "the predicted rate",
        .formula = "(a+b)/2 w + (a-b)/2 1/w = z; rho = the smaller |log|w||",
        .hint = "solve x(t) = z for w = exp(i t), and compare the two solutions",
        .check =
            [] {
              check_predicted_rate({1.2, 0.5});
              check_predicted_rate({-0.3, -0.9});
              check_predicted_rate({-1.9, 0.0});
            }},
       {.title = "the measured rate",
        .formula = "log error = c - rho N, where the error is at least 1e-13",
        .hint = "the slope is the covariance of N and log error over the variance of N",
        .check =
            [] {
              for (double rate : {0.7, 0.25}) check_measured_rate(rate);
            }},
       {.title = "the experiment",
        .builds_on = {1, 2, 3},
        .formula = "error = C exp(-rho N)",
        .hint = "look at rates.svg: dots are measured, dashed lines are predicted",
        .check = check_experiment},
       {.title = "a safe distance",
        .formula = "rho N = 2 pi d/h close to the curve",
        .hint = "the pole of a target at the distance d has the height d/|x'|",
        .check = [] {
          for (double tolerance : {1e-3, 1e-14}) check_safe_distance(tolerance);
        }}});
}
