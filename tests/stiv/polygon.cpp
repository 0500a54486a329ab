// Checks queries of a polygon against a comparison with all of its edges: closest points with their
// side, chords, vertices in rectangles.
#include "stiv/polygon.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <boost/test/unit_test.hpp>

#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;

BOOST_AUTO_TEST_SUITE(polygon)

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Polygon polygon(const Shape& shape, Index m, Side side = Side::fluid_outside) {
  return Polygon(sample(shape, m, side).x, side);
}

Complex after(const Polygon& polygon, Index i) {
  return polygon.vertex((i + 1) % polygon.size());
}

double distance_to_edge(Complex z, Complex from, Complex to) {
  const double along = dot(z - from, to - from) / std::norm(to - from);
  return std::abs(z - from - std::clamp(along, 0.0, 1.0) * (to - from));
}

// Compares all edges; the winding number determines the side.
double signed_distance(const Polygon& polygon, Complex z) {
  double distance = infinity, angle = 0.0;
  for (Index i = 0; i < polygon.size(); ++i) {
    const Complex from = polygon.vertex(i), to = after(polygon, i);
    distance = std::min(distance, distance_to_edge(z, from, to));
    angle += std::arg((to - z) / (from - z));
  }
  const bool is_inside = std::abs(angle) > 1.0;
  return is_inside == (polygon.side() == Side::fluid_inside) ? distance : -distance;
}

const std::vector<Polygon>& polygons() {
  static const std::vector<Polygon> all{
      polygon(Circle{1.0}, 64),
      polygon(Ellipse{1.0, 0.1}, 4),  // a needle: acute corners
      polygon(Ellipse{1.0, 0.1}, 100),
      polygon(Star{1.0, 0.45, 3}, 256),
      polygon(Star{0.9, 0.3, 7}, 250, Side::fluid_inside),
      polygon(Superellipse{1.0, 0.7, 8}, 1000, Side::fluid_inside)};
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(closest_points_and_their_side) {
  for (const Polygon& p : polygons()) {
    std::size_t inside = 0;
    for (Complex z : test::random_vector(2000, 1)) {
      z *= 1.5;
      const ClosestPoint closest = p.closest(z, infinity);
      const double expected = signed_distance(p, z);
      BOOST_TEST(std::abs(closest.distance - expected) < 1e-14);
      BOOST_TEST(std::abs(z - closest.point - closest.distance * closest.normal) < 1e-14);
      BOOST_TEST(std::abs(std::abs(closest.normal) - 1.0) < 1e-14);
      BOOST_TEST(distance_to_edge(closest.point, p.vertex(closest.edge), after(p, closest.edge)) <
                 1e-15);
      if (expected < 0.0) ++inside;
    }
    BOOST_TEST(inside > 20u);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_found_beyond_the_reach) {
  for (const Polygon& p : polygons()) {
    for (Complex z : test::random_vector(500, 2)) {
      const double distance = std::abs(signed_distance(p, z));
      BOOST_TEST(p.closest(z, 0.999 * distance).edge == -1);
      BOOST_TEST(std::isinf(p.closest(z, 0.999 * distance).distance));
      BOOST_TEST(std::abs(std::abs(p.closest(z, 1.001 * distance).distance) - distance) < 1e-15);
    }
  }
}

// On the polygon itself the distance is 0, and the normal still points into the fluid.
BOOST_AUTO_TEST_CASE(normals_where_the_distance_is_zero) {
  for (const Polygon& p : polygons()) {
    for (Index i = 0; i < p.size(); ++i) {
      for (double along : {0.0, 0.5}) {
        const Complex z = p.vertex(i) + along * (after(p, i) - p.vertex(i));
        const ClosestPoint closest = p.closest(z, infinity);
        BOOST_TEST(std::abs(closest.distance) < 1e-15);
        BOOST_TEST(signed_distance(p, z + 1e-6 * closest.normal) > 0.0);
        BOOST_TEST(signed_distance(p, z - 1e-6 * closest.normal) < 0.0);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(chords_that_keep_clear) {
  for (const Polygon& p : polygons()) {
    const ComplexVector ends = test::random_vector(600, 3);
    std::size_t near = 0, crossing = 0;
    for (Index k = 0; k + 1 < ends.size(); ++k) {
      const Chord chord{ends[k], ends[k] + 0.3 * (ends[k + 1] - ends[k])};
      // Along the chord the distance changes at most as fast as the place on the chord.
      constexpr int pieces = 400;
      const double piece = std::abs(chord.to - chord.from) / pieces;
      double least = infinity;
      bool changes_side = false;
      const double first = signed_distance(p, chord.from);
      for (int i = 0; i <= pieces; ++i) {
        const double d =
            p.closest(chord.from + (chord.to - chord.from) * (double(i) / pieces), infinity)
                .distance;
        least = std::min(least, std::abs(d));
        changes_side = changes_side || (d < 0.0) != (first < 0.0);
      }
      if (changes_side) {
        BOOST_TEST(!p.is_clear_of(chord, 0.0));
        ++crossing;
      }
      for (double distance : {0.0, 0.05, 0.2}) {
        if (!changes_side && least - piece > distance) BOOST_TEST(p.is_clear_of(chord, distance));
        if (least < distance) {
          BOOST_TEST(!p.is_clear_of(chord, distance));
          ++near;
        }
      }
    }
    BOOST_TEST(near > 20u);
    BOOST_TEST(crossing > 20u);
  }
}

BOOST_AUTO_TEST_CASE(vertices_in_rectangles) {
  for (const Polygon& p : polygons()) {
    const ComplexVector corners = test::random_vector(200, 4);
    for (Index k = 0; k + 1 < corners.size(); ++k) {
      const Rectangle rectangle = bounding_rectangle(corners.segment(k, 2));
      std::vector<Index> expected;
      for (Index i = 0; i < p.size(); ++i) {
        const Complex z = p.vertex(i);
        if (z.real() >= rectangle.lower.real() && z.real() <= rectangle.upper.real() &&
            z.imag() >= rectangle.lower.imag() && z.imag() <= rectangle.upper.imag()) {
          expected.push_back(i);
        }
      }
      BOOST_TEST(p.vertices_in(rectangle) == expected, boost::test_tools::per_element());
    }
    BOOST_TEST(p.vertices_in(p.bounds()).size() == static_cast<std::size_t>(p.size()));
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_polygon_is_refused) {
  const auto make = [](const ComplexVector& vertices) {
    return Polygon(vertices, Side::fluid_outside);
  };
  const auto says = [](const std::string& message) {
    return [=](const std::invalid_argument& error) { return error.what() == message; };
  };
  BOOST_CHECK_EXCEPTION(make(ComplexVector{{0.0, 1.0}}), std::invalid_argument,
                        says("a polygon requires three or more vertices, got 2"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_EXCEPTION(make(ComplexVector{{0.0, 1.0, Complex{0.5, nan}}}), std::invalid_argument,
                        says("vertex 2 of a polygon is not finite: (0.5,nan)"));
  BOOST_CHECK_EXCEPTION(make(ComplexVector{{0.0, -infinity, 1.0}}), std::invalid_argument,
                        says("vertex 1 of a polygon is not finite: (-inf,0)"));
}

BOOST_AUTO_TEST_SUITE_END()
