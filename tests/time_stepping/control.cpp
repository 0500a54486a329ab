// Checks the step control (09.9), (09.10): embedded methods reach the required error, and their
// errors are not far smaller, in any units; steps end exactly at events; steps are halved at
// inadmissible states; memory and time point suffice to continue.

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "problems.hpp"

namespace stokesbook::test {

using Eigen::VectorXd;

namespace {

constexpr SteppingMethod embedded[] = {SteppingMethod::bogacki_shampine32,
                                       SteppingMethod::dormand_prince54,
                                       SteppingMethod::prince_dormand87};

SteppingSettings to_tolerance(SteppingMethod method, double tolerance) {
  SteppingSettings settings{.method = method};
  settings.bound = {tolerance, VectorXd::Ones(2)};
  return settings;
}

double largest_error(const std::vector<Step>& steps) {
  double error = 0.0;
  for (const Step& step : steps) {
    error = std::max(error, problem_error(step.end.t, step.end.state));
  }
  return error;
}

// The solution decreases fast at first, then slowly, and never reaches 0. Long steps give values
// below 0.
VectorXd decay(double t, const VectorXd& q) {
  if (q[0] <= 0.0) throw InadmissibleState("negative");
  return (t < 0.3 - 1e-9 ? -8.0 : -0.5) * q;
}

TimePoint decay_start() {
  const VectorXd one = VectorXd::Ones(1);
  return {0.0, one, decay(0.0, one)};
}

bool same(const Step& a, const Step& b) {
  return a.start.t == b.start.t && a.end.t == b.end.t && a.end.state == b.end.state &&
         a.end.rate == b.end.rate;
}

}  // namespace

BOOST_AUTO_TEST_CASE(achieved_errors_are_as_asked_and_not_far_below) {
  for (const SteppingMethod method : embedded) {
    // The largest pair estimates the error of its lower order, which overestimates the error.
    const double least = method == SteppingMethod::prince_dormand87 ? 0.02 : 0.1;
    for (double tolerance = 1e-3; tolerance > 0.9e-10; tolerance /= std::sqrt(10.0)) {
      const Stepper stepper(to_tolerance(method, tolerance), {problem_rate, problem_rate});
      const double error = largest_error(steps_through(stepper, problem_at(0.0), {8.0}));
      BOOST_TEST_CONTEXT("method " << static_cast<int>(method) << ", tolerance " << tolerance) {
        BOOST_TEST(error < 10.0 * tolerance);
        BOOST_TEST(error > least * tolerance);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(steps_do_not_depend_on_units) {
  // The other unit of length is a power of two, so the steps must agree in every bit.
  static constexpr double unit = 0.25;
  const Rate f = [](double t, const VectorXd& q) -> VectorXd {
    return unit * problem_rate(t, q / unit);
  };
  const TimePoint start = problem_at(0.0);
  const TimePoint scaled{0.0, unit * start.state, unit * start.rate};
  for (const SteppingMethod method : embedded) {
    SteppingSettings settings = to_tolerance(method, 1e-5);
    const auto steps = steps_through({settings, {problem_rate, problem_rate}}, start, {8.0});
    settings.bound.scale *= unit;
    const auto others = steps_through({settings, {f, f}}, scaled, {8.0});
    BOOST_REQUIRE_EQUAL(steps.size(), others.size());
    for (std::size_t k = 0; k < steps.size(); ++k) BOOST_TEST(steps[k].end.t == others[k].end.t);
  }
}

BOOST_AUTO_TEST_CASE(few_steps_are_rejected) {
  for (const SteppingMethod method : embedded) {
    const Stepper stepper(to_tolerance(method, 1e-7), {problem_rate, problem_rate});
    TimePoint now = problem_at(0.0);
    StepMemory memory;
    int steps = 0, rejected = 0;
    while (now.t < 8.0) {
      const StepResult taken = stepper.advance(now, memory, 8.0);
      BOOST_TEST(taken.memory.error <= 1.0);
      now = taken.step.end;
      memory = taken.memory;
      ++steps;
      rejected += taken.rejected;
    }
    BOOST_TEST(10 * rejected <= steps);
  }
}

BOOST_AUTO_TEST_CASE(steps_to_an_event_are_even_and_the_last_hits_it) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 100; ++trial) {
    const double t = 2.0 * uniform(random) - 1.0, event = t + uniform(random),
                 longest = 0.3 * uniform(random);
    BOOST_TEST(choose_step_end(t, event, event - t) == event);
    BOOST_TEST(choose_step_end(t, event, 2.0) == event);
    int steps = 1;
    double now = choose_step_end(t, event, longest);
    const double first = now - t;
    BOOST_TEST(first <= longest * (1.0 + 1e-8));
    for (; now < event; ++steps) {
      const double next = choose_step_end(now, event, longest);
      BOOST_TEST(std::abs(next - now - first) <= 1e-12);
      now = next;
    }
    BOOST_TEST(now == event);
    BOOST_TEST(steps - (event - t) / longest < 1.0 + 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(the_next_step_follows_from_the_order_of_the_estimate) {
  for (const auto& [method, power] : {std::pair{SteppingMethod::bogacki_shampine32, 3},
                                      std::pair{SteppingMethod::dormand_prince54, 5},
                                      std::pair{SteppingMethod::prince_dormand87, 8}}) {
    SteppingSettings settings = to_tolerance(method, 1e-5);
    settings.dt = 0.02;
    const Stepper stepper(settings, {problem_rate, problem_rate});
    const StepResult taken = stepper.advance(problem_at(0.0), {}, 10.0);
    BOOST_REQUIRE_EQUAL(taken.rejected, 0);
    const double factor = step_factor(taken.memory.error, 1.0, power);
    BOOST_TEST(*taken.memory.dt == factor * taken.step.dt(), boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(events_and_limits_are_kept) {
  const std::vector<double> events{0.3, 0.30001, 1.0, 1.7, 5.0};
  for (const SteppingMethod method : embedded) {
    SteppingSettings settings = to_tolerance(method, 1e-4);
    settings.dt = 0.01;
    settings.dt_max = 0.11;
    const auto steps =
        steps_through({settings, {problem_rate, problem_rate}}, problem_at(0.0), events);
    BOOST_TEST(steps.front().dt() <= 0.01 * (1.0 + 1e-9));
    for (const double event : events) {
      BOOST_TEST(std::ranges::count(steps, event, [](const Step& s) { return s.end.t; }) == 1);
    }
    double longest = 0.0;
    for (const Step& step : steps) longest = std::max(longest, step.dt());
    BOOST_TEST(longest <= 0.11 * (1.0 + 1e-9));
    BOOST_TEST(longest > 0.1);
    // After a step that an event cuts short, the following steps are long again.
    const auto cut = std::ranges::find(steps, 0.30001, [](const Step& s) { return s.end.t; });
    BOOST_TEST((cut + 1)->dt() > 0.05);
  }
}

BOOST_AUTO_TEST_CASE(fixed_steps_that_meet_an_inadmissible_state_are_halved_and_come_back) {
  const auto ends = [](SteppingMethod method) {
    SteppingSettings settings{.method = method, .dt = 0.3, .dt_min = 1e-3};
    std::vector<double> times;
    for (const Step& step : steps_through({settings, {decay, decay}}, decay_start(), {0.9})) {
      times.push_back(std::round(1e6 * step.end.t) / 1e6);
    }
    return times;
  };
  const std::vector<double> quarters{0.075, 0.15, 0.225, 0.3, 0.6, 0.9},
      halves{0.15, 0.3, 0.6, 0.9};
  BOOST_TEST(ends(SteppingMethod::euler) == quarters, boost::test_tools::per_element());
  BOOST_TEST(ends(SteppingMethod::heun) == quarters, boost::test_tools::per_element());
  BOOST_TEST(ends(SteppingMethod::rk4) == halves, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(embedded_methods_halve_steps_that_meet_an_inadmissible_state) {
  const Rate fast = [](double, const VectorXd& q) -> VectorXd {
    if (q[0] <= 0.0) throw InadmissibleState("negative");
    return -8.0 * q;
  };
  for (const SteppingMethod method : embedded) {
    SteppingSettings settings{.method = method, .dt = 2.0, .dt_min = 1e-3};
    settings.bound = {1e-3, VectorXd::Ones(1)};
    const StepResult first = Stepper(settings, {fast, fast}).advance(decay_start(), {}, 2.0);
    BOOST_TEST(first.rejected >= 1);
    BOOST_TEST(first.step.end.t < 1.0);
    BOOST_TEST(first.step.end.state[0] > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_state_that_no_short_step_avoids_stops_the_steps) {
  const Rate above_half = [](double t, const VectorXd& q) {
    if (q[0] < 0.5) throw InadmissibleState("below one half");
    return decay(t, q);
  };
  for (const SteppingMethod method :
       {SteppingMethod::euler, SteppingMethod::rk4, SteppingMethod::dormand_prince54}) {
    SteppingSettings settings{.method = method, .dt = 0.05, .dt_min = 1e-5};
    settings.bound = {1e-6, VectorXd::Ones(1)};
    const Stepper stepper(settings, {above_half, above_half});
    TimePoint now = decay_start();
    StepMemory memory;
    const auto go_on = [&] {
      while (true) {
        StepResult taken = stepper.advance(now, memory, 0.29);
        now = taken.step.end;
        memory = taken.memory;
      }
    };
    BOOST_CHECK_THROW(go_on(), InadmissibleState);
    BOOST_TEST(now.state[0] - 0.5 < 2e-4);
  }
}

BOOST_AUTO_TEST_CASE(a_tolerance_that_no_step_of_the_least_length_meets_is_refused) {
  SteppingSettings settings = to_tolerance(SteppingMethod::dormand_prince54, 1e-12);
  settings.dt = 1.0;
  settings.dt_min = 0.5;
  const Stepper stepper(settings, {problem_rate, problem_rate});
  BOOST_CHECK_THROW(stepper.advance(problem_at(0.0), {}, 8.0), StepError);
}

BOOST_AUTO_TEST_CASE(a_state_at_rest_is_stepped_over) {
  const Rate rest = [](double, const VectorXd& q) -> VectorXd { return 0.0 * q; };
  for (const SteppingMethod method : embedded) {
    SteppingSettings settings = to_tolerance(method, 1e-6);
    const TimePoint start{0.0, Eigen::Vector2d{1.0, 2.0}, VectorXd::Zero(2)};
    const Step step = Stepper(settings, {rest, rest}).advance(start, {}, 8.0).step;
    BOOST_TEST(step.end.t == 8.0);
    BOOST_TEST((step.end.state - start.state).norm() == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(memory_and_moment_are_all_that_the_next_step_depends_on) {
  for (const SteppingMethod method :
       {SteppingMethod::adams_bashforth2, SteppingMethod::dormand_prince54,
        SteppingMethod::prince_dormand87}) {
    SteppingSettings settings = to_tolerance(method, 1e-6);
    settings.dt = 0.1;
    const Stepper stepper(settings, {problem_rate, problem_rate});
    StepResult at = stepper.advance(problem_at(0.0), {}, 8.0);
    for (int k = 0; k < 5; ++k) at = stepper.advance(at.step.end, at.memory, 8.0);
    const StepResult next = stepper.advance(at.step.end, at.memory, 8.0);
    const Stepper another(settings, {problem_rate, problem_rate});
    BOOST_TEST(same(next.step, another.advance(at.step.end, at.memory, 8.0).step));
  }
}

}  // namespace stokesbook::test
