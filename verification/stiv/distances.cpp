// Compares closest points and gaps at rest with a search over all edges.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "experiments.hpp"
#include "set_ups.hpp"
#include "stiv/polygon_gaps.hpp"

namespace stokesbook::verification::stiv {

using namespace study;
using Eigen::Index;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Returns the unsigned distance of a point from a polygon.
double by_all_edges(const ComplexVector& vertices, Complex z) {
  double least = infinity;
  for (Index i = 0; i < vertices.size(); ++i) {
    const Complex from = vertices[i], along = vertices[(i + 1) % vertices.size()] - from;
    const double t = std::clamp(dot(along, z - from) / std::norm(along), 0.0, 1.0);
    least = std::min(least, std::abs(z - from - t * along));
  }
  return least;
}

double by_closest_point(const Polygon& polygon, Complex z) {
  return std::abs(polygon.closest(z, infinity).distance);
}

double by_vertices(const Polygon& polygon, Complex z) {
  return (polygon.vertices().array() - z).abs().minCoeff();
}

std::vector<Index> sizes(Size size) {
  return size == Size::full ? std::vector<Index>{16, 64, 256, 1024, 4096}
                            : std::vector<Index>{16, 64, 256, 1024};
}

Measure point_errors(double (*distance)(const Polygon& polygon, Complex z)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Index m : sizes(size)) {
      const auto star = body(Star{1.0, 0.3, 5}, m);
      std::mt19937 generator(5);
      std::uniform_real_distribution<double> uniform(-2.0, 2.0);
      double worst = 0.0;
      for (int k = 0; k < 100; ++k) {
        const double x = uniform(generator);
        const Complex z{x, uniform(generator)};
        const double exact = by_all_edges(star->polygon.vertices(), z);
        worst = std::max(worst, std::abs(distance(star->polygon, z) - exact));
      }
      measurements.push_back({.x = static_cast<double>(m), .error = worst});
    }
    return measurements;
  };
}

// Holds two ellipses side by side, which are separate for all orientations.
struct Pair {
  ContactShapes shapes;
  std::vector<Pose> poses;
};

double one_way(const Pair& pair, std::size_t of, std::size_t about) {
  const auto placed = [&](std::size_t k) -> ComplexVector {
    return pair.poses[k].position + (std::polar(1.0, pair.poses[k].orientation) *
                                     pair.shapes[k]->polygon.vertices().array());
  };
  const ComplexVector vertices = placed(of), other = placed(about);
  double least = infinity;
  for (const Complex z : vertices) least = std::min(least, by_all_edges(other, z));
  return least;
}

double both_ways(const Pair& pair) {
  return std::min(one_way(pair, 0, 1), one_way(pair, 1, 0));
}

double first_way(const Pair& pair) {
  return one_way(pair, 0, 1);
}

double by_gaps(const Pair& pair) {
  return polygon_gaps(pair.shapes, pair.poses, 10.0).front().gap;
}

Measure gap_errors(double (*gap)(const Pair& pair)) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const Index m : {16, 32, 64, 128}) {
      const ContactShapes shapes{body(Ellipse{1.0, 0.5}, m), body(Ellipse{0.9, 0.3}, m)};
      double worst = 0.0;
      for (int k = 0; k < 12; ++k) {
        const Pair pair{shapes, {{{0.1, 0.2}, 0.5 * k}, {{2.0, 0.8}, 0.3 * k}}};
        worst = std::max(worst, std::abs(gap(pair) - both_ways(pair)));
      }
      measurements.push_back({.x = static_cast<double>(m), .error = worst});
    }
    return measurements;
  };
}

}  // namespace

Experiment distances() {
  return {.key = "distances",
          .title = "Distances from polygons against a search over all edges",
          .x = "vertices M",
          .error = "largest error of a distance, bodies of radius about 1",
          .lines = {{.key = "points",
                     .label = "points from a star",
                     .measure = point_errors(by_closest_point),
                     .claim = Claim{.id = "10_18",
                                    .statement = "The closest point is the closest of all edges.",
                                    .law = Identity{1e-14},
                                    .reason = "rectangles that are left out are farther away; a "
                                              "few roundings",
                                    .api = {"stokesbook::Polygon::closest()"}},
                     .control = Control{"the closest vertex", point_errors(by_vertices)}},
                    {.key = "gaps",
                     .label = "two ellipses",
                     .measure = gap_errors(by_gaps),
                     .claim = Claim{.id = "10_19",
                                    .statement = "The gap of two polygons is the least distance of "
                                                 "a vertex of either from an edge of the other.",
                                    .law = Identity{1e-14},
                                    .reason = "a few roundings",
                                    .api = {"stokesbook::polygon_gaps()"}},
                     .control = Control{"vertices of one polygon only", gap_errors(first_way)}}}};
}

}  // namespace stokesbook::verification::stiv
