// Check of exercise 09.1: polynomials, which the formulas have to integrate exactly, and the steps
// of the library.
#include "chapters/check.hpp"

#include "time_stepping/adams.hpp"
#include "time_stepping/runge_kutta.hpp"

using namespace stokesbook;
using Eigen::Vector2d;
using Eigen::VectorXd;
using exercise::expect;

Vector2d weights(double h_0, double h_1);
VectorXd heun(const Rate& f, double t, const VectorXd& q, const VectorXd& f_0, double h);
std::vector<VectorXd> march(const Rate& f, const std::vector<double>& times, const VectorXd& start);

namespace {

// Jeffery's equation of an ellipse 3:1, beside one that depends on time.
VectorXd rate(double t, const VectorXd& q) {
  return Vector2d{-0.5 + 0.4 * std::cos(2.0 * q[0]), std::cos(t) * (1.0 + 0.3 * q[1] * q[1])};
}

void check_weights(double h_0, double h_1) {
  // Rates 1 and s + h_0 are integrated exactly: w_1 + w_0 = h_1, w_1 h_0 = h_1^2/2 + h_0 h_1.
  const double w_1 = (0.5 * h_1 * h_1 + h_0 * h_1) / h_0;
  const Vector2d exact{w_1, h_1 - w_1};
  const double bend = 0.5 * h_0;
  expect({.what = "h_0 = " + exercise::text(h_0) + ", h_1 = " + exercise::text(h_1),
          .got = weights(h_0, h_1),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {
              {Vector2d{1.5 * h_1, -0.5 * h_1}, "these are the weights of equal steps"},
              {Vector2d{h_1 + bend, -bend}, "the ratio is h_1/h_0, not h_0/h_1"},
              {Vector2d{exact[1], exact[0]}, "the other order: the weight of f_1 comes first"},
              {Vector2d{exact / h_1}, "the length of the step is missing"},
              {Vector2d{0.5 * h_1, 0.5 * h_1},
               "this integrates between f_0 and f_1: the step goes on beyond f_1"}}});
}

void check_heun(double h) {
  const double t = 0.7;
  const VectorXd q = Vector2d{0.4, -0.2}, f_0 = rate(t, q);
  const auto combined = [&](double time, double part) -> VectorXd {
    return q + h * ((1.0 - part) * f_0 + part * rate(time, q + h * f_0));
  };
  const VectorXd middle = q + h * rate(t + 0.5 * h, q + 0.5 * h * f_0);
  const TimePoint start{t, q, f_0};
  const VectorXd exact =
      q + h * (runge_kutta_stages(stokesbook::heun(), &rate, start, h) * stokesbook::heun().b);
  expect({.what = "h = " + exercise::text(h),
          .got = ::heun(&rate, t, q, f_0, h),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {{combined(t, 0.5), "the second rate belongs to the time t + h"},
                       {combined(t + h, 1.0), "the mean of both rates, not the second one"},
                       {combined(t, 0.0), "this is the Euler step"},
                       {middle, "this is the midpoint rule: of the same order, but not Heun's"}}});
}

// The library's steps; begun by Euler if so.
std::vector<VectorXd> steps_of_the_book(const std::vector<double>& times, const VectorXd& start,
                                        bool by_euler) {
  const Tableau& first = by_euler ? euler() : stokesbook::heun();
  std::vector<VectorXd> states{start};
  PreviousStep previous;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const TimePoint now{times[k], states.back(), rate(times[k], states.back())};
    const double h = times[k + 1] - times[k];
    states.push_back(
        k == 0 ? VectorXd(now.state + h * (runge_kutta_stages(first, &rate, now, h) * first.b))
               : adams_bashforth2_step(now, h, previous));
    previous = {h, now.rate};
  }
  return states;
}

void check_march() {
  const std::vector<double> times{0.0, 0.1, 0.25, 0.33, 0.6, 0.7, 1.0};
  const VectorXd start = Vector2d{0.2, 0.1};
  int evaluations = 0;
  const Rate counted = [&](double t, const VectorXd& q) {
    ++evaluations;
    return rate(t, q);
  };
  const std::vector<VectorXd> got = march(counted, times, start),
                              expected = steps_of_the_book(times, start, false),
                              by_euler = steps_of_the_book(times, start, true);
  expect({.what = "the number of states",
          .got = static_cast<double>(got.size()),
          .expected = static_cast<double>(times.size()),
          .tolerance = 0.0,
          .mistakes = {
              {static_cast<double>(times.size()) - 1.0, "the start is the first of the states"}}});
  for (std::size_t k = 0; k < got.size(); ++k) {
    expect({.what = "the state at t = " + exercise::text(times[k]),
            .got = got[k],
            .expected = expected[k],
            .tolerance = 1e-13,
            .mistakes = {{by_euler[k], "the first step is an Euler step: begin with Heun's"}}});
  }
  const auto steps = static_cast<double>(times.size() - 1);
  expect({.what = "evaluations for " + exercise::text(steps) + " steps",
          .got = static_cast<double>(evaluations),
          .expected = steps + 1.0,
          .tolerance = 0.0,
          .mistakes = {{2.0 * steps, "the rate of the step before is computed again: keep it"},
                       {steps + 2.0, "the rate at the end, or at the start, is one too many"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the weights",
                         .formula = "w_1 = h_1 + h_1^2/(2 h_0), w_0 = -h_1^2/(2 h_0)",
                         .hint = "integrate f_1 + (f_1 - f_0) s/h_0 from 0 to h_1",
                         .check =
                             [] {
                               check_weights(0.2, 0.2);
                               check_weights(0.1, 0.25);
                               check_weights(0.3, 0.05);
                             }},
                        {.title = "Heun's scheme",
                         .formula = "q + h/2 (f_0 + f(t + h, q + h f_0))",
                         .hint = "both rates are those at the ends of the Euler step",
                         .check =
                             [] {
                               check_heun(0.3);
                               check_heun(0.05);
                             }},
                        {.title = "the march",
                         .builds_on = {1, 2},
                         .formula = "q_2 = q_1 + w_1 f_1 + w_0 f_0",
                         .hint = "keep f_1: it is f_0 of the next step",
                         .check = check_march}});
}
