// Measures the gaps of polygons at rest, from the signed distances of their vertices and from edges
// that cross, as the test that accepts a state (section "How it fails" of chapter 10).
#include "stiv/polygon_gaps.hpp"

#include <algorithm>
#include <limits>

#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr double any_distance = std::numeric_limits<double>::infinity();

// Returns the frame of a pose, seen from the frame of another pose.
RelativeFrame frame_in(const Pose& pose, const Pose& observer) {
  return RelativePath({pose, {}, 0.0}, {observer, {}, 0.0}).start();
}

// Returns the vertices of a polygon `of` that may be nearer than `reach` to a polygon `about`, or
// overlap it: the vertices in the bounding rectangle of `about`, widened by `reach`. Returns all
// vertices if `about` is an enclosing wall.
std::vector<Index> near_vertices(const Polygon& of, const Polygon& about,
                                 const RelativeFrame& frame, double reach) {
  if (about.side() == Side::fluid_inside) {
    return of.vertices_if([](const Rectangle&) { return true; });
  }
  const auto [lower, upper] = about.bounds();
  const ComplexVector corners =
      ComplexVector{{frame.inverse(lower), frame.inverse({upper.real(), lower.imag()}),
                     frame.inverse(upper), frame.inverse({lower.real(), upper.imag()})}};
  return of.vertices_in(widened(bounding_rectangle(corners), reach));
}

// Holds a component's shape and its pose.
struct Placed {
  const ContactShape& shape;
  const Pose& pose;
};

// Holds the vertex of one polygon with the least signed distance from the other.
struct NearestVertex {
  double distance;
  Complex place;   // in the plane
  Complex normal;  // derivative of the distance by the place
};

NearestVertex nearest_vertex(const Placed& of, const Placed& about, double reach) {
  const RelativeFrame frame = frame_in(of.pose, about.pose);
  const auto turn = [](const Pose& pose) { return std::polar(1.0, pose.orientation); };
  NearestVertex nearest{any_distance, {}, {}};
  for (Index i : near_vertices(of.shape.polygon, about.shape.polygon, frame, reach)) {
    const Complex x = of.shape.polygon.vertex(i);
    const ClosestPoint closest = about.shape.polygon.closest(frame(x), any_distance);
    if (closest.distance < nearest.distance) {
      nearest = {closest.distance, of.pose.position + turn(of.pose) * x,
                 turn(about.pose) * closest.normal};
    }
  }
  return nearest;
}

// Returns whether edges of two polygons cross.
bool edges_cross(const Placed& p, const Placed& q) {
  const bool p_is_simpler = p.shape.polygon.size() < q.shape.polygon.size();
  const Placed &of = p_is_simpler ? p : q, &about = p_is_simpler ? q : p;
  const RelativeFrame frame = frame_in(of.pose, about.pose);
  const Index m = of.shape.polygon.size();
  for (Index i = 0; i < m; ++i) {
    const Chord edge{frame(of.shape.polygon.vertex(i)),
                     frame(of.shape.polygon.vertex((i + 1) % m))};
    if (!about.shape.polygon.is_clear_of(edge, 0.0)) return true;
  }
  return false;
}

// Returns whether the bounding circle of a polygon is farther than `reach` from another polygon.
bool is_circle_far(const Placed& of, const Placed& about, double reach) {
  const double distance = reach + of.shape.radius;
  const Complex centre = frame_in(of.pose, about.pose)({});
  return about.shape.polygon.closest(centre, any_distance).distance > distance;
}

// Returns the gap of a and b; the result is at least `reach` if they are not nearer than `reach`.
PolygonGap gap_of(const ComponentPair& pair, const Placed& a, const Placed& b, double reach) {
  if (is_circle_far(a, b, reach)) return {pair.first, pair.second, any_distance, {}, {}};
  const NearestVertex of_a = nearest_vertex(a, b, reach), of_b = nearest_vertex(b, a, reach);
  const bool is_of_a = of_a.distance <= of_b.distance;
  const NearestVertex nearest = is_of_a ? of_a : of_b;
  const bool hidden_overlap = nearest.distance > 0.0 && edges_cross(a, b);
  return {pair.first, pair.second, hidden_overlap ? 0.0 : nearest.distance, nearest.place,
          is_of_a ? nearest.normal : -nearest.normal};
}

}  // namespace

std::vector<PolygonGap> polygon_gaps(const ContactShapes& shapes, const std::vector<Pose>& poses,
                                     double reach) {
  require(shapes.size() == poses.size(), "contact requires a pose for each shape, got ",
          shapes.size(), " shapes and ", poses.size(), " poses");
  std::vector<Rectangle> rectangles;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    rectangles.push_back(bounding_rectangle(*shapes[k], poses[k]));
  }
  const std::vector<ComponentPair> pairs = near_pairs(shapes, rectangles, reach);
  std::vector<PolygonGap> gaps(pairs.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    gaps[i] = gap_of({a, b}, {*shapes[a], poses[a]}, {*shapes[b], poses[b]}, reach);
  }
  std::erase_if(gaps, [&](const PolygonGap& gap) { return gap.gap >= reach; });
  return gaps;
}

}  // namespace stokesbook
