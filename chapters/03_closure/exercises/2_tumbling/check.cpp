// Check of exercise 03.2: turns and periods against Jeffery's closed forms; the experiment.
#include "chapters/check.hpp"

#include <fstream>
#include <numbers>

#include "study/plot.hpp"
#include "support/problems.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

StokesProblem tumbling(const Ellipse& ellipse, double angle, double rate, int nodes);
double shape_factor(const Ellipse& ellipse, int nodes);
double half_turn(const Ellipse& ellipse, double rate, int angles, int nodes);
int angles_needed(double aspect, double tolerance);

RigidMotion solve(const StokesProblem& problem) {
  return test::solve_dense(problem, ClosureForm::reduced).motions.at(0);
}

namespace {

// Enough for an ellipse 3:1 to be exact up to rounding.
constexpr int nodes = 64;

double exact_omega(const Ellipse& e, double angle, double rate) {
  const double across = e.a * std::sin(angle), along = e.b * std::cos(angle);
  return -rate * (across * across + along * along) / (e.a * e.a + e.b * e.b);
}

double exact_half_turn(double aspect, double rate) {
  return pi * (aspect + 1.0 / aspect) / rate;
}

void check_problem(double angle, double rate) {
  const Ellipse e{3.0, 1.0};
  const double exact = exact_omega(e, angle, rate);
  expect({.what = "omega of the ellipse 3:1, angle = " + exercise::text(angle) +
                  ", g = " + exercise::text(rate),
          .got = solve(tumbling(e, angle, rate, nodes)).omega,
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{-exact, "the flow runs the other way: (g y, 0) turns bodies clockwise"},
                       {exact / rate, "the rate g is missing"},
                       {exact_omega(e, angle - 0.5 * pi, rate),
                        "the angle is that of the major axis, here it is that of the minor one"},
                       {0.0, "there is no flow: set the background at the nodes"}}});
}

void check_flow(double angle, double rate) {
  const Ellipse e{3.0, 1.0};
  const ComplexVector own = sample(e, nodes, Side::fluid_outside).x;
  const ComplexVector x = std::polar(1.0, angle) * own;
  const auto shear = [rate](const ComplexVector& at) -> ComplexVector {
    return rate * at.imag().cast<Complex>();
  };
  expect(
      {.what = "the flow at the nodes, angle = " + exercise::text(angle),
       .got = tumbling(e, angle, rate, nodes).background,
       .expected = shear(x),
       .tolerance = 1e-12,
       .mistakes = {{shear(own),
                     "the flow is taken in the frame of the ellipse: use the nodes "
                     "after they are placed"},
                    {-shear(x), "the flow runs the other way"},
                    {shear(std::polar(1.0, -angle) * own), "this turns the ellipse clockwise"}}});
}

void check_factor(double aspect) {
  const double exact = (aspect * aspect - 1.0) / (aspect * aspect + 1.0);
  expect({.what = "an ellipse " + exercise::text(aspect) + ":1",
          .got = shape_factor({aspect, 1.0}, nodes),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {{-exact, "the sign is the other one: lying along the flow it turns slowly"},
                       {0.5 * exact, "half of it: the two turns differ by B g, not by B g/2"},
                       {(aspect - 1.0) / (aspect + 1.0),
                        "this is (a - b)/(a + b): the axes enter by their squares"}}});
}

void check_half_turn(double aspect, double rate) {
  const double exact = exact_half_turn(aspect, rate);
  expect(
      {.what = "an ellipse " + exercise::text(aspect) + ":1, g = " + exercise::text(rate),
       .got = half_turn({aspect, 1.0}, rate, 48, nodes),
       .expected = exact,
       .tolerance = 1e-10,
       .mistakes = {{2.0 * pi / rate,
                     "this divides by the mean of omega: the ellipse is longer where it is slow"},
                    {0.5 * exact, "this is a quarter of a turn"},
                    {2.0 * exact, "this is a full turn"},
                    {exact * rate, "the rate g is missing"},
                    {exact * 48.0 / pi, "the weight pi/K is missing"}}});
}

// Share of the time that the exact orbit spends within an angle of the flow: by
// tan(theta) = -tan(phase)/aspect, and the phase grows evenly.
double exact_share(double aspect, double within) {
  return 2.0 / pi * std::atan(aspect * std::tan(within));
}

// The same from turns of the reader's problems at the angles of a fine midpoint rule.
double measured_share(double aspect, double within, double period) {
  constexpr int cells = 20;
  double time = 0.0;
  for (int k = 0; k < cells; ++k) {
    const double angle = within * (2.0 * (k + 0.5) / cells - 1.0);
    const double omega = solve(tumbling({aspect, 1.0}, angle, 1.0, nodes)).omega;
    time += 2.0 * within / cells / std::abs(omega);
  }
  return time / period;
}

// Half turns and shares for aspect ratios 1 to 8; writes orbits.csv and orbits.svg.
void check_experiment() {
  const double within = pi / 18.0;
  std::ofstream table("orbits.csv");
  table << "aspect,half_turn,half_turn_jeffery,share_along_the_flow\n";
  study::PlotLine times{"time of half a turn, times the shear rate"},
      shares{"share of it within 10 degrees of the flow"};
  for (double aspect = 1.0; aspect <= 8.0; aspect += 1.0) {
    const double period = half_turn({aspect, 1.0}, 1.0, 48, nodes);
    const double exact = exact_half_turn(aspect, 1.0);
    const double share = measured_share(aspect, within, period);
    table << aspect << ',' << period << ',' << exact << ',' << share << '\n';
    times.points.push_back({aspect, period});
    shares.points.push_back({aspect, share});
    expect({.what = "half a turn at the aspect ratio " + exercise::text(aspect),
            .got = period,
            .expected = exact,
            .tolerance = 1e-4});  // 64 nodes are few for 8:1
    expect({.what = "share along the flow at the aspect ratio " + exercise::text(aspect),
            .got = share,
            .expected = exact_share(aspect, within),
            .tolerance = 1e-2});
  }
  std::ofstream("orbits.svg") << study::draw_plot({.title = "Half turns of free ellipses",
                                                   .x_label = "aspect ratio",
                                                   .y_label = "time and share",
                                                   .lines = {times, shares}});
}

void check_angles(double aspect, double tolerance) {
  // The rule with K angles, from the exact turns.
  const auto rule = [&](int count) {
    double time = 0.0;
    for (int k = 0; k < count; ++k) {
      time -= pi / count / exact_omega({aspect, 1.0}, pi * k / count, 1.0);
    }
    return time;
  };
  const double exact = exact_half_turn(aspect, 1.0);
  int needed = 1;
  while (std::abs(rule(needed) / exact - 1.0) > tolerance) ++needed;
  const double q = (aspect - 1.0) / (aspect + 1.0);
  const double got = angles_needed(aspect, tolerance);
  expect(
      {.what =
           "aspect ratio " + exercise::text(aspect) + ", tolerance " + exercise::text(tolerance),
       .got = got,
       .expected = static_cast<double>(needed),
       .tolerance = 1e-12,
       .mistakes = {{std::ceil(0.5 * std::log(tolerance / (2.0 + tolerance)) / std::log(q)),
                     "this takes q^(2K) for the error: the period in theta is pi, in s it is 2 pi"},
                    {2.0 * needed, "twice as many: the rule covers half a turn"},
                    {std::ceil(std::log(tolerance) / std::log(q)),
                     "the factor 2 of the two poles is missing"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the problem",
        .formula = "u = (g y, 0) at the nodes; omega = -g (a^2 sin^2 + b^2 cos^2)/(a^2 + b^2)",
        .hint = "place the ellipse first, then take the flow at its nodes",
        .check =
            [] {
              for (double angle : {0.0, 0.4, 2.0}) {
                check_flow(angle, 1.5);
                check_problem(angle, 1.5);
              }
            }},
       {.title = "the shape factor",
        .builds_on = {1},
        .formula = "omega = -g/2 + B g/2 cos(2 theta)",
        .hint = "the cosine is 1 along the flow and -1 across",
        .check =
            [] {
              for (double aspect : {1.5, 3.0}) check_factor(aspect);
            }},
       {.title = "half a turn",
        .builds_on = {1},
        .formula = "the integral of d theta/|omega| over pi",
        .hint = "pi/K sum_k 1/|omega(pi k/K)|",
        .check =
            [] {
              check_half_turn(2.0, 1.0);
              check_half_turn(3.0, 2.5);
            }},
       {.title = "the experiment",
        .builds_on = {1, 3},
        .formula = "pi (r + 1/r)/g",
        .hint = "look at orbits.svg",
        .check = check_experiment},
       {.title = "the angles needed",
        .formula = "2 q^K/(1 - q^K) <= tolerance, q = (1 - sqrt(1 - B^2))/B",
        .hint = "q is (a - b)/(a + b)",
        .check = [] {
          for (double aspect : {2.0, 6.0}) {
            for (double tolerance : {1e-2, 1e-6}) check_angles(aspect, tolerance);
          }
        }}});
}
