// Checks that estimates of a step's error (09.7), (09.8) are close to the error for fixed steps of
// low order, and larger than the error for all other methods.

#include <functional>

#include <boost/test/unit_test.hpp>

#include "problems.hpp"

namespace stokesbook::test {

using Eigen::VectorXd;

namespace {

// Holds the estimated error and the true error of one step from the exact solution. The step
// before may have another length, or there is no step before.
struct FromExact {
  VectorXd estimate, error;
};

FromExact one_step(SteppingMethod method, double h, std::optional<double> ratio) {
  constexpr double t = 0.7;
  StepMemory memory{.dt = h};
  if (ratio) {
    const double before = h / *ratio;
    memory.previous = PreviousStep{before, problem_at(t - before).rate};
  }
  const Stepper stepper(unlimited(method), {problem_rate, problem_rate});
  const StepResult taken = stepper.advance(problem_at(t), memory, t + h);
  return {taken.error, problem_solution(t + h) - taken.step.end.state};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_estimate_of_a_fixed_step_of_low_order_is_its_error) {
  for (const SteppingMethod method :
       {SteppingMethod::euler, SteppingMethod::adams_bashforth2, SteppingMethod::heun}) {
    for (const double ratio : {0.5, 1.0, 1.7}) {
      for (const double h : {1e-2, 1e-3}) {
        const auto [estimate, error] = one_step(method, h, ratio);
        const VectorXd relative = estimate.cwiseQuotient(error).array() - 1.0;
        BOOST_TEST(relative.lpNorm<Eigen::Infinity>() < 10.0 * h,
                   "method " << static_cast<int>(method) << ", h = " << h << ", ratio " << ratio
                             << ": " << relative.transpose());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_first_step_by_euler_needs_none_before_it) {
  for (const double h : {1e-2, 1e-3}) {
    const auto [estimate, error] = one_step(SteppingMethod::euler, h, {});
    BOOST_TEST((estimate.cwiseQuotient(error).array() - 1.0).abs().maxCoeff() < 10.0 * h);
  }
}

BOOST_AUTO_TEST_CASE(estimates_of_higher_orders_are_too_large) {
  for (const SteppingMethod method :
       {SteppingMethod::rk4, SteppingMethod::bogacki_shampine32, SteppingMethod::dormand_prince54,
        SteppingMethod::prince_dormand87}) {
    const double h = method == SteppingMethod::prince_dormand87 ? 0.2 : 0.02;
    const auto [estimate, error] = one_step(method, h, 1.0);
    BOOST_TEST(estimate.norm() > error.norm(), "method " << static_cast<int>(method) << ": "
                                                         << estimate.norm() << " for "
                                                         << error.norm());
  }
}

BOOST_AUTO_TEST_CASE(the_estimate_of_runge_kutta_4_is_of_the_fourth_power) {
  const auto estimate = [](double h) {
    return one_step(SteppingMethod::rk4, h, {}).estimate.norm();
  };
  BOOST_TEST(std::abs(std::log2(estimate(0.02) / estimate(0.01)) - 4.0) < 0.15);
}

}  // namespace stokesbook::test
