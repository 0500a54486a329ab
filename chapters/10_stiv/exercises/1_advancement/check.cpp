// Check of exercise 10.1: the library's bound, and contacts of points in closed form.
#include "chapters/check.hpp"

#include <algorithm>
#include <limits>

#include "stiv/rigid_path.hpp"

using namespace stokesbook;
using exercise::expect;

struct Motion {
  Complex offset, drift;
  double turn_a, turn_b;
};

struct Search {
  std::function<Complex(double)> path;
  std::function<double(Complex)> distance;
  double speed_bound, separation, tolerance;
};

double speed_bound(const Motion& motion, double radius);
double first_contact(const Search& search);
double gap(double distance, Complex touched, Complex normal, Complex end, double separation);

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void check_speed_bound(const Motion& motion, double radius) {
  const auto& [offset, drift, turn_a, turn_b] = motion;
  const RelativePath path({{offset, 0.0}, drift, turn_a}, {{0.0, 0.0}, 0.0, turn_b});
  const double spin = std::abs(turn_a - turn_b) * radius;
  const double at_start = std::abs(drift - turn_b * perp(offset)) + spin,
               at_end = std::abs(drift - turn_b * perp(offset + drift)) + spin;
  expect({.what = "turns " + exercise::text(turn_a) + " and " + exercise::text(turn_b) +
                  ", radius " + exercise::text(radius),
          .got = speed_bound(motion, radius),
          .expected = path.speed_bound(radius),
          .tolerance = 1e-12,
          .mistakes = {
              {std::abs(drift) + std::abs(turn_a) * radius,
               "B turns, and with it all that it sees: the farther away the faster"},
              {std::min(at_start, at_end),
               "the speed at the start is no bound: take the larger one of both ends"},
              {path.speed_bound(radius) - spin, "a point that is not at A's centre turns with A"},
              {std::abs(drift) + std::abs(turn_b) * std::abs(offset) + spin,
               "a bound, but not the least: add the vectors before you take the length"}}});
}

// What steps of another kind would find; `step` has the distance and the search.
double march(const Search& search, const std::function<double(double distance)>& step) {
  for (double tau = 0.0; tau <= 1.0;) {
    const double d = search.distance(search.path(tau));
    if (d <= search.separation + search.tolerance) return tau;
    tau += step(d);
  }
  return infinity;
}

// Straight at a speed, past a disk of radius 1 about the origin.
Search past_disk(double aside, double speed) {
  return {[=](double tau) {
            return Complex{-3.0 + speed * tau, aside};
          },
          [](Complex z) { return std::abs(std::abs(z) - 1.0); }, speed, 0.1, 1e-10};
}

// Across a needle on the imaginary axis.
Search through_needle(double speed) {
  const auto distance = [](Complex z) {
    return std::abs(z - Complex{0.0, std::clamp(z.imag(), -1.0, 1.0)});
  };
  return {[=](double tau) {
            return Complex{-3.0 + speed * tau, 0.3};
          },
          distance, speed, 0.001, 1e-10};
}

void expect_time(const std::string& what, const Search& search, double exact) {
  const double got = first_contact(search);
  // Infinity is compared as a time of its own.
  const auto finite = [](double tau) { return std::isfinite(tau) ? tau : 2.0; };
  const auto mistake = [&](const std::function<double(double)>& step) {
    return finite(march(search, step));
  };
  expect(
      {.what = what,
       .got = finite(got),
       .expected = finite(exact),
       .tolerance = 1e-6,
       .mistakes = {{mistake([&](double d) { return d / search.speed_bound; }),
                     "steps lead to the separation, not to the obstacle: (d - separation)/L"},
                    {mistake([](double) { return 1e-3; }),
                     "equal steps skip what is thinner than they are long"},
                    {2.0,
                     "the contact has been skipped: equal steps skip what is thinner than they are "
                     "long"}}});
}

void check_first_contact() {
  for (const double speed : {4.0, 40.0}) {
    for (const double aside : {0.0, 0.5, 1.0}) {
      const double way = 3.0 - std::sqrt(1.1 * 1.1 - aside * aside);
      expect_time("a disk, " + exercise::text(aside) + " aside, speed " + exercise::text(speed),
                  past_disk(aside, speed), way / speed);
    }
    expect_time("past a disk at speed " + exercise::text(speed), past_disk(1.2, speed), infinity);
    expect_time("a needle at speed " + exercise::text(speed), through_needle(speed), 2.999 / speed);
  }
  expect_time("a way that ends before the needle", through_needle(2.0), infinity);
}

void check_gap(Complex end) {
  const double separation = 0.1, distance = 0.1004;
  const Complex normal = std::polar(1.0, 2.2), touched = (1.0 + distance) * normal;
  const double along = dot(normal, end - touched), exact = distance - separation + along;
  expect({.what = "a way that ends at " + exercise::text(end),
          .got = gap(distance, touched, normal, end, separation),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{distance - separation - std::abs(end - touched),
                        "the way along the line is no gap: only that along the normal counts"},
                       {std::abs(end) - 1.0 - separation,
                        "this is the distance at the end, which forgets where the point came from"},
                       {along, "what the search has left above the separation is missing"},
                       {distance - separation - along, "the normal leads away from the obstacle"},
                       {distance + along, "the gap is that to the separation"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the bound of the speed",
        .formula =
            "max |D - turn_b perp(c)| at c = offset and offset + drift, + |turn_a - turn_b| r",
        .hint = "the length of a vector that is linear in tau is largest at one of the ends",
        .check =
            [] {
              check_speed_bound({{2.0, 0.5}, {-0.3, 0.2}, 0.4, -0.3}, 1.0);
              check_speed_bound({{2.0, 0.5}, {0.8, 0.4}, 0.1, 0.6}, 0.7);
            }},
       {.title = "the first contact",
        .formula = "tau += (d - separation)/L until d <= separation + tolerance",
        .hint = "d is 1-Lipschitz: the point cannot be nearer than d - L dtau",
        .check = check_first_contact},
       {.title = "the gap",
        .formula = "d - separation + n . (z(1) - z_I)",
        .hint = "a point that has passed through has a gap of minus its way",
        .check = [] {
          check_gap({0.3, 0.4});
          check_gap({2.5, -3.0});
        }}});
}
