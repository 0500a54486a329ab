// Check of exercise 07.2: means against closed forms; the experiment.
#include "chapters/check.hpp"

#include <fstream>
#include <numbers>

#include "closure/bordered_system.hpp"
#include "double_layer/double_layer.hpp"
#include "stress/stresslet.hpp"
#include "study/plot.hpp"
#include "support/once.hpp"
#include "support/problems.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

double intrinsic(double aspect, double angle);
double orbit_angle(double aspect, double phase);
double orbit_mean(double aspect, int instants);
double random_mean(double aspect);

// Given to the reader: in the ellipse's frame, with one inverse an aspect ratio.
Complex stresslet(double aspect, double angle) {
  const Eigen::Index nodes = 160;  // an ellipse 8:1 to 1e-15
  StokesProblem problem{{test::free_body(Ellipse{aspect, 1.0}, nodes, {})}, 1.0, {}, {}};
  static test::Once<double, Eigen::MatrixXd> inverses;
  const Eigen::MatrixXd& inverse = inverses(
      aspect, [&] { return test::inverse(assemble(problem, ClosureForm::reduced).matrix); });
  const Complex turn = std::polar(1.0, 2.0 * angle);
  const Curve& curve = problem.components[0].curve;
  problem.background = 0.5 * (imaginary / turn * curve.x.conjugate() - imaginary * curve.x);
  const ComplexVector rhs = Closure(problem).right_hand_side();
  const Eigen::VectorXd density = inverse * interleaved(rhs);
  return turn * body_stresslet(curve, deinterleaved(density), 1.0);
}

namespace {

double exact_intrinsic(double r, double angle) {
  const double s = std::sin(2.0 * angle), c = std::cos(2.0 * angle);
  return (r + 1.0) * (r + 1.0) / (2.0 * r) * (s * s + 2.0 * r / (r * r + 1.0) * c * c);
}

void check_intrinsic(double aspect, double angle) {
  const double exact = exact_intrinsic(aspect, angle);
  expect({.what = "aspect ratio " + exercise::text(aspect) + ", angle " + exercise::text(angle),
          .got = intrinsic(aspect, angle),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {{aspect * exact, "the area of the ellipse is missing: pi r"},
                       {stresslet(aspect, angle).real() / (pi * aspect),
                        "the shear stress is S12, as q = i"},
                       {2.0 * exact, "twice as much: S:E = Re(conj(q) S), 2 E:E = |q|^2"},
                       {pi * exact, "the area of the ellipse is pi r"}}});
}

void check_angle(double aspect, double phase) {
  const double angle = orbit_angle(aspect, phase);
  // Angles matter up to half turns.
  const Complex got = std::polar(1.0, 2.0 * angle);
  const Complex top{aspect * std::cos(phase), -std::sin(phase)};
  const Complex exact = top * top / std::norm(top);
  const Complex minor{std::cos(phase), -aspect * std::sin(phase)};
  expect({.what = "e^{2 i theta}, aspect ratio " + exercise::text(aspect) + ", phase " +
                  exercise::text(phase),
          .got = got,
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{std::conj(exact), "the flow (y, 0) turns it clockwise"},
                       {minor * minor / std::norm(minor),
                        "the ellipse is slow along the flow: tan(theta) = -tan(tau)/r"}}});
}

// By the exact orbit with the same instants.
double exact_mean(double aspect, int instants, int extra, bool equal_angles) {
  double sum = 0.0;
  for (int j = 0; j < instants + extra; ++j) {
    const double phase = pi * j / instants;
    const double angle =
        equal_angles ? phase : std::atan2(-std::sin(phase), aspect * std::cos(phase));
    sum += exact_intrinsic(aspect, angle);
  }
  return sum / (instants + extra);
}

void check_orbit_mean(double aspect, int instants) {
  expect({.what = "aspect ratio " + exercise::text(aspect) + ", M = " + std::to_string(instants),
          .got = orbit_mean(aspect, instants),
          .expected = exact_mean(aspect, instants, 0, false),
          .tolerance = 1e-10,
          .mistakes = {{exact_mean(aspect, instants, 0, true),
                        "the ellipse does not turn evenly: equal times, not equal angles"},
                       {exact_mean(aspect, instants, 1, false),
                        "the last instant is the first one again, half a turn later"}}});
}

double exact_random_mean(double r) {
  return 0.5 * (exact_intrinsic(r, 0.0) + exact_intrinsic(r, 0.25 * pi));
}

void check_random_mean(double aspect) {
  const double exact = exact_random_mean(aspect);
  expect({.what = "aspect ratio " + exercise::text(aspect),
          .got = random_mean(aspect),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{2.0, "this is the mean over an orbit"},
                       {2.0 * exact, "the mean of a squared sine is one half"}}});
}

// Both means for aspect ratios 1 to 8; writes viscosity.csv and viscosity.svg.
void check_experiment() {
  std::ofstream table("viscosity.csv");
  table << "aspect,orbit_mean,random_mean\n";
  study::PlotLine orbits{"turned by the flow alone"}, random{"at random"};
  for (double aspect = 1.0; aspect <= 8.0; aspect += 1.0) {
    const double tumbling = orbit_mean(aspect, 160), mixed = random_mean(aspect);
    table << aspect << ',' << tumbling << ',' << mixed << '\n';
    orbits.points.push_back({aspect, tumbling});
    random.points.push_back({aspect, mixed});
    expect({.what = "the mean over an orbit at the aspect ratio " + exercise::text(aspect),
            .got = tumbling,
            .expected = 2.0,
            .tolerance = 1e-9});
    expect({.what = "the mean over angles at the aspect ratio " + exercise::text(aspect),
            .got = mixed,
            .expected = exact_random_mean(aspect),
            .tolerance = 1e-9});
  }
  std::ofstream("viscosity.svg") << study::draw_plot({.title = "Intrinsic viscosity of ellipses",
                                                      .x_label = "aspect ratio",
                                                      .y_label = "intrinsic viscosity",
                                                      .lines = {orbits, random}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "one angle",
                         .formula = "[mu] = Re(conj(q) S) / (mu |q|^2 A), A = pi r",
                         .hint = "q = i",
                         .check =
                             [] {
                               check_intrinsic(1.0, 0.0);
                               check_intrinsic(3.0, 0.4);
                             }},
                        {.title = "the orbit",
                         .formula = "tan(theta) = -tan(tau)/r",
                         .hint = "std::atan2 with both parts",
                         .check =
                             [] {
                               for (double phase : {0.0, 0.5, 2.0}) check_angle(3.0, phase);
                             }},
                        {.title = "the mean over an orbit",
                         .builds_on = {1, 2},
                         .formula = "1/M sum_j [mu](theta(pi j/M))",
                         .hint = "M instants, the last one before the orbit closes",
                         .check =
                             [] {
                               check_orbit_mean(2.0, 5);
                               check_orbit_mean(5.0, 7);
                             }},
                        {.title = "the mean over all angles",
                         .formula = "(r + 1)^2 / (4 r) (1 + 2 r / (r^2 + 1))",
                         .hint = "average the closed form of one angle",
                         .check =
                             [] {
                               for (double aspect : {1.5, 6.0}) check_random_mean(aspect);
                             }},
                        {.title = "the experiment",
                         .builds_on = {3, 4},
                         .formula = "2, and the closed form of task 4",
                         .hint = "look at viscosity.svg",
                         .check = check_experiment}});
}
