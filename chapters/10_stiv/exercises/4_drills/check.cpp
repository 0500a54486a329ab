// Check of exercise 10.4: places, distances and derivatives by other ways.
#include "chapters/check.hpp"

#include <numbers>

using namespace stokesbook;
using Eigen::VectorXd;
using exercise::expect;
using exercise::text;

double sag(double radius, double edge);
Complex seen_from_b(Complex centre_a, double angle_a, Complex centre_b, double angle_b, Complex x);
double contact_time(Complex offset, Complex drift, double radius, double separation);
double left_by_step(double angle);
VectorXd row(Complex normal, Complex arm_a, Complex arm_b);

namespace {

// An edge between two points of the circle at the angles -half and half.
void check_sag(double radius, double half) {
  const double edge = 2.0 * radius * std::sin(half);
  const double exact = std::abs(radius - radius * std::polar(1.0, half).real());
  expect({.what = "radius " + text(radius) + ", edge " + text(edge),
          .got = sag(radius, edge),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{radius - std::sqrt(radius * radius - edge * edge),
                        "the triangle has half of the edge as its side"},
                       {edge * edge / (8.0 * radius),
                        "this is the leading term for short edges; the task asks for all of it"},
                       {radius - exact, "this is the distance of the edge from the centre"}}});
}

void check_place(Complex a, double angle_a, Complex b, double angle_b, Complex x) {
  const Complex turn = std::polar(1.0, angle_b);
  const Complex exact = (a + std::polar(1.0, angle_a) * x - b) / turn;
  expect({.what = "A at " + text(a) + " with the angle " + text(angle_a) + ", B at " + text(b) +
                  " with the angle " + text(angle_b) + ", X = " + text(x),
          .got = seen_from_b(a, angle_a, b, angle_b, x),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {exact * turn * turn, "the frame of B is turned back by its angle, not forward"},
              {exact + (a - b) * (1.0 - 1.0 / turn),
               "the difference of the centres is turned as well"},
              {exact * turn, "this is the place in the plane, measured from the centre of B"},
              {(a - b + x) / turn, "X is turned with A"}}});
}

// The circles meet at a given time, where the line of their centres has a given angle.
void check_time(double time, double angle, Complex drift) {
  constexpr double radius = 0.8, separation = 0.1, reach = 2.0 * radius + separation;
  const Complex offset = std::polar(reach, angle) - time * drift;
  const double speed = std::abs(drift), along = dot(offset, drift) / speed;
  const double across = cross(offset, drift) / speed;
  const auto first = [&](double distance) {
    return (-along - std::sqrt(distance * distance - across * across)) / speed;
  };
  expect({.what = "c = " + text(offset) + ", d = " + text(drift) + ", a = 0.8, separation 0.1",
          .got = contact_time(offset, drift, radius, separation),
          .expected = time,
          .tolerance = 1e-11,
          .mistakes = {
              {-2.0 * along / speed - time, "this is when they part again: take the first time"},
              {first(2.0 * radius),
               "this is the time at which they touch: the separation belongs to the distance"},
              {first(2.0 * (radius + separation)),
               "there is one separation, not one for each "
               "circle"},
              {first(radius + separation), "the centres are two radii and the separation apart"}}});
}

// A step of the search: the time is the distance over the speed.
void check_step(double angle) {
  constexpr double distance = 0.7, speed = 2.0;
  const Complex path = speed * std::polar(1.0, angle) * -imaginary;  // the wall is the x axis
  const double after = (imaginary * distance + path * (distance / speed)).imag();
  expect({.what = "alpha = " + text(angle),
          .got = left_by_step(angle),
          .expected = after / distance,
          .tolerance = 1e-13,
          .mistakes = {
              {1.0 - after / distance,
               "this is the part by which the step comes nearer: the task "
               "asks for the part that is left"},
              {1.0 - std::sin(angle), "the angle is measured from the normal, not from the wall"},
              {std::sin(angle), "this is how far the point moves along the wall"}}});
}

// The gap is n . (x_A - x_B); a turn moves a point across its arm.
void check_row(double angle, Complex arm_a, Complex arm_b) {
  const Complex n = std::polar(1.0, angle);
  const double a = dot(n, perp(arm_a)), b = dot(n, perp(arm_b));
  const auto entries = [&](double turn_a, double turn_b) {
    return VectorXd{
        {dot(n, 1.0), dot(n, imaginary), turn_a, -dot(n, 1.0), -dot(n, imaginary), turn_b}};
  };
  expect({.what = "n = " + text(n) + ", arms " + text(arm_a) + " and " + text(arm_b),
          .got = row(n, arm_a, arm_b),
          .expected = entries(a, -b),
          .tolerance = 1e-13,
          .mistakes = {
              {entries(a, b), "the force on B is -n, so that the torque on B has a minus sign too"},
              {entries(-a, b), "the torque of n is arm x normal, not normal x arm"},
              {VectorXd(-entries(a, -b)), "n points from B to A: the gap opens as A moves along n"},
              {entries(0.0, 0.0), "turns of the bodies change the gap as well"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the sag of a polygon",
                         .formula = "r - sqrt(r^2 - h^2/4)",
                         .hint = "Pythagoras' theorem with half of the edge",
                         .check =
                             [] {
                               check_sag(1.0, 0.2);
                               check_sag(2.0, 0.5);
                               check_sag(0.3, 0.05);
                             }},
                        {.title = "a place seen from another body",
                         .formula = "R(-theta_B) (c_A - c_B) + R(theta_A - theta_B) X",
                         .hint = "c_B + R(theta_B) z = c_A + R(theta_A) X",
                         .check =
                             [] {
                               check_place({3.0, 0.0}, 0.4, {0.0, 1.0}, 0.7, {1.0, 0.5});
                               check_place({-1.0, 2.0}, -0.3, {0.5, 0.5}, 1.1, {0.0, -0.8});
                             }},
                        {.title = "the first contact of two circles",
                         .formula = "|c + tau d| = 2 a + separation, the smaller tau",
                         .hint = "a quadratic equation for tau",
                         .check =
                             [] {
                               check_time(0.5, 3.0, {2.0, 0.3});
                               check_time(0.25, 1.2, {-0.5, -4.0});
                               check_time(0.75, -2.0, {1.0, 3.0});
                             }},
                        {.title = "a step towards a wall",
                         .formula = "1 - cos(alpha)",
                         .hint = "the step has the length d, and comes nearer by d cos(alpha)",
                         .check =
                             [] {
                               for (const double angle : {0.0, 0.5, 1.2}) check_step(angle);
                             }},
                        {.title = "a row",
                         .formula = "(n, r_A x n, -n, -(r_B x n))",
                         .hint = "torque is arm x force; the forces are n on A and -n on B",
                         .check = [] {
                           check_row(0.3, {-1.0, 0.2}, {0.5, 0.4});
                           check_row(2.0, {0.3, 0.9}, {-0.7, -0.6});
                         }}});
}
