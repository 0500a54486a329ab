// Tests the checks of polygons that a scene gives as curves.
#include "scene/polygon.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <boost/test/unit_test.hpp>

using namespace stokesbook;
using scene_text::find_fault;

namespace {

using Points = std::vector<Complex>;

ComplexVector vector_of(const Points& points) {
  return Eigen::Map<const ComplexVector>(points.data(), static_cast<Eigen::Index>(points.size()));
}

/// Returns the fault, after the number of its point if there is one, or "none".
std::string fault_of(const ComplexVector& points) {
  const auto fault = find_fault(points);
  if (!fault) return "none";
  return fault->point ? std::to_string(*fault->point) + ": " + fault->problem : fault->problem;
}

std::string fault_of(const Points& points) {
  return fault_of(vector_of(points));
}

/// Returns points of the curve r = 1 + amplitude cos(5 t), moved to a centre.
ComplexVector star(double amplitude, Complex centre = 0.0, Eigen::Index n = 100) {
  ComplexVector points(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    points[k] = centre + std::polar(1.0 + amplitude * std::cos(5.0 * t), t);
  }
  return points;
}

Points moved(Points points, Complex by) {
  for (Complex& point : points) point += by;
  return points;
}

const Points octagon{{2, 0}, {1, 1}, {0, 1}, {-1, 1}, {-2, 0}, {-1, -1}, {0, -1}, {1, -1}};
const Points vessel{{-3, -1}, {3, -1}, {3, 2}, {2, 2}, {2, 0.5}, {-2, 0.5}, {-2, 2}, {-3, 2}};

const std::string meets = "the edge to the next point meets the edge that starts at ";
const std::string misses_origin = "the curve must go around the origin: loads act there";

}  // namespace

BOOST_AUTO_TEST_SUITE(polygon)

BOOST_AUTO_TEST_CASE(accepts_simple_curves) {
  BOOST_TEST(fault_of(star(0.0)) == "none");
  BOOST_TEST(fault_of(star(0.7)) == "none");
  BOOST_TEST(fault_of(ComplexVector(star(0.7).reverse())) == "none");
  BOOST_TEST(fault_of(ComplexVector(1e-6 * star(0.3))) == "none");
  BOOST_TEST(fault_of(ComplexVector(1e6 * star(0.3))) == "none");
  BOOST_TEST(fault_of(star(0.0, {0.9, 0.0})) == "none");
  BOOST_TEST(fault_of(octagon) == "none");  // three points on one line
  BOOST_TEST(fault_of(vessel) == "none");   // two separate edges on one line
}

BOOST_AUTO_TEST_CASE(wants_points_enough) {
  BOOST_TEST(fault_of(star(0.0, 0.0, 8)) == "none");
  BOOST_TEST(fault_of(star(0.0, 0.0, 7)) == "must be at least 8 points, not 7");
  BOOST_TEST(fault_of(Points{}) == "must be at least 8 points, not 0");
}

BOOST_AUTO_TEST_CASE(wants_distinct_neighbours) {
  const std::string repeated = "is the same point as the next one (the last joins the first)";
  ComplexVector points = star(0.0);
  points[4] = points[3];
  BOOST_TEST(fault_of(points) == "3: " + repeated);
  points = star(0.0);
  points[99] = points[0];
  BOOST_TEST(fault_of(points) == "99: " + repeated);
}

BOOST_AUTO_TEST_CASE(finds_edges_that_meet) {
  Points points = octagon;
  points[2] = {0, -2};  // edges 1 and 2 cross the opposite side
  BOOST_TEST(fault_of(points) == "1: " + meets + "[0, -1]");
  points[2] = {0.5, -1};  // the point lies on the opposite side
  BOOST_TEST(fault_of(points) == "1: " + meets + "[0, -1]");
  points[2] = points[6];  // the point lies on another corner
  BOOST_TEST(fault_of(points) == "1: " + meets + "[-1, -1]");
  // Edges 0 and 4 overlap on one line.
  BOOST_TEST(fault_of(Points{{1, 0}, {3, 0}, {3, 1}, {4, 1}, {4, 0}, {2, 0}, {-1, -1}, {-1, 1}}) ==
             "0: " + meets + "[4, 0]");
}

BOOST_AUTO_TEST_CASE(finds_spikes) {
  BOOST_TEST(
      fault_of(Points{{2, 0}, {1, 1}, {0, 1}, {-1, 1}, {-2, 0}, {-4, 0}, {-3, 0}, {0, -2}}) ==
      "4: the curve turns back on itself at the next point");
}

BOOST_AUTO_TEST_CASE(wants_the_origin_inside) {
  BOOST_TEST(fault_of(star(0.0, {1.5, 0.0})) == misses_origin);
  BOOST_TEST(fault_of(moved(octagon, {0.5, 1.0})) == misses_origin);   // 0 is on an edge
  BOOST_TEST(fault_of(moved(octagon, {1.0, 1.0})) == misses_origin);   // 0 is a corner
  BOOST_TEST(fault_of(moved(vessel, {-2.0, -0.5})) == misses_origin);  // 0 is a reentrant corner
  BOOST_TEST(fault_of(moved(vessel, {0.0, -1.0})) == misses_origin);   // above the floor, outside
}

BOOST_AUTO_TEST_SUITE_END()
