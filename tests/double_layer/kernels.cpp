// Checks that the kernels are Stokes flows with the documented pressures, forces and torques.
#include "double_layer/kernels.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "double_layer/flow_derivatives.hpp"
#include "support/exact_flows.hpp"
#include "support/finite_differences.hpp"

using namespace stokesbook;
using std::numbers::pi;

namespace {

const Complex unit_normal = std::polar(1.0, 0.8), node_density{0.3, -1.1}, force{1.0, 0.5};
constexpr double viscosity = 1.3, gauge = 0.7, torque = -0.9;

// Holds a kernel as a flow about the origin, with the force and torque that the kernel exerts on
// the fluid.
struct Flow {
  std::function<Complex(Complex)> velocity;
  std::function<double(Complex)> pressure;
  std::function<FlowDerivatives(Complex)> derivatives;
  Complex force;
  double torque = 0.0;
};

const std::vector<Flow> flows = {
    {[](Complex r) { return stresslet(r, unit_normal, node_density); },
     [](Complex r) {
       const double rho2 = std::norm(r);
       return viscosity / pi *
              (2.0 * dot(r, unit_normal) * dot(r, node_density) / rho2 -
               dot(unit_normal, node_density)) /
              rho2;
     },
     [](Complex r) { return stresslet_derivatives(r, unit_normal, node_density); },
     {},
     0.0},
    {[](Complex r) { return stokeslet(r, force, viscosity, gauge); },
     [](Complex r) { return dot(r, force) / (2.0 * pi * std::norm(r)); },
     [](Complex r) { return stokeslet_derivatives(r, force, viscosity); }, force, 0.0},
    {[](Complex r) { return rotlet(r, torque, viscosity); },
     [](Complex) { return 0.0; },
     [](Complex r) { return rotlet_derivatives(r, torque, viscosity); },
     {},
     torque}};

}  // namespace

BOOST_AUTO_TEST_CASE(kernels_solve_stokes_equations) {
  for (const Flow& flow : flows) {
    for (Complex r : {Complex{0.9, 0.1}, Complex{-0.5, 0.8}, Complex{0.2, -1.5}}) {
      BOOST_TEST(std::abs(test::divergence(flow.velocity, r)) < 1e-11);
      BOOST_TEST(std::abs(test::momentum_residual(flow.velocity, flow.pressure, viscosity, r)) <
                 1e-9);
      BOOST_TEST(std::abs(viscosity * test::laplacian(flow.velocity, r)) < 10.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_velocity) {
  for (const Flow& flow : flows) {
    for (Complex r : {Complex{0.9, 0.1}, Complex{-0.5, 0.8}, Complex{0.2, -1.5}}) {
      const FlowDerivatives found = flow.derivatives(r);
      const Complex along_1 = test::derivative(flow.velocity, r, 1.0),
                    along_2 = test::derivative(flow.velocity, r, imaginary);
      const Complex strain{along_1.real() - along_2.imag(), along_2.real() + along_1.imag()};
      BOOST_TEST(std::abs(found.strain - strain) < 1e-11);
      BOOST_TEST(std::abs(found.vorticity - (along_1.imag() - along_2.real())) < 1e-11);
      BOOST_TEST(std::abs(viscosity * found.pressure - flow.pressure(r)) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(force_and_torque_through_a_circle) {
  // The force F on the fluid is the integral of the traction -sigma nu over the fluid's inner
  // boundary, with nu outward. The circle's centre is not the singularity.
  const Complex centre{0.2, -0.1};
  constexpr int n = 96;
  for (const Flow& flow : flows) {
    Complex total{};
    double turn = 0.0;
    for (int j = 0; j < n; ++j) {
      const Complex outward = std::polar(1.0, 2.0 * pi * j / n);
      const Complex z = centre + outward;
      const Complex pull = test::traction(flow.velocity, flow.pressure, viscosity, z, outward);
      total -= pull * (2.0 * pi / n);
      turn -= cross(z, pull) * (2.0 * pi / n);
    }
    BOOST_TEST(std::abs(total - flow.force) < 1e-12);
    BOOST_TEST(std::abs(turn - flow.torque) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(the_stresslet_is_symmetric_and_of_degree_minus_one) {
  const Complex r{0.7, -0.4};
  const Complex u = stresslet(r, unit_normal, node_density);
  BOOST_TEST(std::abs(stresslet(r, node_density, unit_normal) - u) < 1e-16);
  BOOST_TEST(std::abs(stresslet(-r, unit_normal, node_density) + u) < 1e-16);
  BOOST_TEST(std::abs(cross(u, r)) < 1e-16);
  for (double scale : {1e-3, 1e3}) {
    BOOST_TEST(std::abs(scale * stresslet(scale * r, unit_normal, node_density) - u) < 1e-15);
  }
  // Goursat form (02.14): (1/4 pi) [a/r + b/conj(r) + r conj(a/r^2)], a = n eta, b = 2 n.eta.
  const Complex a = unit_normal * node_density;
  const double b = 2.0 * dot(unit_normal, node_density);
  const Complex goursat = (a / r + b / std::conj(r) + r * std::conj(a / (r * r))) / (4.0 * pi);
  BOOST_TEST(std::abs(goursat - u) < 1e-15);
}

BOOST_AUTO_TEST_CASE(turning_everything_turns_the_velocity) {
  const Complex turn = std::polar(1.0, 2.1), r{0.7, -0.4};
  BOOST_TEST(std::abs(stresslet(turn * r, turn * unit_normal, turn * node_density) -
                      turn * stresslet(r, unit_normal, node_density)) < 1e-15);
  BOOST_TEST(std::abs(stokeslet(turn * r, turn * force, viscosity, gauge) -
                      turn * stokeslet(r, force, viscosity, gauge)) < 1e-15);
  BOOST_TEST(std::abs(rotlet(turn * r, torque, viscosity) - turn * rotlet(r, torque, viscosity)) <
             1e-15);
}

BOOST_AUTO_TEST_CASE(the_gauge_shifts_a_stokeslet_by_a_uniform_velocity) {
  for (Complex r : {Complex{0.3, 0.1}, Complex{-20.0, 5.0}}) {
    const Complex shift =
        stokeslet(r, force, viscosity, 5.0 * gauge) - stokeslet(r, force, viscosity, gauge);
    BOOST_TEST(std::abs(shift - force * std::log(5.0) / (4.0 * pi * viscosity)) < 1e-15);
  }
  // At rho = ell only the dyad r r.F / rho^2 of (02.2) is left.
  const Complex along = stokeslet(gauge, 1.0, viscosity, gauge);
  const Complex across = stokeslet(gauge, imaginary, viscosity, gauge);
  BOOST_TEST(std::abs(along - 1.0 / (4.0 * pi * viscosity)) < 1e-16);
  BOOST_TEST(std::abs(across) < 1e-16);
}

// Checks the flows that other tests take as exact.
BOOST_AUTO_TEST_CASE(exact_flows_solve_stokes_equations) {
  const test::ExactFlow flow{{{{0.1, 0.2}, {0.5, -0.3}, 0.4}, {{-0.3, 0.0}, {0.1, 0.8}, -0.1}},
                             0.6};
  const auto u = [&](Complex z) { return flow.velocity(z); };
  const auto p = [&](Complex z) { return flow.pressure(z); };
  for (Complex z : {Complex{1.3, 0.4}, Complex{-0.8, 1.1}}) {
    const Complex n = std::polar(1.0, 2.2);
    BOOST_TEST(std::abs(test::divergence(u, z)) < 1e-11);
    BOOST_TEST(std::abs(test::momentum_residual(u, p, 1.0, z)) < 1e-9);
    BOOST_TEST(std::abs(test::traction(u, p, 1.0, z, n) - flow.traction(z, n)) < 1e-11);
  }
}
