// Check of exercise 12.2: sums over a ring; rings of disks solved by the library.
#include "chapters/check.hpp"

#include <fstream>
#include <numbers>

#include "study/plot.hpp"
#include "suspension/solver/solver.hpp"

using namespace stokesbook;
using exercise::expect;
using std::numbers::pi;

Complex rotlet(Complex x, double torque, double mu);
double ring_speed(int n, double radius, double torque, double mu);
double turn(int n, double a, double radius, double torque, double mu);
int order();

namespace {

// The torque that goes through a circle around the point: of u = c/r the stress is -2 mu c / r^2.
void check_rotlet(Complex x) {
  constexpr double torque = 2.5, mu = 1.3;
  const Complex along = imaginary * x / std::abs(x);
  const Complex exact = torque / (4.0 * pi * mu * std::abs(x)) * along;
  expect({.what = "x = " + exercise::text(x) + ", L = 2.5, mu = 1.3",
          .got = rotlet(x, torque, mu),
          .expected = exact,
          .tolerance = 1e-13,
          .mistakes = {{2.0 * exact,
                        "a point vortex has its circulation there, 2 pi; the torque "
                        "of a rotlet has 4 pi mu"},
                       {-exact, "a positive torque turns counter-clockwise"},
                       {mu * exact, "more viscous fluid moves less"}}});
}

// By the sum that the formula is for.
void check_ring_speed(int n) {
  constexpr double radius = 2.0, torque = 2.5, mu = 1.3;
  double along = 0.0, straight = 0.0;
  for (int k = 1; k < n; ++k) {
    const Complex apart = radius * (1.0 - std::polar(1.0, 2.0 * pi * k / n));
    const Complex velocity = imaginary * torque / (4.0 * pi * mu) * apart / std::norm(apart);
    along += velocity.imag();
    straight += std::abs(velocity);
  }
  const double one = torque / (8.0 * pi * mu * radius);
  expect({.what = std::to_string(n) + " rotlets",
          .got = ring_speed(n, radius, torque, mu),
          .expected = along,
          .tolerance = 1e-12,
          .mistakes = {{along + one, "nobody carries himself: there are n - 1 others"},
                       {straight, "only the part along the ring carries round: the others cancel"},
                       {2.0 * along, "a neighbour at the angle phi is 2 R sin(phi/2) away"}}});
}

void check_turn(int n) {
  constexpr double a = 0.5, radius = 4.0, torque = 2.5, mu = 1.3;
  const double alone = torque / (4.0 * pi * mu * a * a);
  const double round = (n - 1) * torque / (8.0 * pi * mu * radius * radius);
  expect({.what = std::to_string(n) + " disks of radius 1/2 at R = 4",
          .got = turn(n, a, radius, torque, mu),
          .expected = alone,
          .tolerance = 1e-12,
          .mistakes = {{alone + round,
                        "bodies that are carried round need not turn: rotlets have "
                        "no vorticity elsewhere"},
                       {0.0, "a disk under a torque turns"}}});
}

/// Speed of one of n disks of radius 1/2 on a ring, under torques 1.
double solved_speed(int n, double radius) {
  Scene scene;
  for (int k = 0; k < n; ++k) {
    scene.bodies.push_back(
        {.shape = Circle{0.5}, .position = std::polar(radius, 2.0 * pi * k / n), .torque = 1.0});
  }
  scene.solver.tolerance = 1e-9;
  const SuspensionSolver solver(scene);
  return solver.solve(solver.start()).motions[0].velocity.imag();
}

/// The power with which the difference from point rotlets falls, between two large rings.
double order_between(int n, double radius) {
  const auto difference = [n](double r) {
    return std::abs(solved_speed(n, r) / ((n - 1) / (8.0 * pi * r)) - 1.0);
  };
  return std::log2(difference(radius) / difference(2.0 * radius));
}

void check_order() {
  expect({.what = "four disks",
          .got = static_cast<double>(order()),
          .expected = std::round(order_between(4, 16.0)),
          .tolerance = 0.0,
          .mistakes = {{1.0, "strains of rotlets call stresslets, which are weaker: a^2 R^-2"},
                       {4.0, "stresslets fall like 1/r, as rotlets do"}}});
}

// Two disks have no third one whose strain would turn them: their difference is of a higher order.
void check_experiment() {
  std::ofstream table("rotors.csv");
  table << "disks,radius,difference\n";
  study::Plot plot{.title = "Rings of rotors",
                   .x_label = "radius of the ring, in radii of a disk",
                   .y_label = "relative difference of the speed from that of rotlets"};
  for (const int n : {2, 3, 4, 6}) {
    study::PlotLine line{std::to_string(n) + " disks"};
    for (const double radius : {2.0, 4.0, 8.0, 16.0}) {
      const double law = ring_speed(n, radius, 1.0, 1.0);
      const double difference = std::abs(solved_speed(n, radius) / law - 1.0);
      table << n << ',' << radius << ',' << difference << '\n';
      line.points.push_back({2.0 * radius, difference});
    }
    plot.lines.push_back(line);
    if (n == 2) continue;
    expect({.what = std::to_string(n) + " disks, between the largest rings",
            .got = std::log2(line.points[2].y / line.points[3].y),
            .expected = static_cast<double>(order()),
            .tolerance = 0.1});
  }
  std::ofstream("rotors.svg") << study::draw_plot(plot);
}

}  // namespace

int main() {
  return exercise::run({{.title = "a rotlet",
                         .formula = "L / (4 pi mu r), around the point",
                         .hint = "the direction is i x / |x|",
                         .check =
                             [] {
                               for (const Complex x : {Complex{1, 0}, {0, 2}, {-0.6, 0.3}})
                                 check_rotlet(x);
                             }},
                        {.title = "the speed of the ring",
                         .formula = "sum over the others, their part along the ring",
                         .hint = "sin(phi/2) / (2 R sin(phi/2)) does not depend on phi",
                         .check =
                             [] {
                               for (const int n : {2, 3, 4, 7}) check_ring_speed(n);
                             }},
                        {.title = "the turn of a disk",
                         .formula = "L / (4 pi mu a^2), and half the vorticity of the others",
                         .hint = "the flow of a rotlet is a gradient",
                         .check =
                             [] {
                               for (const int n : {3, 5}) check_turn(n);
                             }},
                        {.title = "the order",
                         .formula = "strain R^-2, stresslet a^2 R^-2, its flow a^2 R^-3",
                         .hint = "compare with R^-1",
                         .check = check_order},
                        {.title = "the experiment",
                         .builds_on = {2, 4},
                         .formula = "the slopes are the order of task 4",
                         .hint = "look at rotors.svg",
                         .check = check_experiment}});
}
