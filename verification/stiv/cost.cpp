// Counts the queries and vertices of a search.
#include <cmath>
#include <random>

#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::stiv {

using namespace study;
using Eigen::Index;

namespace {

Measure queries_a_vertex(double travel) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index m = 64; m <= (size == Size::full ? 65536 : 4096); m *= 4) {
      const Step step{
          {body(Circle{1.0}, m), body(Circle{1.0}, m)},
          {{{{-3.0, 0.0}, 0.1}, {travel, 0.0}, 0.3}, {{{3.0, 1.0}, 0.1}, {-travel, 0.0}, -0.2}}};
      const SearchCost cost = interferences(step.shapes, step.paths, {{0.1}, 1e-4}).cost;
      measurements.push_back(
          {.x = static_cast<double>(m),
           .error = static_cast<double>(cost.queries) / static_cast<double>(cost.vertices)});
    }
    return measurements;
  };
}

// A planted defect: vertices advance by the length of an edge. Sixteen vertices suffice for the
// mean.
Measure queries_by_edges(double travel) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (Index m = 64; m <= 4096; m *= 4) {
      const auto circle = body(Circle{1.0}, m);
      const RelativePath path({{{-3.0, 0.0}, 0.1}, {travel, 0.0}, 0.3},
                              {{{3.0, 1.0}, 0.1}, {-travel, 0.0}, -0.2});
      double queries = 0.0;
      for (Index i = 0; i < m; i += m / 16) {
        const Complex vertex = circle->polygon.vertex(i);
        const double edge = 2.0 * std::numbers::pi / static_cast<double>(m);
        const double step = edge / path.speed_bound(std::abs(vertex));
        for (double tau = 0.0; tau < 1.0; tau += step, ++queries) {
          if (circle->polygon.closest(path.at(tau)(vertex), 100.0).distance < 0.1) break;
        }
      }
      measurements.push_back({.x = static_cast<double>(m), .error = queries / 16.0});
    }
    return measurements;
  };
}

// Counts the comparisons of each vertex with each edge.
std::vector<Measurement> all_edges(Size size) {
  std::vector<Measurement> measurements;
  for (double m = 64; m <= (size == Size::full ? 65536.0 : 4096.0); m *= 4) {
    measurements.push_back({.x = m, .error = m});
  }
  return measurements;
}

std::vector<int> sides(Size size) {
  return size == Size::full ? std::vector<int>{8, 12, 16, 24, 32, 48, 64}
                            : std::vector<int>{8, 12, 16, 24};
}

// Returns a lattice of circles, each slightly displaced.
Step lattice(int side) {
  static const auto circle = body(Circle{0.4}, 64);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-0.15, 0.15);
  Step step;
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      const double dx = uniform(generator);
      step.shapes.push_back(circle);
      step.paths.push_back(
          {{{static_cast<double>(i), static_cast<double>(k)}, 0.0}, {dx, uniform(generator)}, 0.1});
    }
  }
  return step;
}

SearchCost cost_of_lattice(int side) {
  const Step step = lattice(side);
  return interferences(step.shapes, step.paths, {{0.05}, 1e-4}).cost;
}

// A planted defect: the broad phase is left out. Small lattices suffice for it.
SearchCost cost_of_all_pairs(int side) {
  const Step step = lattice(side);
  SearchCost cost;
  for (std::size_t b = 0; b < step.paths.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      cost += pair_events(step.shapes, {a, b, step.paths[a], step.paths[b]}, {0.05, 1e-4, 0.2, 0.0})
                  .cost;
      ++cost.pairs;
    }
  }
  return cost;
}

Measure counts(std::size_t SearchCost::*count) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const int side : sides(size)) {
      measurements.push_back({.x = static_cast<double>(side * side),
                              .error = static_cast<double>(cost_of_lattice(side).*count)});
    }
    return measurements;
  };
}

Measure counts_of_all_pairs(std::size_t SearchCost::*count) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const int side : {4, 6, 8}) {
      measurements.push_back({.x = static_cast<double>(side * side),
                              .error = static_cast<double>(cost_of_all_pairs(side).*count)});
    }
    return measurements;
  };
}

std::vector<Measurement> all_pairs(Size size) {
  std::vector<Measurement> measurements;
  for (const int side : sides(size)) {
    const double n = side * side;
    measurements.push_back({.x = n, .error = 0.5 * n * (n - 1.0)});
  }
  return measurements;
}

Line line(const std::string& key, const std::string& label, std::size_t SearchCost::*count,
          const std::string& id) {
  return {
      .key = key,
      .label = label,
      .measure = counts(count),
      .claim = Claim{.id = id,
                     .statement = label + " grow in proportion to the number of bodies.",
                     .law = Algebraic{-1.0, 0.1},
                     .reason = "a circle has four neighbours in reach; those at the border have "
                               "fewer, which adds to the order at small n",
                     .api = {"stokesbook::near_pairs()"}},
      .control = Control{"no broad phase", counts_of_all_pairs(count)}};
}

}  // namespace

Experiment queries() {
  return {
      .key = "queries",
      .title = "Queries for two circles that collide",
      .x = "vertices M",
      .error = "queries a vertex",
      .lines = {
          {.key = "slow",
           .label = "travel 6",
           .measure = queries_a_vertex(3.0),
           .claim = Claim{.id = "10_15",
                          .statement = "Queries a vertex do not grow with the polygon.",
                          .law = Algebraic{0.0, 0.1},
                          .reason = "the path of a vertex is the same whatever its "
                                    "neighbours are",
                          .api = {"stokesbook::vertex_events()"}},
           .control =
               Control{"vertices that advance by the length of an edge", queries_by_edges(3.0)}},
          {.key = "fast", .label = "travel 600", .measure = queries_a_vertex(300.0)},
          {.key = "edges", .label = "each vertex against each edge, once", .measure = all_edges}}};
}

Experiment pairs() {
  return {.key = "pairs",
          .title = "A lattice of circles",
          .x = "circles K",
          .error = "pairs of the broad phase; queries",
          .lines = {line("pairs", "Pairs", &SearchCost::pairs, "10_16"),
                    line("queries", "Queries", &SearchCost::queries, "10_17"),
                    {.key = "all", .label = "all pairs", .measure = all_pairs}}};
}

}  // namespace stokesbook::verification::stiv
