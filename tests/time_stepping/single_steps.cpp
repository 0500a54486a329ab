// Checks single steps: the polynomials that they integrate exactly, their stages' times, and their
// evaluations.

#include <cmath>
#include <map>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "problems.hpp"

namespace stokesbook::test {

using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

// f(t) = (1, t, ..., t^9); each component has an exact primitive.
constexpr int powers = 10;
constexpr double t0 = 1.0, dt = 0.5;

VectorXd monomials(double t, const VectorXd&) {
  VectorXd f(powers);
  for (int k = 0; k < powers; ++k) f[k] = std::pow(t, k);
  return f;
}

VectorXd primitives(double t) {
  VectorXd q(powers);
  for (int k = 0; k < powers; ++k) q[k] = std::pow(t, k + 1) / (k + 1);
  return q;
}

// Returns how many of the monomials are integrated exactly.
int exact_components(const TimePoint& end) {
  const VectorXd error = end.state - primitives(end.t);
  int count = 0;
  while (count < powers && std::abs(error[count]) < 2e-14) ++count;
  return count;
}

StepResult one_step(SteppingMethod method, const Rate& f, const TimePoint& start,
                    const StepMemory& memory = {}) {
  SteppingSettings settings = unlimited(method);
  settings.bound.scale = VectorXd::Ones(start.state.size());
  return Stepper(settings, {f, f}).advance(start, memory, start.t + dt);
}

const std::map<SteppingMethod, int> orders{{SteppingMethod::euler, 1},
                                           {SteppingMethod::heun, 2},
                                           {SteppingMethod::rk4, 4},
                                           {SteppingMethod::bogacki_shampine32, 3},
                                           {SteppingMethod::dormand_prince54, 5},
                                           {SteppingMethod::prince_dormand87, 8}};

}  // namespace

BOOST_AUTO_TEST_CASE(exact_for_polynomials_in_time) {
  const TimePoint start{t0, primitives(t0), monomials(t0, {})};
  for (const auto& [method, order] : orders) {
    // The weights of the largest pair integrate one power more than its order requires.
    const int expected = method == SteppingMethod::prince_dormand87 ? 9 : order;
    BOOST_TEST(exact_components(one_step(method, monomials, start).step.end) == expected);
  }
  for (const double before : {0.1, 0.5, 2.0}) {
    const StepMemory memory{.previous = PreviousStep{before, monomials(t0 - before, {})}};
    const StepResult taken = one_step(SteppingMethod::adams_bashforth2, monomials, start, memory);
    BOOST_TEST(exact_components(taken.step.end) == 2);
  }
}

BOOST_AUTO_TEST_CASE(a_linear_system_sees_the_taylor_polynomial) {
  // For q' = A q a step gives the terms of exp(h A) up to the order; the stages permit no further
  // term.
  Eigen::Matrix2d a;
  a << 0.1, -1.0, 1.0, -0.2;
  const Rate f = [&](double, const VectorXd& q) -> VectorXd { return a * q; };
  const Vector2d q{0.6, -0.2};
  for (const auto& [method, order] : orders) {
    if (order > 4) continue;  // methods with more stages than their order have further terms
    Vector2d term = q, taylor = q;
    for (int k = 1; k <= order; ++k) taylor += term = dt / k * a * term;
    BOOST_TEST((one_step(method, f, {0.0, q, a * q}).step.end.state - taylor).norm() < 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(evaluations_are_counted_and_the_last_is_at_the_end) {
  const std::map<SteppingMethod, int> evaluations{{SteppingMethod::euler, 1},
                                                  {SteppingMethod::heun, 2},
                                                  {SteppingMethod::rk4, 4},
                                                  {SteppingMethod::adams_bashforth2, 2},
                                                  {SteppingMethod::bogacki_shampine32, 3},
                                                  {SteppingMethod::dormand_prince54, 6},
                                                  {SteppingMethod::prince_dormand87, 13}};
  for (const auto& [method, expected] : evaluations) {
    int within = 0, at_end = 0;
    const Rates rates{[&](double t, const VectorXd& q) {
                        ++within;
                        return problem_rate(t, q);
                      },
                      [&](double t, const VectorXd& q) {
                        ++at_end;
                        BOOST_TEST(t == 1.25);
                        return problem_rate(t, q);
                      }};
    const StepResult taken = Stepper(unlimited(method), rates).advance(problem_at(1.0), {}, 1.25);
    BOOST_TEST(at_end == 1);
    BOOST_TEST(within == expected - 1);
    const auto& [t, state, rate] = taken.step.end;
    BOOST_TEST((rate - problem_rate(t, state)).norm() == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(stages_of_runge_kutta_4_are_two_in_the_middle_and_one_at_the_end) {
  std::vector<double> times;
  const Rate f = [&](double t, const VectorXd& q) -> VectorXd {
    times.push_back(t);
    return q;
  };
  const VectorXd q = VectorXd::Ones(1);
  one_step(SteppingMethod::rk4, f, {2.0, q, q});
  BOOST_TEST((times == std::vector<double>{2.25, 2.25, 2.5, 2.5}));
}

BOOST_AUTO_TEST_CASE(what_a_rate_throws_goes_through) {
  struct Unexpected {};
  const Rate throws = [](double, const VectorXd&) -> VectorXd { throw Unexpected(); };
  for (const auto& [method, order] : orders) {
    BOOST_CHECK_THROW(one_step(method, throws, problem_at(0.0)), Unexpected);
  }
}

}  // namespace stokesbook::test
