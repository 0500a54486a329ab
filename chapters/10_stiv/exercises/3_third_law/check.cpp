// Check of exercise 10.3: moments of forces, and two colliding bodies of the library.
#include "chapters/check.hpp"

#include <memory>
#include <utility>

#include "stiv/absolute_volume.hpp"
#include "stiv/interferences.hpp"

using namespace stokesbook;
using Eigen::Vector3d;
using exercise::expect;

struct Load {
  Complex centre, force;
  double torque;
};

Vector3d imbalance(const Load& a, const Load& b);
std::pair<Complex, Complex> absolute_pushes(Complex u_a, Complex u_b, Complex n);
std::pair<double, double> harmless_observers(Complex u_a, Complex u_b, Complex n);
double torque_left(Complex displacement_a, Complex displacement_b, Complex n);

namespace {

void check_imbalance(const Load& a, const Load& b) {
  const Complex sum = a.force + b.force;
  const auto with = [&](double torque) -> Vector3d { return {sum.real(), sum.imag(), torque}; };
  const double own = a.torque + b.torque,
               arms = cross(a.centre, a.force) + cross(b.centre, b.force);
  expect({.what = "centres " + exercise::text(a.centre) + " and " + exercise::text(b.centre),
          .got = imbalance(a, b),
          .expected = with(own + arms),
          .tolerance = 1e-12,
          .mistakes = {
              {with(own), "torques about two points cannot be added: move both to the origin"},
              {with(arms), "the torques about the bodies' own centres are missing"},
              {with(own - arms), "the torque of a force at c is c x F, not F x c"}}});
}

ComplexVector entries(Complex on_a, Complex on_b) {
  return ComplexVector{{on_a, on_b}};
}

void check_absolute_pushes(Complex u_a, Complex u_b, Complex n) {
  const auto sign = [](double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; };
  const Complex on_a = -sign(dot(u_a, n)) * n, on_b = -sign(dot(u_b, n)) * n;
  const Complex relative = -sign(dot(u_a - u_b, n)) * n;
  const auto [got_a, got_b] = absolute_pushes(u_a, u_b, n);
  expect({.what = "u_a = " + exercise::text(u_a) + ", u_b = " + exercise::text(u_b),
          .got = entries(got_a, got_b),
          .expected = entries(on_a, on_b),
          .tolerance = 1e-12,
          .mistakes = {
              {entries(relative, -relative),
               "this is what it should be: the volume by absolute velocities does not know the "
               "other body"},
              {entries(on_a, -on_b),
               "B's outward normal is -n, twice: in the sign and as the direction"},
              {entries(-on_a, -on_b), "pushes are against the motion"}}});
}

// Two unit circles side by side along x, the left one catching up with the right one.
PairWrench pushes_of_the_book(double u_a, double u_b) {
  static const auto circle =
      std::make_shared<ContactShape>(contact_shape(sample(Circle{1.0}, 128, Side::fluid_outside)));
  static const ContactShapes circles{circle, circle};
  const PathPair paths{0, 1, {{{0.0, 0.0}, 0.0}, u_a, 0.0}, {{{2.2, 0.0}, 0.0}, u_b, 0.0}};
  return absolute_volume(pair_events(circles, paths, {0.1, 1e-5, 0.4, 0.0}), 1e-5).force;
}

void check_harmless_observers(Complex u_a, Complex u_b, Complex n) {
  const double low = dot(u_b, n), high = dot(u_a, n), half = 0.5 * (high - low);
  const auto [got_low, got_high] = harmless_observers(u_a, u_b, n);
  const auto interval = [](double from, double to) { return entries(from, to); };
  expect({.what = "u_a = " + exercise::text(u_a) + ", u_b = " + exercise::text(u_b) +
                  ", n = " + exercise::text(n),
          .got = interval(got_low, got_high),
          .expected = interval(low, high),
          .tolerance = 1e-12,
          .mistakes = {{interval(-std::abs(u_b), std::abs(u_a)),
                        "the velocity along n counts, with its sign"},
                       {interval(-half, half),
                        "the observer at rest is nobody special: bodies may move together"},
                       {interval(high, low), "the least velocity comes first"}}});
  // The same by the library, for velocities along x.
  for (const double beyond : {-0.1, 0.1}) {
    for (const double observer : {got_low - beyond, got_high + beyond}) {
      const PairWrench push = pushes_of_the_book(high - observer, low - observer);
      const double sum = std::abs(push.on_a.force + push.on_b.force);
      const bool is_broken = sum > 0.5 * std::abs(push.on_a.force);
      if (is_broken == (beyond > 0.0)) continue;
      throw exercise::Rejection{
          exercise::line("for", "an observer with the velocity " + exercise::text(observer)) +
          exercise::line("got", "a sum of forces of " + exercise::text(sum))};
    }
  }
}

void check_torque_left(Complex displacement_a, Complex displacement_b) {
  const auto polygon = [](const Shape& shape) {
    return std::make_shared<ContactShape>(contact_shape(sample(shape, 200, Side::fluid_outside)));
  };
  const ContactShapes shapes{polygon(Ellipse{1.0, 0.4}), polygon(Circle{0.8})};
  const std::vector<RigidPath> paths{{{{0.3, -0.2}, 0.4}, displacement_a, 0.2},
                                     {{{2.3, 0.3}, 0.0}, displacement_b, 0.1}};
  const ContactRow row = interferences(shapes, paths, {{0.1}, 1e-6}).contacts.front().rows.front();
  const auto& [on_a, on_b] = row.derivative;
  const Complex n = on_a.force;
  const double exact = cross(paths[0].start.position, on_a.force) + on_a.torque +
                       cross(paths[1].start.position, on_b.force) + on_b.torque;
  expect({.what = "displacements " + exercise::text(displacement_a) + " and " +
                  exercise::text(displacement_b),
          .got = torque_left(displacement_a, displacement_b, n),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {{-exact, "from the end back to the start: the arm is -(displacement)"},
                       {-cross(displacement_a + displacement_b, n),
                        "forces are opposite: the difference of the displacements counts"},
                       {-dot(displacement_a - displacement_b, n), "a torque is a cross product"},
                       {0.0, "about the centres at the end it would be zero"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the sums",
        .formula = "F = F_a + F_b, T = c_a x F_a + T_a + c_b x F_b + T_b",
        .hint = "all torques about one point",
        .check =
            [] {
              check_imbalance({{1.0, 2.0}, {0.3, -0.4}, 0.7}, {{-0.5, 0.2}, {0.6, 0.1}, -0.2});
              check_imbalance({{0.0, 3.0}, {1.0, 0.0}, 0.5}, {{2.0, 0.0}, {-1.0, 0.0}, 2.5});
            }},
       {.title = "the pushes",
        .formula = "-sign(u . m) m, m = n for A, -n for B",
        .hint = "each body knows its own velocity only",
        .check =
            [] {
              const Complex n = std::polar(1.0, 0.4);
              check_absolute_pushes({1.0, 0.2}, {-0.5, 0.1}, n);
              check_absolute_pushes({1.0, 0.2}, {0.5, 0.1}, n);
              check_absolute_pushes({1.0, 0.2}, {0.0, 0.0}, n);
            }},
       {.title = "the observers",
        .formula = "u_b . n < v < u_a . n",
        .hint = "seen by the observer, A must move along n and B against it",
        .check =
            [] {
              check_harmless_observers({1.0, 0.3}, {0.4, -0.2}, 1.0);
              check_harmless_observers({0.9, 0.3}, {-0.2, 0.1}, std::polar(1.0, 0.5));
            }},
       {.title = "the torque",
        .formula = "-(displacement_a - displacement_b) x n",
        .hint = "the torque about another centre changes by (c_end - c_start) x F",
        .check = [] {
          check_torque_left({0.5, 0.2}, {-0.3, 0.4});
          check_torque_left({0.1, 0.6}, {-0.6, -0.1});
        }}});
}
