// Counts the cost of a search. The number of queries a vertex has a bound for any polygon size,
// speed and tolerance; pairs and queries are in proportion to the number of bodies.
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "random_steps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

double queries_a_vertex(const SearchCost& cost) {
  return static_cast<double>(cost.queries) / static_cast<double>(cost.vertices);
}

}  // namespace

BOOST_AUTO_TEST_CASE(queries_do_not_grow_with_the_polygon) {
  for (double aside : {0.0, 1.0, 2.05}) {
    for (double travel : {3.0, 300.0}) {
      for (Eigen::Index m : {64, 512, 4096}) {
        Step step;
        step.add(body(Circle{1.0}, m), {{{-3.0, 0.0}, 0.1}, {travel, 0.0}, 0.3});
        step.add(body(Circle{1.0}, m), {{{3.0, aside}, 0.1}, {-travel, 0.0}, -0.2});
        const SearchCost cost = interferences(step, {{0.1}, 1e-4}).cost;
        BOOST_TEST(cost.pairs == 1u);
        BOOST_TEST(cost.vertices <= static_cast<std::size_t>(2 * m));
        BOOST_TEST(queries_a_vertex(cost) < 16.5);
      }
    }
  }
}

// A body slides along a wall just above the tolerance. With certain steps (10.3) alone, the number
// of steps would grow as the travel divided by the tolerance.
BOOST_AUTO_TEST_CASE(sliding_along_a_wall) {
  const double separation = 0.01;
  const auto wall = body(Superellipse{10.0, 1.0, 20}, 2000), disk = body(Circle{0.5}, 256);
  for (double tolerance : {1e-5, 1e-8, 1e-11}) {
    for (double above : {1.01 * tolerance, 3.0 * tolerance, 0.5 * tolerance, 0.0}) {
      Step step;
      step.add(wall, {});
      // The lowest vertex of the disk is over the straight part of the wall.
      step.add(disk, {{{-3.0, 1.5 + separation + above}, 0.0}, {2.0, 0.0}, 0.0});
      const Interferences found = interferences(step, {{separation}, tolerance});
      BOOST_TEST(found.admits_step());
      // Within the tolerance of the separation, the steps are half the separation. Only these steps
      // are many.
      BOOST_TEST(queries_a_vertex(found.cost) < 4.0 + 2.0 * 2.0 / separation);
    }
  }
}

// Slow approaches at a slant also end after few steps, at any tolerance.
BOOST_AUTO_TEST_CASE(slanting_approaches) {
  const auto wall = body(Superellipse{10.0, 1.0, 20}, 2000), disk = body(Circle{0.5}, 256);
  for (double slope : {1.0, 1e-1, 1e-2, 1e-3}) {
    for (double tolerance : {1e-5, 1e-8, 1e-11}) {
      Step step;
      step.add(wall, {});
      step.add(disk, {{{-3.0, 1.52 + slope}, 0.0}, {2.0, -2.0 * slope}, 0.0});
      const Interferences found = interferences(step, {{0.02}, tolerance, RowChoice::every, 0.0});
      BOOST_TEST(!found.admits_step());
      BOOST_TEST(queries_a_vertex(found.cost) < 60.0);
      BOOST_TEST(std::abs(first_time(violated(found)) - 0.5) < 1e-3 / slope);
    }
  }
}

// A lattice of circles lies in a container that grows with the lattice.
BOOST_AUTO_TEST_CASE(linear_in_the_number_of_bodies) {
  const auto circle = body(Circle{0.4}, 64);
  std::vector<double> pairs, queries;
  for (int side : {10, 20, 40}) {
    Step step;
    const double half = 0.5 * (side - 1);
    step.add(container(Circle{0.8 * side + 1.0}, 400 * side), {});
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> uniform(-0.15, 0.15);
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const double dx = uniform(generator);
        step.add(circle, {{{i - half, j - half}, 0.0}, {dx, uniform(generator)}, 0.1});
      }
    }
    const SearchCost cost = interferences(step, {{0.05}, 1e-4}).cost;
    pairs.push_back(static_cast<double>(cost.pairs) / (side * side));
    queries.push_back(static_cast<double>(cost.queries) / (side * side));
  }
  // Bodies at the border have fewer neighbours. The share of these bodies halves if the side
  // doubles.
  for (const std::vector<double>& count : {pairs, queries}) {
    BOOST_TEST(count[2] - count[1] < 0.8 * (count[1] - count[0]));
    BOOST_TEST(count[2] < 1.3 * count[0]);
  }
  BOOST_TEST(pairs.back() < 6.0);
}
