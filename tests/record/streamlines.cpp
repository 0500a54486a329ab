// Tests the streamlines of known flows, whether lines cover the field evenly, and where lines end.

#include "record/streamlines.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

using namespace stokesbook;

namespace {

/// Returns a field on the square [-1, 1]^2 with a given velocity at every point.
Field square(const auto& velocity, Eigen::Index n = 81) {
  Field field;
  field.grid = {{-1.0, -1.0}, 2.0 / static_cast<double>(n - 1), n, n};
  field.velocity = field.grid.points().unaryExpr(velocity);
  field.in_fluid.assign(static_cast<std::size_t>(n * n), 1);
  return field;
}

double least_distance(const Streamline& a, const Streamline& b) {
  double least = 10.0;
  for (const Complex p : a.points) {
    for (const Complex q : b.points) least = std::min(least, std::abs(p - q));
  }
  return least;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(lines_of_flow)

BOOST_AUTO_TEST_CASE(rotation_makes_circles) {
  const std::vector<Streamline> lines =
      streamlines(square([](Complex x) { return imaginary * x; }), 0.1);
  int closed = 0;
  for (const Streamline& line : lines) {
    const double radius = std::abs(line.points.front());
    BOOST_TEST(2.0 * std::numbers::pi * radius > 0.09);  // the separation of lines, minus a step
    if (radius < 0.05) continue;
    for (const Complex point : line.points) {
      BOOST_TEST(std::abs(point) == radius, boost::test_tools::tolerance(2e-3));
    }
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      BOOST_TEST(std::arg(line.points[i] / line.points[i - 1]) > 0.0);
    }
    BOOST_TEST(line.closed == (radius < 0.97), "radius " << radius);
    closed += line.closed ? 1 : 0;
    if (!line.closed) continue;
    // The line goes round once: its ends meet up to the length of a step.
    const double turns =
        static_cast<double>(line.points.size()) * 0.0125 / (2.0 * std::numbers::pi * radius);
    BOOST_TEST(turns > 0.93);
    BOOST_TEST(turns < 1.07);
  }
  BOOST_TEST(closed >= 8);
}

// On a coarse grid, lines are much closer to each other than grid points, and their last steps
// end far outside the grid.
BOOST_AUTO_TEST_CASE(lines_closer_than_points_end_at_the_edge) {
  for (const Complex direction : {Complex{1.0, 0.0}, Complex{-1.0, 0.3}, Complex{0.2, -1.0}}) {
    const Field field = square([&](Complex) { return direction; }, 5);
    for (const Streamline& line : streamlines(field, 0.03)) {
      for (const Complex point : line.points) {
        BOOST_TEST(std::abs(point.real()) < 1.0 + 0.26);
        BOOST_TEST(std::abs(point.imag()) < 1.0 + 0.26);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(lines_keep_apart_and_leave_no_hole) {
  const Field field = square([](Complex x) {
    return Complex{std::sin(3 * x.real()) * std::cos(2 * x.imag()),
                   -1.5 * std::cos(3 * x.real()) * std::sin(2 * x.imag())};
  });
  const double separation = 0.12;
  const std::vector<Streamline> lines = streamlines(field, separation);
  for (std::size_t a = 0; a < lines.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      BOOST_TEST(least_distance(lines[a], lines[b]) > 0.499 * separation);
    }
  }
  for (const Complex point : field.grid.points()) {
    double least = 10.0;
    for (const Streamline& line : lines) {
      for (const Complex other : line.points) least = std::min(least, std::abs(point - other));
    }
    BOOST_TEST(least < 2.0 * separation);
  }
}

// The lines of a uniform flow begin in the first row or column of the grid.
BOOST_AUTO_TEST_CASE(lines_begin_at_all_edges) {
  for (const bool is_upward : {false, true}) {
    const Complex direction = is_upward ? Complex{0.0, 1.0} : Complex{1.0, 0.0};
    const auto across = [&](Complex x) { return is_upward ? x.real() : x.imag(); };
    double least = 10.0, most = -10.0;
    for (const Streamline& line : streamlines(square([&](Complex) { return direction; }), 0.1)) {
      least = std::min(least, across(line.points.front()));
      most = std::max(most, across(line.points.front()));
    }
    BOOST_TEST(least == -1.0);
    BOOST_TEST(most > 0.9);
  }
}

BOOST_AUTO_TEST_CASE(lines_end_at_the_grid_and_at_bodies) {
  Field field = square([](Complex) { return Complex{1.0, 0.0}; });
  const ComplexVector points = field.grid.points();
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    if (std::abs(points[i]) < 0.4) field.velocity[i] = Complex{std::nan(""), std::nan("")};
  }
  bool beside_the_disk = false;
  for (const Streamline& line : streamlines(field, 0.1)) {
    BOOST_TEST(!line.closed);
    for (const Complex point : line.points) {
      BOOST_TEST(std::abs(point) > 0.4);
      BOOST_TEST(point.imag() == line.points.front().imag());
      BOOST_TEST(std::abs(point.real()) <= 1.0 + 0.0126);
    }
    const double height = std::abs(line.points.front().imag());
    const double ends = line.points.back().real() - line.points.front().real();
    if (height > 0.45) BOOST_TEST(ends > 1.95);
    beside_the_disk = beside_the_disk || (height < 0.3 && ends > 0.5 && ends < 0.75);
  }
  BOOST_TEST(beside_the_disk);
}

BOOST_AUTO_TEST_CASE(lines_are_at_least_as_long_as_they_are_apart) {
  const Field field = square([](Complex) { return Complex{1.0, 0.0}; });
  BOOST_TEST(!streamlines(field, 1.3).empty());  // all lines have length 2
  BOOST_TEST(streamlines(field, 2.2).empty());
}

BOOST_AUTO_TEST_CASE(nothing_flows) {
  BOOST_TEST(streamlines(square([](Complex) { return Complex{}; }), 0.1).empty());
  Field field = square([](Complex x) { return x; });
  field.velocity.resize(0);
  BOOST_CHECK_THROW(streamlines(field, 0.1), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
