// The schemes have the orders 1, 2 and 4, neither less nor more, on Jeffery's nonlinear equation
// whose solution is known, with constant and with variable steps.
#include <cmath>
#include <functional>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "time_stepping/steps.hpp"

using namespace stokesbook;
using Eigen::VectorXd;

namespace {

// A slender ellipse in shear: theta' = -(a^2 sin^2 theta + b^2 cos^2 theta) / (a^2 + b^2).
constexpr double aspect = 3.0;

VectorXd jeffery_rate(double, const VectorXd& theta) {
  const double s = aspect * std::sin(theta[0]), c = std::cos(theta[0]);
  return VectorXd::Constant(1, -(s * s + c * c) / (aspect * aspect + 1.0));
}

// tan theta = -(1 / lambda) tan(lambda t / (1 + lambda^2)), on the branch that starts at 0.
double jeffery_angle(double t) {
  const double phase = aspect * t / (1.0 + aspect * aspect);
  const double half_turns = std::floor(phase / std::numbers::pi + 0.5);
  return -std::numbers::pi * half_turns -
         std::atan(std::tan(phase - std::numbers::pi * half_turns) / aspect);
}

enum class Scheme { euler, adams_bashforth2, runge_kutta4 };
constexpr double t_final = 8.0;

// Equal steps, or 3/2, 1/2, 1/2 and 3/2 of their mean in turn.
double step_length(int k, int count, bool variable) {
  const double mean = t_final / count;
  if (!variable) return mean;
  return k % 4 == 0 || k % 4 == 3 ? 1.5 * mean : 0.5 * mean;
}

// Error of the angle after `count` steps, a multiple of 4.
double error_of(Scheme scheme, int count, bool variable) {
  VectorXd theta = VectorXd::Zero(1);
  PreviousStep previous;
  double t = 0.0;
  for (int k = 0; k < count; ++k) {
    const double dt = step_length(k, count, variable);
    const VectorXd rate = jeffery_rate(t, theta);
    if (scheme == Scheme::euler) {
      theta = euler_step(theta, dt, rate);
    } else if (scheme == Scheme::runge_kutta4 || k == 0) {
      theta = runge_kutta4_step(jeffery_rate, t, theta, dt, rate);
    } else {
      theta = adams_bashforth2_step(theta, dt, rate, previous);
    }
    previous = {dt, rate};
    t += dt;
  }
  return std::abs(theta[0] - jeffery_angle(t));
}

void check_order(Scheme scheme, int fewest_steps, double order) {
  for (bool variable : {false, true}) {
    for (int count = fewest_steps; count <= 4 * fewest_steps; count *= 2) {
      const double measured =
          std::log2(error_of(scheme, count, variable) / error_of(scheme, 2 * count, variable));
      BOOST_TEST_CONTEXT((variable ? "variable" : "constant") << " steps, " << count) {
        BOOST_TEST(std::abs(measured - order) < 0.1);
      }
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_closed_form_meets_the_reference_numbers) {
  BOOST_TEST(std::abs(jeffery_angle(2.0) + 0.22421139330007344) < 1e-15);
  BOOST_TEST(std::abs(jeffery_angle(8.0) + 2.8452457464153368) < 2e-15);
  const double half_turn = std::numbers::pi * (aspect + 1.0 / aspect);
  BOOST_TEST(std::abs(jeffery_angle(half_turn) + std::numbers::pi) < 1e-14);
}

BOOST_AUTO_TEST_CASE(euler_is_of_order_1) {
  check_order(Scheme::euler, 400, 1.0);
}

BOOST_AUTO_TEST_CASE(adams_bashforth_is_of_order_2) {
  check_order(Scheme::adams_bashforth2, 200, 2.0);
}

BOOST_AUTO_TEST_CASE(runge_kutta_is_of_order_4) {
  check_order(Scheme::runge_kutta4, 80, 4.0);
}
