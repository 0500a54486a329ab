// Exercise 01.2: how fast the trapezoid rule converges for a target near the curve.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include <Eigen/Core>

#include "record/svg.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: 1/(2 pi i) integral of dx/(x - z) along the curve, by the trapezoid rule.
Complex winding_number(const Curve& curve, Complex z) {
  //@ starter
  not_done(curve, z);  // your code instead of this line
  //@ solution
  Complex sum = 0.0;
  for (Eigen::Index j = 0; j < curve.size(); ++j) sum += curve.dx[j] / (curve.x[j] - z);
  return sum / (imaginary * static_cast<double>(curve.size()));
  //@ wrong arclength: this integrates over the arclength
  const Eigen::VectorXd w = weights(curve);
  Complex sum = 0.0;
  for (Eigen::Index j = 0; j < curve.size(); ++j) sum += w[j] / (curve.x[j] - z);
  return sum / (2.0 * pi * imaginary);
  //@ end
}

// Task 2: distance from the real axis of the nearest complex t with x(t) = z.
double predicted_rate(const Ellipse& ellipse, Complex z) {
  //@ starter
  not_done(ellipse, z);  // your code instead of this line
  //@ solution
  const double a = ellipse.a, b = ellipse.b;
  const Complex root = std::sqrt(z * z - (a * a - b * b));
  return std::min(std::abs(std::log(std::abs((z + root) / (a + b)))),
                  std::abs(std::log(std::abs((z - root) / (a + b)))));
  //@ wrong distance_in_the_plane: this is the distance of z from the curve
  return (sample(ellipse, 2000, Side::fluid_inside).x.array() - z).abs().minCoeff();
  //@ end
}

// Task 3: rho of errors C exp(-rho n), without those below 1e-13.
double measured_rate(const Eigen::VectorXd& n, const Eigen::VectorXd& errors) {
  //@ starter
  not_done(n, errors);  // your code instead of this line
  //@ solution
  const Eigen::ArrayXd used = (errors.array() >= 1e-13).cast<double>();
  const Eigen::ArrayXd y = errors.array().max(1e-300).log();
  const double n_mean = (used * n.array()).sum() / used.sum();
  return -(used * (n.array() - n_mean) * y).sum() / (used * (n.array() - n_mean).square()).sum();
  //@ wrong rounding: this fits the rounding errors too
  const Eigen::ArrayXd y = errors.array().log();
  const Eigen::ArrayXd centred = n.array() - n.mean();
  return -(centred * y).sum() / centred.square().sum();
  //@ wrong decades: this counts in decades
  const Eigen::ArrayXd used = (errors.array() >= 1e-13).cast<double>();
  const Eigen::ArrayXd y = errors.array().log10();
  const double n_mean = (used * n.array()).sum() / used.sum();
  return -(used * (n.array() - n_mean) * y).sum() / (used * (n.array() - n_mean).square()).sum();
  //@ end
}

// Task 4, as it is: errors at targets near the tip and near the side of an ellipse, over n = 8, 16,
// ..., 320. Writes rates.csv and rates.svg; returns predicted and measured rates, one row a target.
Eigen::MatrixX2d experiment() {
  const Ellipse ellipse{2.0, 1.0};
  const Eigen::VectorXd n = Eigen::VectorXd::LinSpaced(40, 8.0, 320.0);
  const char* names[] = {"tip, d = 0.2", "tip, d = 0.1", "side, d = 0.2", "side, d = 0.1"};
  const char* colours[] = {"#0969da", "#54aeff", "#cf222e", "#ff8182"};
  const Complex targets[] = {1.8, 1.9, 0.8 * imaginary, 0.9 * imaginary};
  Eigen::MatrixX2d rates(4, 2);
  std::ofstream csv("rates.csv"), picture("rates.svg");
  csv << "d,rate_predicted,rate_measured\n";
  picture << svg::open({720.0, 420.0}, "Error of the winding number over the number of nodes");
  // A factor of 10 is 24 pixels.
  const auto pixel = [](double nodes, double error) {
    return Complex{50.0 + 2.0 * nodes, 20.0 - 24.0 * std::log10(std::max(error, 1e-16))};
  };
  for (int power = 0; power >= -16; power -= 4) {
    picture << svg::label(pixel(0.0, std::pow(10.0, power)) - 40.0, "1e" + std::to_string(power));
  }
  for (int nodes = 0; nodes <= 320; nodes += 80) {
    picture << svg::label(pixel(nodes, 1e-16) + 18.0 * imaginary, "N = " + std::to_string(nodes));
  }
  for (int k = 0; k < 4; ++k) {
    const Eigen::VectorXd errors = n.unaryExpr([&](double nodes) {
      const Curve curve = sample(ellipse, static_cast<Eigen::Index>(nodes), Side::fluid_inside);
      return std::abs(winding_number(curve, targets[k]) - 1.0);
    });
    rates.row(k) << predicted_rate(ellipse, targets[k]), measured_rate(n, errors);
    csv << (k % 2 == 0 ? 0.2 : 0.1) << ',' << rates(k, 0) << ',' << rates(k, 1) << '\n';
    // Dots are measured; the line is exp(-rho N), as predicted.
    const std::string colour = std::string("stroke=\"") + colours[k] + "\" stroke-width=";
    for (Eigen::Index i = 0; i < n.size(); ++i) {
      const Complex dot = pixel(n[i], errors[i]);
      picture << svg::path(svg::line(dot - 2.0, dot + 2.0), colour + "\"4\"");
    }
    const double end = std::min(320.0, std::log(1e16) / rates(k, 0));
    picture << svg::path(svg::line(pixel(0.0, 1.0), pixel(end, std::exp(-rates(k, 0) * end))),
                         colour + "\"1\"");
    picture << svg::label({560.0, 30.0 + 20.0 * k}, names[k],
                          std::string("style=\"fill:") + colours[k] + '"');
  }
  picture << "</svg>\n";
  return rates;
}

// Task 5: distance from the curve in spacings h of its nodes, at which the error is the tolerance.
double safe_distance(double tolerance) {
  //@ starter
  not_done(tolerance);  // your code instead of this line
  //@ solution
  return -std::log(tolerance) / (2.0 * pi);
  //@ wrong radians: this is the distance in units of |x'|/N
  return -std::log(tolerance);
  //@ end
}
