// Table 2 of the published convergence study: plain trapezoid evaluation of u = (x, -y) inside the
// ellipse (cos t, 2 sin t), ever closer to its tip, with the density of a dense solve.
#include <cmath>

#include <boost/test/unit_test.hpp>

#include "double_layer/kernels.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_flows.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

const test::ExactFlow extension{{}, 1.0};

// The rule without the bound of StressletSum, which quenches the tip's own node.
Complex plain_rule(const Curve& curve, const ComplexVector& density, Complex target) {
  const Eigen::VectorXd w = weights(curve);
  const ComplexVector normal = normals(curve);
  Complex velocity{};
  for (Index j = 0; j < curve.size(); ++j) {
    velocity += w[j] * stresslet(target - curve.x[j], normal[j], density[j]);
  }
  return velocity;
}

double error_at(double y, Index n) {
  const Curve wall = sample(Ellipse{1.0, 2.0}, n, Side::fluid_inside);
  const ComplexVector density = test::density_of(wall, extension.velocity(wall.x));
  const Complex target{0.0, y};
  return std::abs(plain_rule(wall, density, target) - extension.velocity(target));
}

// Half a unit of the third digit printed.
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
