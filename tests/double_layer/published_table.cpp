// Reproduces table 2 of the published convergence study: the trapezoid rule evaluates u = (x, -y)
// inside the ellipse (cos t, 2 sin t) ever closer to the ellipse's tip, with the density of a dense
// solve.
#include <cmath>

#include <boost/test/unit_test.hpp>

#include "support/dirichlet.hpp"
#include "support/exact_flows.hpp"
#include "support/plain_rule.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

const test::ExactFlow extension{{}, 1.0};

double error_at(double y, Index n) {
  const Curve wall = sample(Ellipse{1.0, 2.0}, n, Side::fluid_inside);
  const ComplexVector density = test::density_of(wall, extension.velocity(wall.x));
  const ComplexVector target = ComplexVector::Constant(1, {0.0, y});
  // StressletSum would bound the distance from the tip's own node from below; the plain rule does
  // not.
  return std::abs((test::plain_rule(wall, density, target) - extension.velocity(target))[0]);
}

// The tolerance is half a unit of the third digit printed.
void check_row(Index n, double y, double printed) {
  BOOST_TEST_CONTEXT("N = " << n << ", y = " << y) {
    BOOST_TEST(std::abs(error_at(y, n) / printed - 1.0) < 5e-3);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(published_errors_of_the_plain_rule) {
  check_row(32, 1.0, 1.01e-6);
  check_row(32, 1.9, 6.04e-1);
  check_row(32, 1.99, 2.07e1);
  check_row(128, 1.9, 4.17e-5);
  check_row(128, 1.99, 3.84);
  check_row(256, 1.9, 4.59e-11);
  check_row(256, 1.99, 1.13);
  check_row(512, 1.99, 1.30e-1);
  BOOST_TEST(error_at(1.0, 128) < 5e-15);
  BOOST_TEST(error_at(1.9, 512) < 5e-14);
}
