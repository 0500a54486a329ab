// Check of exercise 02.2: loads that are known, double layers, and a Dirichlet problem.
#include "chapters/check.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "study/plot.hpp"
#include "support/dense.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;

using Velocity = std::function<Complex(Complex)>;

Complex force(const Velocity& u, double viscosity, double inner, double outer);
double torque(const Velocity& u, double viscosity, double radius);
double flux(const Velocity& u, double radius);
Velocity completion(Complex force, double torque, double viscosity);

namespace {

constexpr double viscosity = 1.7;
const Complex load{0.8, -0.5}, place{0.3, 0.1};
constexpr double turn = 0.9;

// A load away from the origin; its torque about the origin contains that of the force.
Complex loaded_flow(Complex z) {
  return stokeslet(z - place, load, viscosity, 1.0) + rotlet(z - place, turn, viscosity);
}
const double whole_torque = turn + cross(place, load);

struct Layer {
  Curve curve = sample(Ellipse{0.8, 0.5}, 128, Side::fluid_outside);
  ComplexVector density =
      (Complex{0.4, 0.7} * curve.x.array().square() + 0.6 * curve.x.array() + Complex{0.2, -1.0})
          .matrix();

  Complex operator()(Complex z) const {
    return StressletSum({curve})(ComplexVector::Constant(1, z), density)[0];
  }
  double outflow() const {
    return normals(curve).conjugate().cwiseProduct(density).real().dot(weights(curve));
  }
};

Velocity times(double factor, const Velocity& flow) {
  return [factor, flow](Complex z) { return factor * flow(z); };
}

void check_force(double factor, double inner, double outer) {
  const std::string radii = ", radii " + exercise::text(inner) + " and " + exercise::text(outer);
  const Complex exact = factor * load;
  expect({.what = exercise::text(factor) + " times Stokeslet and rotlet at (0.3, 0.1)" + radii,
          .got = force(times(factor, loaded_flow), viscosity, inner, outer),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {{-exact,
                        "this is the force by the fluid: near the body the velocity is that "
                        "of the push"},
                       {exact / viscosity, "the viscosity is missing"},
                       {exact / (4.0 * pi * viscosity), "the factor 4 pi mu is missing"},
                       {exact * std::log(outer / inner),
                        "the difference is to be divided by the "
                        "logarithm of the radii's ratio"},
                       {0.5 * exact, "half of the force"}}});
  expect({.what = "a double layer" + radii,
          .got = force(Layer(), viscosity, inner, outer),
          .expected = Complex{},
          .tolerance = 1e-10});
}

void check_torque(double factor, double radius) {
  const std::string where = ", radius " + exercise::text(radius);
  const double exact = factor * whole_torque;
  expect({.what = exercise::text(factor) + " times Stokeslet and rotlet at (0.3, 0.1)" + where,
          .got = torque(times(factor, loaded_flow), viscosity, radius),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {
              {0.5 * exact, "this is the circulation times the viscosity: half of the torque"},
              {-exact, "the torque is positive counter-clockwise"},
              {factor * turn, "the force at (0.3, 0.1) has a torque about the origin too"},
              {exact / radius, "a factor of the radius is missing"},
              {exact / viscosity, "the viscosity is missing"}}});
  expect({.what = "a double layer" + where,
          .got = torque(Layer(), viscosity, radius),
          .expected = 0.0,
          .tolerance = 1e-10});
}

void check_flux(double factor, double radius) {
  const std::string where = ", radius " + exercise::text(radius);
  const Layer layer;
  const double exact = factor * layer.outflow();
  expect({.what = exercise::text(factor) + " times a double layer" + where +
                  ": the integral of eta.n over the body",
          .got = flux(times(factor, layer), radius),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {{-exact, "this is what flows in"},
                       {exact / (2.0 * pi * radius), "the length of the circle is missing"},
                       {exact / radius, "the radius is missing"},
                       {exact / (2.0 * pi), "the factor 2 pi is missing"}}});
  expect({.what = "Stokeslet and rotlet" + where,
          .got = flux(loaded_flow, radius),
          .expected = 0.0,
          .tolerance = 1e-10});
}

void check_completion(Complex z) {
  const auto exact = [&](double of_force, double of_torque) {
    return of_force * stokeslet(z, load, viscosity, 1.0) + of_torque * rotlet(z, turn, viscosity);
  };
  const double scale = 4.0 * pi * viscosity;
  expect({.what = "the velocity at " + exercise::text(z),
          .got = completion(load, turn, viscosity)(z),
          .expected = exact(1.0, 1.0),
          .tolerance = 1e-12,
          .mistakes = {{exact(1.0, -1.0), "the torque has the other sign: it is counter-clockwise"},
                       {exact(-1.0, 1.0), "the force has the other sign"},
                       {exact(scale, scale), "1/(4 pi mu) is missing: the strengths are loads"},
                       {exact(1.0, scale), "1/(4 pi mu) is missing in the rotlet"},
                       {exact(1.0, 0.0), "the rotlet is missing"},
                       {exact(0.0, 1.0), "the Stokeslet is missing"}}});
}

// -1/2 + D less the mean rigid motion.
Eigen::MatrixXd system_matrix(const Curve& body) {
  const Index n = body.size();
  Eigen::MatrixXd matrix =
      double_layer_matrix(body) - 0.5 * Eigen::MatrixXd::Identity(2 * n, 2 * n);
  const Eigen::VectorXd share = weights(body) / perimeter(body);
  ComplexVector motion = ComplexVector::Ones(n);
  for (int k = 0; k < 3; ++k) {
    if (k == 1) motion *= imaginary;
    if (k == 2)
      motion = motion.cwiseProduct(body.x - boundary_centroid(body) * ComplexVector::Ones(n));
    const ComplexVector mean = motion.cwiseProduct(share) / share.dot(motion.cwiseAbs2());
    matrix -= interleaved(motion) * interleaved(mean).transpose();
  }
  return matrix;
}

// Largest relative error on the circle of radius 2 of the double layer completed by a velocity.
double error_with(const Velocity& completing, Index n) {
  const Curve body = sample(Ellipse{0.8, 0.5}, n, Side::fluid_outside);
  const ComplexVector data =
      body.x.unaryExpr([&](Complex z) { return loaded_flow(z) - completing(z); });
  const Eigen::VectorXd density = test::solve(system_matrix(body), interleaved(data));
  const ComplexVector targets = 2.0 * sample(Circle{1.0}, 10, Side::fluid_outside).x;
  const ComplexVector layer = StressletSum({body})(targets, deinterleaved(density));
  const ComplexVector exact = targets.unaryExpr(&loaded_flow);
  return (layer + targets.unaryExpr(completing) - exact).cwiseAbs().maxCoeff() /
         exact.cwiseAbs().maxCoeff();
}

void check_experiment() {
  const Complex measured_force = force(loaded_flow, viscosity, 3.0, 7.0);
  const double measured_torque = torque(loaded_flow, viscosity, 3.0);
  const Velocity completed = completion(measured_force, measured_torque, viscosity);
  const Velocity nothing = [](Complex) { return Complex{}; };
  std::ofstream table("completion.csv");
  table << "nodes,completed,alone\n";
  study::PlotLine with{"double layer, completed"}, without{"double layer alone"};
  for (Index n = 10; n <= 90; n += 10) {
    const double nodes = static_cast<double>(n);
    with.points.push_back({nodes, error_with(completed, n)});
    without.points.push_back({nodes, error_with(nothing, n)});
    table << n << ',' << with.points.back().y << ',' << without.points.back().y << '\n';
  }
  std::ofstream("completion.svg") << study::draw_plot(
      {.title = "Error of the velocity",
       .x_label = "nodes N",
       .y_label = "largest error at distance 2, relative",
       .log_x = false,
       .lines = {with, without}});
  const double last = with.points.back().y, alone = without.points.back().y;
  expect({.what = "90 nodes, completed", .got = last, .expected = 0.0, .tolerance = 1e-11});
  expect({.what = "90 nodes, alone, which must fail",
          .got = alone > 0.05 ? 1.0 : 0.0,
          .expected = 1.0,
          .tolerance = 0.0});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the force",
        .formula = "4 pi mu (mean on the inner circle - mean on the outer)/log(outer/inner)",
        .hint = "the mean of a Stokeslet falls with the logarithm of the radius",
        .check =
            [] {
              check_force(1.0, 3.0, 7.0);
              check_force(-2.0, 2.0, 5.0);
            }},
       {.title = "the torque",
        .formula = "4 pi mu R times the mean of u.t, t = i exp(i t)",
        .hint = "a rotlet turns with L/(4 pi mu R)",
        .check =
            [] {
              check_torque(1.0, 3.0);
              check_torque(-2.0, 5.0);
            }},
       {.title = "the flux",
        .formula = "2 pi R times the mean of u.n, n = exp(i t)",
        .hint = "an integral over the arclength of the circle",
        .check =
            [] {
              check_flux(1.0, 3.0);
              check_flux(-2.0, 5.0);
            }},
       {.title = "the completion",
        .formula = "S F + R L, both with 1/(4 pi mu)",
        .hint = "double_layer/kernels.hpp has both",
        .check =
            [] {
              check_completion({1.1, -0.6});
              check_completion({-0.4, 1.3});
            }},
       {.title = "the experiment",
        .builds_on = {1, 2, 4},
        .formula = "double layer + completion = flow",
        .hint = "look at completion.svg; the tasks before come first",
        .check = check_experiment}});
}
