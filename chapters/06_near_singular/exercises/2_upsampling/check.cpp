// Check of exercise 06.2: a flow that is known, polynomials, and the experiment.
#include "chapters/check.hpp"

#include <algorithm>
#include <fstream>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "study/plot.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_flows.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;

ComplexVector fine_velocity(const Shape& shape, Side side, const ComplexVector& density, int sigma,
                            const ComplexVector& targets);
double reach(int sigma, double tolerance);
std::vector<double> lagrange(int degree, double point);
Complex close_velocity(Complex density_at_foot, Complex layer_at_foot,
                       const std::vector<Complex>& farther, double distance);

namespace {

const Ellipse ellipse{1.0, 0.5};
constexpr Index nodes = 96;
const test::ExactFlow& flow = test::inner_poles;

struct Body {
  Curve curve = sample(ellipse, nodes, Side::fluid_outside);
  ComplexVector density = test::density_of(curve, flow.velocity(curve.x));
  double size = flow.velocity(curve.x).cwiseAbs().maxCoeff();

  // The layer's integral at the nodes.
  ComplexVector layer() const {
    const Eigen::VectorXd velocity = double_layer_matrix(curve) * interleaved(density);
    return deinterleaved(velocity);
  }
};

// Points on normals halfway between nodes, at a distance in spacings.
ComplexVector points_at(double spacings) {
  const Curve feet = sample(ellipse, 2 * nodes, Side::fluid_outside);
  const ComplexVector x = feet.x(Eigen::seq(1, Eigen::last, 10)),
                      dx = feet.dx(Eigen::seq(1, Eigen::last, 10));
  // Into the fluid: the normal points out of it, i x'/|x'| for a body.
  return x - spacings * 2.0 * pi / static_cast<double>(nodes) * imaginary * dx;
}

double error_of(const Body& body, const ComplexVector& velocity, const ComplexVector& targets) {
  return (velocity - flow.velocity(targets)).cwiseAbs().maxCoeff() / body.size;
}

void check_fine() {
  const Body body;
  for (const int sigma : {2, 4}) {
    const Index n = sigma * nodes;
    const ComplexVector targets = points_at(1.0);
    const ComplexVector steps =
        ComplexVector::NullaryExpr(n, [&](Index j) { return body.density[j / sigma]; });
    const Curve fine = sample(ellipse, n, Side::fluid_outside);
    expect({.what = "one spacing from an ellipse, sigma = " + std::to_string(sigma),
            .got = fine_velocity(ellipse, Side::fluid_outside, body.density, sigma, targets),
            .expected = flow.velocity(targets),
            .tolerance = sigma == 2 ? 1e-3 : 1e-8,
            .mistakes = {
                {StressletSum({fine})(targets, steps), "the density is repeated, not interpolated"},
                {StressletSum({body.curve})(targets, body.density),
                 "this is the rule with the coarse nodes"},
                {-flow.velocity(targets), "the sign is the other one"}}});
  }
}

void check_reach() {
  for (const int sigma : {1, 4}) {
    for (const double tolerance : {1e-3, 1e-10}) {
      const double exact = std::log(200.0 / tolerance) / (2.0 * pi * sigma);
      expect({.what = "sigma = " + std::to_string(sigma) + ", " + exercise::text(tolerance),
              .got = reach(sigma, tolerance),
              .expected = exact,
              .tolerance = 1e-12,
              .mistakes = {{sigma * exact,
                            "this counts spacings of the fine nodes: they are sigma times as "
                            "many"},
                           {exact / std::log(10.0), "the logarithm is the natural one"},
                           {2.0 * pi * exact, "the factor 2 pi is missing"}}});
    }
  }
}

void check_lagrange() {
  for (const int degree : {1, 4, 7}) {
    for (const double point : {0.3, 2.0, 0.0}) {
      const std::vector<double> weights = lagrange(degree, point);
      const std::string what = "degree " + std::to_string(degree) + " at " + exercise::text(point);
      expect({.what = what + ": their number",
              .got = static_cast<double>(weights.size()),
              .expected = degree + 1.0,
              .tolerance = 0.0});
      for (int power = 0; power <= degree; ++power) {
        double got = 0.0, shifted = 0.0;
        for (int j = 0; j <= degree; ++j) {
          got += weights[static_cast<std::size_t>(j)] * std::pow(1.0 + j / 7.0, power);
          shifted += weights[static_cast<std::size_t>(j)] * std::pow(1.0 + (j + 1) / 7.0, power);
        }
        const double exact = std::pow(1.0 + point / 7.0, power);
        const bool from_one = std::abs(shifted - exact) < 1e-9 && std::abs(got - exact) > 1e-9;
        expect({.what = what + ": the value of (1 + x/7)^" + std::to_string(power),
                .got = got,
                .expected = exact,
                .tolerance = 1e-9,
                .mistakes = {
                    {from_one ? Complex{got} : Complex{exact}, "the first node is 0, not 1"}}});
      }
    }
  }
}

void check_close() {
  // A polynomial of degree 3 in the distance, whose value at 0 is layer - density/2.
  const Complex density{0.8, -0.4}, layer{0.3, 0.9};
  const auto velocity = [&](double d, Complex at_0) {
    return at_0 + Complex{0.2, 0.1} * d - 0.3 * d * d + Complex{0.0, 0.05} * d * d * d;
  };
  const Complex limit = layer - 0.5 * density;
  const std::vector<Complex> farther{velocity(1.0, limit), velocity(2.0, limit),
                                     velocity(3.0, limit)};
  for (const double d : {0.0, 0.4, 0.9}) {
    const double first = (1.0 - d) * (2.0 - d) * (3.0 - d) / 6.0;  // weight of the limit
    const Complex exact = velocity(d, limit);
    expect({.what = "a cubic polynomial, at " + exercise::text(d),
            .got = close_velocity(density, layer, farther, d),
            .expected = exact,
            .tolerance = 1e-12,
            .mistakes = {{exact + 0.5 * first * density,
                          "the jump is missing: the limit is -density/2 + layer"},
                         {exact + first * density, "this is the limit on the other side"},
                         {exact - first * limit, "the value on the curve is missing"}}});
  }
}

// The interpolation scheme with steps of a spacing, at all points of a distance.
ComplexVector interpolated(const Body& body, int sigma, int degree, double distance) {
  std::vector<ComplexVector> farther;
  for (int j = 1; j <= degree; ++j) {
    farther.push_back(
        fine_velocity(ellipse, Side::fluid_outside, body.density, sigma, points_at(j)));
  }
  const ComplexVector density = resample(body.density, 2 * nodes),
                      layer = resample(body.layer(), 2 * nodes);
  ComplexVector velocity(points_at(distance).size());
  for (Index i = 0; i < velocity.size(); ++i) {
    std::vector<Complex> values;
    for (const ComplexVector& at : farther) values.push_back(at[i]);
    velocity[i] = close_velocity(density[1 + 10 * i], layer[1 + 10 * i], values, distance);
  }
  return velocity;
}

void check_experiment() {
  const Body body;
  const std::vector<double> distances{1e-6, 1e-4, 1e-2, 0.1, 0.2, 0.5,
                                      0.8,  1.0,  1.5,  2.0, 3.0, 5.0};
  std::ofstream table("upsampling.csv");
  table << "method,distance,error\n";
  std::vector<study::PlotLine> lines;
  for (const int sigma : {1, 2, 4, 8}) {
    lines.push_back({"rule, sigma = " + std::to_string(sigma)});
    for (const double d : distances) {
      const ComplexVector targets = points_at(d);
      const ComplexVector velocity =
          fine_velocity(ellipse, Side::fluid_outside, body.density, sigma, targets);
      lines.back().points.push_back({d, error_of(body, velocity, targets)});
    }
  }
  lines.push_back({"polynomial of degree 8, sigma = 4"});
  for (const double d : distances) {
    if (d > 1.0) break;
    lines.back().points.push_back({d, error_of(body, interpolated(body, 4, 8, d), points_at(d))});
  }
  for (const study::PlotLine& line : lines) {
    for (const study::PlotPoint& point : line.points) {
      table << line.label << ',' << point.x << ',' << point.y << '\n';
    }
  }
  std::ofstream("upsampling.svg") << study::draw_plot({.title = "Error over the distance",
                                                       .x_label = "distance in spacings",
                                                       .y_label = "largest error, relative",
                                                       .lines = lines});
  for (std::size_t k : {0, 1, 2, 3}) {
    expect({.what = lines[k].label + " at 1e-6 spacings, which must fail",
            .got = lines[k].points.front().y > 0.1 ? 1.0 : 0.0,
            .expected = 1.0,
            .tolerance = 0.0});
  }
  expect({.what = "the rule, sigma = 8, at a spacing",
          .got = lines[3].points[7].y,
          .expected = 0.0,
          .tolerance = 1e-9});
  expect({.what = "the polynomial at 1e-6 spacings",
          .got = lines[4].points.front().y,
          .expected = 0.0,
          .tolerance = 1e-9});
  expect({.what = "the polynomial at half a spacing",
          .got = lines[4].points[5].y,
          .expected = 0.0,
          .tolerance = 1e-4});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the finer rule",
        .formula = "sum over sigma N nodes, density by trigonometric interpolation",
        .hint = "resample() the density, sample() the shape",
        .check = check_fine},
       {.title = "its reach",
        .formula = "d = ln(200/eps)/(2 pi sigma)",
        .hint = "a coarse spacing is sigma fine ones",
        .check = check_reach},
       {.title = "the weights of a polynomial",
        .formula = "l_j(x) = product over k /= j of (x - k)/(j - k), k = 0 ... m",
        .hint = "m + 1 weights, the first for the value at 0",
        .check = check_lagrange},
       {.title = "the velocity close to the curve",
        .builds_on = {3},
        .formula = "l_0(d) (layer - density/2) + sum_j l_j(d) u_j",
        .hint = "the limit from the fluid is the value at distance 0",
        .check = check_close},
       {.title = "the experiment",
        .builds_on = {1, 4},
        .formula = "each line fails as it comes closer than its reach, but for the polynomial",
        .hint = "look at upsampling.svg; the tasks before come first",
        .check = check_experiment}});
}
