// Checks the quadrature over the fluid (07.12), (07.13): areas, moments and functions with poles in
// the bodies, against boundary integrals.
#include "stress/fluid_quadrature.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "support/lopsided_curve.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

struct Case {
  const char* name;
  std::vector<Curve> curves;
  std::vector<Complex> poles;  // in the bodies
};

std::vector<Case> cases(double scale = 1.0) {
  const auto wall = [&](const Shape& shape, Index n) {
    return sample(shape, n, Side::fluid_inside);
  };
  const auto body = [&](const Shape& shape, Index n, Complex position, double orientation = 0.0) {
    return place(sample(shape, n, Side::fluid_outside), scale * position, orientation);
  };
  const Circle outer{3.0 * scale};
  return {{"annulus", {wall(outer, 128), body(Circle{scale}, 96, {})}, {0.1 * scale}},
          {"eccentric",
           {wall(outer, 160), body(Circle{scale}, 128, {0.7, 0.4})},
           {scale * Complex{0.7, 0.4}}},
          {"two bodies in an ellipse",
           {wall(Ellipse{4.0 * scale, 3.0 * scale}, 192),
            body(Ellipse{scale, 0.5 * scale}, 128, {-1.4, 0.3}, 0.7),
            body(Star{0.9 * scale, 0.12, 3}, 160, {1.5, -0.2}, 0.3)},
           {scale * Complex{-1.4, 0.3}, scale * Complex{1.5, -0.2}}}};
}

// The body has a hollow, so the strips are narrow.
Case lopsided_body() {
  const Complex centre{1.6, -0.2};
  return {"lopsided body",
          {sample(Ellipse{4.0, 3.0}, 192, Side::fluid_inside),
           place(sample(test::lopsided_curve(), 160, Side::fluid_outside), centre, 0.3)},
          {centre}};
}

// Evaluates a function that is analytic in the fluid, and its derivative.
struct Analytic {
  std::vector<Complex> poles;  // of order 1
  int power = 0;

  Complex value(Complex z) const {
    Complex sum = std::pow(z, power);
    for (const Complex pole : poles) sum += 1.0 / (z - pole);
    return sum;
  }
  Complex slope(Complex z) const {
    Complex sum = static_cast<double>(power) * std::pow(z, power - 1);
    for (const Complex pole : poles) sum -= 1.0 / ((z - pole) * (z - pole));
    return sum;
  }
};

// Integrates |f'|^2 over the fluid by the quadrature rule. The next function computes the same
// integral by Green's theorem.
double by_rule(const FluidQuadrature& rule, const Analytic& f) {
  double sum = 0.0;
  for (Index i = 0; i < rule.points.size(); ++i) {
    sum += rule.weights[i] * std::norm(f.slope(rule.points[i]));
  }
  return sum;
}

double by_boundary(const std::vector<Curve>& curves, const Analytic& f) {
  double sum = 0.0;
  for (const Curve& curve : curves) {
    const Eigen::VectorXd w = weights(curve);
    const ComplexVector n = normals(curve);
    for (Index j = 0; j < w.size(); ++j) {
      const Complex z = curve.x[j];
      sum += 0.5 * w[j] * (std::conj(f.value(z)) * f.slope(z) * n[j]).real();
    }
  }
  return sum;
}

void check_area(const FluidQuadrature& rule, const std::vector<Curve>& curves) {
  double fluid = 0.0;
  for (const Curve& curve : curves) fluid += curve.sign() * area(curve);
  BOOST_TEST(std::abs(rule.weights.sum() - fluid) < 1e-11 * fluid);
  BOOST_TEST(rule.weights.minCoeff() > 0.0);
}

// The measured errors are up to 2e-13 with 18 points per width.
void check_integrals(const Case& c) {
  const FluidQuadrature rule = fluid_quadrature(c.curves);
  BOOST_TEST_CONTEXT(c.name) {
    check_area(rule, c.curves);
  }
  for (const Analytic& f : {Analytic{{}, 2}, Analytic{{}, 5}, Analytic{c.poles, 3}}) {
    BOOST_TEST_CONTEXT(c.name << ", power " << f.power) {
      const double exact = by_boundary(c.curves, f);
      BOOST_TEST(std::abs(by_rule(rule, f) - exact) < 1e-11 * exact);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(areas_in_other_units) {
  for (double scale : {1e-3, 1e3}) {
    const Case annulus = cases(scale)[0];
    check_area(fluid_quadrature(annulus.curves), annulus.curves);
  }
}

BOOST_AUTO_TEST_CASE(areas_polynomials_and_poles) {
  for (const Case& c : cases()) check_integrals(c);
}

BOOST_AUTO_TEST_CASE(areas_polynomials_and_poles_around_a_hollow,
                     *boost::unit_test::label("full")) {
  check_integrals(lopsided_body());
}

// The error decreases with the spacing, so a large error shows that the grid is too coarse.
BOOST_AUTO_TEST_CASE(converges_with_the_grid) {
  const Case c = cases()[1];
  const Analytic f{c.poles, 3};
  const double exact = by_boundary(c.curves, f);
  const auto error = [&](double points_per_width) {
    return std::abs(by_rule(fluid_quadrature(c.curves, points_per_width), f) / exact - 1.0);
  };
  BOOST_TEST(error(3.0) > 1e-6);
  BOOST_TEST(error(9.0) < 1e-2 * error(3.0));
}

BOOST_AUTO_TEST_CASE(width_of_the_strips) {
  const Curve wall = sample(Circle{3.0}, 64, Side::fluid_inside);
  const Curve body = sample(Circle{1.0}, 64, Side::fluid_outside);
  BOOST_TEST(std::abs(strip_width({wall, body}) - 1.0) < 1e-12);
  BOOST_TEST(std::abs(strip_width({wall, place(body, 1.5, 0.0)}) - 0.25) < 1e-12);
  BOOST_TEST(std::abs(strip_width({wall}) - 1.5) < 1e-12);
}

BOOST_AUTO_TEST_CASE(wants_one_enclosing_wall) {
  const Curve wall = sample(Circle{3.0}, 64, Side::fluid_inside);
  const Curve body = sample(Circle{1.0}, 64, Side::fluid_outside);
  BOOST_CHECK_THROW(fluid_quadrature({body}), std::invalid_argument);
  BOOST_CHECK_THROW(fluid_quadrature({wall, wall}), std::invalid_argument);
}
