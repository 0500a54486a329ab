// What single steps are exact for, and which times the stages see.
#include "time_stepping/steps.hpp"

#include <cmath>
#include <vector>

#include <boost/test/unit_test.hpp>

using namespace stokesbook;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

// Integrates f(t) = (1, t, t^2, t^3) by a step from 1 to 1.5; each component has an exact
// primitive.
constexpr double t0 = 1.0, dt = 0.5;

VectorXd monomials(double t, const VectorXd&) {
  return Eigen::Vector4d{1.0, t, t * t, t * t * t};
}

VectorXd primitives(double t) {
  return Eigen::Vector4d{t, t * t / 2.0, std::pow(t, 3) / 3.0, std::pow(t, 4) / 4.0};
}

// How many of the monomials are integrated exactly.
int exact_components(const VectorXd& q) {
  const VectorXd error = q - primitives(t0 + dt);
  int count = 0;
  while (count < 4 && std::abs(error[count]) < 1e-15) ++count;
  return count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_for_polynomials_in_time) {
  const VectorXd q = primitives(t0), rate = monomials(t0, q);
  BOOST_TEST(exact_components(euler_step(q, dt, rate)) == 1);
  for (double previous_dt : {0.1, 0.5, 2.0}) {
    const PreviousStep previous{previous_dt, monomials(t0 - previous_dt, q)};
    BOOST_TEST(exact_components(adams_bashforth2_step(q, dt, rate, previous)) == 2);
  }
  BOOST_TEST(exact_components(runge_kutta4_step(monomials, t0, q, dt, rate)) == 4);
}

BOOST_AUTO_TEST_CASE(a_linear_system_sees_the_taylor_polynomial) {
  // q' = A q with a rotation: q + h A q + ... + (h A)^4 q / 24.
  Eigen::Matrix2d a;
  a << 0.0, -1.0, 1.0, 0.0;
  const Rate f = [&](double, const VectorXd& q) -> VectorXd { return a * q; };
  const VectorXd q = Vector2d{0.6, -0.2};
  const Eigen::Matrix2d ha = 0.3 * a, identity = Eigen::Matrix2d::Identity();
  const VectorXd euler = (identity + ha) * q;
  const VectorXd runge_kutta =
      (identity + ha * (identity + ha / 2.0 * (identity + ha / 3.0 * (identity + ha / 4.0)))) * q;
  BOOST_TEST((euler_step(q, 0.3, f(0.0, q)) - euler).norm() < 1e-15);
  BOOST_TEST((runge_kutta4_step(f, 0.0, q, 0.3, f(0.0, q)) - runge_kutta).norm() < 1e-15);
}

BOOST_AUTO_TEST_CASE(runge_kutta_evaluates_twice_in_the_middle_and_once_at_the_end) {
  std::vector<double> times;
  const Rate f = [&](double t, const VectorXd& q) -> VectorXd {
    times.push_back(t);
    return q;
  };
  const VectorXd q = VectorXd::Ones(1);
  runge_kutta4_step(f, 2.0, q, 0.5, q);
  BOOST_TEST((times == std::vector<double>{2.25, 2.25, 2.5}));
}
