// Checks that methods, estimates (09.7) and interpolants (09.11) have exactly their orders, on
// nonlinear equations with known solutions, with constant and with variable steps.

#include <algorithm>
#include <functional>

#include <boost/test/unit_test.hpp>

#include "problems.hpp"
#include "time_stepping/runge_kutta.hpp"

namespace stokesbook::test {

namespace {

constexpr double t_final = 8.0;

// Returns the ends of equal steps, or of steps whose lengths are 3/2, 1/2, 1/2 and 3/2 times their
// mean in turn. The number `count` is a multiple of 4.
std::vector<double> step_ends(int count, bool variable) {
  const double mean = t_final / count;
  std::vector<double> ends;
  for (double t = 0.0; const double part : {1.5, 0.5, 0.5, 1.5}) {
    t += (variable ? part : 1.0) * mean;
    ends.push_back(t);
  }
  while (static_cast<int>(ends.size()) < count) ends.push_back(ends[ends.size() - 4] + 4.0 * mean);
  return ends;
}

std::vector<Step> steps_of(SteppingMethod method, int count, bool variable) {
  const Stepper stepper(unlimited(method), {problem_rate, problem_rate});
  const std::vector<Step> steps =
      steps_through(stepper, problem_at(0.0), step_ends(count, variable));
  BOOST_REQUIRE_EQUAL(steps.size(), static_cast<std::size_t>(count));
  return steps;
}

double end_error(const std::vector<Step>& steps) {
  return problem_error(steps.back().end.t, steps.back().end.state);
}

// Returns the largest error of the interpolants between the ends of steps.
double error_within(const std::vector<Step>& steps) {
  double error = 0.0;
  for (const Step& step : steps) {
    for (const double part : {0.2, 0.5, 0.7}) {
      const double t = step.start.t + part * step.dt();
      error = std::max(error, problem_error(t, interpolate(step, t)));
    }
  }
  return error;
}

// Checks the exponent of h in a quantity by halving h.
void check_power(const std::function<double(double)>& quantity, double h, double expected) {
  for (const double step : {h, 0.5 * h}) {
    const double measured = std::log2(quantity(step) / quantity(0.5 * step));
    BOOST_TEST(std::abs(measured - expected) < 0.15, "h = " << step << ": h^" << measured);
  }
}

void check_order(SteppingMethod method, int fewest_steps, double order) {
  for (bool variable : {false, true}) {
    BOOST_TEST_CONTEXT((variable ? "variable" : "constant") << " steps") {
      check_power(
          [&](double h) {
            return end_error(
                steps_of(method, static_cast<int>(std::lround(t_final / h)), variable));
          },
          t_final / fewest_steps, order);
    }
  }
}

StepResult one_step(SteppingMethod method, double h) {
  SteppingSettings settings = unlimited(method);
  settings.dt = h;
  return Stepper(settings, {problem_rate, problem_rate}).advance(problem_at(0.7), {}, 0.7 + h);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_closed_form_meets_the_reference_numbers) {
  BOOST_TEST(std::abs(jeffery_angle(aspect, 2.0) + 0.22421139330007344) < 1e-15);
  BOOST_TEST(std::abs(jeffery_angle(aspect, 8.0) + 2.8452457464153368) < 2e-15);
  const double half_turn = std::numbers::pi * (aspect + 1.0 / aspect);
  BOOST_TEST(std::abs(jeffery_angle(aspect, half_turn) + std::numbers::pi) < 1e-14);
}

BOOST_AUTO_TEST_CASE(methods_have_their_orders) {
  check_order(SteppingMethod::euler, 3200, 1.0);
  check_order(SteppingMethod::adams_bashforth2, 800, 2.0);
  check_order(SteppingMethod::heun, 400, 2.0);
  check_order(SteppingMethod::rk4, 400, 4.0);
  check_order(SteppingMethod::bogacki_shampine32, 400, 3.0);
  check_order(SteppingMethod::dormand_prince54, 100, 5.0);
}

BOOST_AUTO_TEST_CASE(the_pair_of_prince_and_dormand_has_order_8) {
  // For y, the terms of higher order are so large that the measured order would be 8 only at errors
  // below rounding.
  const auto angle_error = [](int count) {
    const TimePoint end = steps_of(SteppingMethod::prince_dormand87, count, false).back().end;
    return std::abs(end.state[0] - jeffery_angle(aspect, t_final));
  };
  BOOST_TEST(std::abs(std::log2(angle_error(20) / angle_error(40)) - 8.0) < 0.15);
  const Rate rotation = [](double, const Eigen::VectorXd& q) -> Eigen::VectorXd {
    return Eigen::Vector2d{-q[1], q[0]};
  };
  const auto estimate = [&](double h) {
    const Eigen::VectorXd start = Eigen::Vector2d{0.6, -0.8};
    return prince_dormand87_step(rotation, {0.0, start, rotation(0.0, start)}, h).error.norm();
  };
  check_power(estimate, 0.4, 8.0);
}

BOOST_AUTO_TEST_CASE(estimates_have_the_order_of_the_lower_of_the_pair) {
  const auto estimate = [](SteppingMethod method) {
    return [=](double h) { return one_step(method, h).memory.error; };
  };
  check_power(estimate(SteppingMethod::bogacki_shampine32), 0.02, 3.0);
  check_power(estimate(SteppingMethod::dormand_prince54), 0.02, 5.0);
}

BOOST_AUTO_TEST_CASE(interpolants_have_their_orders) {
  const auto error_of_one_step = [](SteppingMethod method) {
    return [=](double h) { return error_within({one_step(method, h).step}); };
  };
  check_power(error_of_one_step(SteppingMethod::bogacki_shampine32), 0.02, 4.0);
  check_power(error_of_one_step(SteppingMethod::dormand_prince54), 0.05, 5.0);
  // Over many steps, the errors at the ends of the steps add to the errors of the interpolants.
  const auto error_of_all = [](SteppingMethod method) {
    return [=](double h) {
      return error_within(steps_of(method, static_cast<int>(std::lround(t_final / h)), false));
    };
  };
  check_power(error_of_all(SteppingMethod::bogacki_shampine32), 0.01, 3.0);
  check_power(error_of_all(SteppingMethod::dormand_prince54), 0.04, 5.0);
}

// A polynomial of degree 4, as a state of a single number and of two.
BOOST_AUTO_TEST_CASE(bubbles_are_added_to_states_of_any_size) {
  for (const Eigen::Index n : {1, 2}) {
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(n), none = 0.0 * one;
    // q(t) = t^4 = cubic + theta^2 (1 - theta)^2 for h = 1.
    const Step step{{0.0, none, none}, {1.0, one, 4.0 * one}, one};
    for (const double t : {0.2, 0.5, 0.9}) {
      BOOST_TEST((interpolate(step, t) - std::pow(t, 4) * one).norm() < 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(interpolants_meet_states_and_rates_at_both_ends) {
  for (const SteppingMethod method :
       {SteppingMethod::bogacki_shampine32, SteppingMethod::dormand_prince54}) {
    const Step step = one_step(method, 0.25).step;
    constexpr double d = 1e-6;
    for (const TimePoint& end : {step.start, step.end}) {
      BOOST_TEST((interpolate(step, end.t) - end.state).norm() < 1e-15);
      const auto slope = (interpolate(step, end.t + d) - interpolate(step, end.t - d)) / (2.0 * d);
      BOOST_TEST((slope - end.rate).norm() < 1e-9);
    }
  }
}

}  // namespace stokesbook::test
