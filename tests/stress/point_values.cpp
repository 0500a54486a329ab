// Checks stress, traction, velocity gradient and dissipation (07.5) from the derivatives at a
// point, against finite differences of exact flows.
#include <cmath>

#include <boost/test/unit_test.hpp>

#include "stress/stress.hpp"
#include "support/exact_derivatives.hpp"
#include "support/finite_differences.hpp"

using namespace stokesbook;

namespace {

const test::ExactFlow poles{{{{0.1, 0.2}, {0.5, -0.3}, 0.4}, {{-0.3, 0.1}, {0.1, 0.8}, -0.1}}, 0.7};

FlowDerivatives at(Complex z) {
  return test::derivatives_of(poles, z);
}

Complex velocity(Complex z) {
  return poles.velocity(z);
}

constexpr Complex point{1.1, -0.7};
constexpr double accuracy = 1e-10;  // of the finite differences

// Returns the force per length that the material on the side of n exerts.
Complex applied(const Stress& s, Complex n) {
  return {s.s11 * n.real() + s.s12 * n.imag(), s.s12 * n.real() + s.s22 * n.imag()};
}

}  // namespace

BOOST_AUTO_TEST_CASE(velocity_gradient_by_differences) {
  const VelocityGradient gradient = velocity_gradient(at(point));
  const Complex along_1 = test::derivative(velocity, point, 1.0);
  const Complex along_2 = test::derivative(velocity, point, imaginary);
  BOOST_TEST(std::abs(Complex{gradient.du1_dx1, gradient.du2_dx1} - along_1) < accuracy);
  BOOST_TEST(std::abs(Complex{gradient.du1_dx2, gradient.du2_dx2} - along_2) < accuracy);
}

BOOST_AUTO_TEST_CASE(gradient_and_derivatives_are_inverse) {
  const FlowDerivatives there = at(point), back = flow_derivatives(velocity_gradient(there));
  BOOST_TEST(back.pressure == 0.0);
  BOOST_TEST(std::abs(back.vorticity - there.vorticity) < 1e-15);
  BOOST_TEST(std::abs(back.strain - there.strain) < 1e-15);
}

BOOST_AUTO_TEST_CASE(stress_and_traction) {
  const double mu = 1.3;
  const FlowDerivatives there = at(point);
  const Complex n = std::polar(1.0, 0.4);
  const auto pressure = [&](Complex z) { return mu * poles.pressure(z); };
  const Complex expected = test::traction(velocity, pressure, mu, point, n);
  BOOST_TEST(std::abs(traction(there, n, mu) - expected) < accuracy);
  BOOST_TEST(std::abs(applied(stress(there, mu), n) - expected) < accuracy);
}

// Checks 2 mu e:e, and the principal shear stress against the largest shear over all directions.
BOOST_AUTO_TEST_CASE(dissipation_and_largest_shear_stress) {
  const double mu = 1.3;
  const VelocityGradient g = velocity_gradient(at(point));
  const double e12 = 0.5 * (g.du1_dx2 + g.du2_dx1);
  const double sum = g.du1_dx1 * g.du1_dx1 + 2.0 * e12 * e12 + g.du2_dx2 * g.du2_dx2;
  BOOST_TEST(std::abs(dissipation_density(at(point), mu) - 2.0 * mu * sum) < 1e-14);
  const Stress s = stress(at(point), mu);
  double largest = 0.0;
  for (int k = 0; k < 1000; ++k) {
    const Complex n = std::polar(1.0, 1e-3 * k * 3.15);
    largest = std::max(largest, dot(perp(n), applied(s, n)));
  }
  BOOST_TEST(std::abs(largest_shear_stress(at(point), mu) / largest - 1.0) < 1e-5);
}

BOOST_AUTO_TEST_CASE(pure_shear) {
  const double rate = 2.0, mu = 3.0;  // u = (rate y, 0)
  const FlowDerivatives shear = flow_derivatives({.du1_dx2 = rate});
  BOOST_TEST(shear.vorticity == -rate);
  BOOST_TEST(stress(shear, mu).s12 == mu * rate);
  BOOST_TEST(stress(shear, mu).s11 == 0.0);
  BOOST_TEST(largest_shear_stress(shear, mu) == mu * rate);
  BOOST_TEST(dissipation_density(shear, mu) == mu * rate * rate);
}
