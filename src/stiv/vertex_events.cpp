// Follows the vertices of one component past the polygon of another by conservative advancement
// (10.3) along the relative path (10.2), and measures the gaps that they leave (10.5).
#include "stiv/vertex_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace stokesbook {

using Eigen::Index;

namespace {

// Follows the vertices of component A past the polygon of component B.
class Search {
 public:
  Search(const ContactShape& a, const Polygon& polygon, const RelativePath& path,
         const Clearance& clearance)
      : a_(a),
        polygon_(polygon),
        path_(path),
        clearance_(clearance),
        deep_((1.0 - clearance.allowed_intrusion) * clearance.separation + clearance.tolerance) {}

  // Returns the vertices of A that may come near B. A run of vertices is left out if the path of
  // its bounding circle keeps away from B.
  std::vector<Index> find_candidates() {
    return a_.polygon.vertices_if([this](const Rectangle& rectangle) {
      const Complex centre = 0.5 * (rectangle.lower + rectangle.upper);
      const double radius = 0.5 * std::abs(rectangle.upper - rectangle.lower);
      return !is_clear(centre, start_of(centre), end_of(centre), clearance_.reach + radius);
    });
  }

  // Returns the event of a vertex. The gap is (10.5) if the vertex goes deep and ends beyond the
  // touched line; otherwise the distance at the end counts. Returns nothing if the vertex neither
  // goes deep nor ends near B.
  std::optional<VertexEvent> find_event(Index vertex) {
    const Complex x = a_.polygon.vertex(vertex);
    const PathPoint start = start_of(x), end = end_of(x);
    const ClosestPoint at = closest(end.z, clearance_.reach);
    const double path_length = std::abs(end.z - start.z) + path_.stray_bound(std::abs(x), 1.0);
    const bool ends_far = std::min(at.distance, clearance_.reach) > deep_ + path_length;
    const bool ends_deep = at.distance <= deep_;
    if (ends_deep || (!ends_far && !is_never_deep(x, start, end, 3))) {
      if (const auto touch = find_deep_touch(x, end.z)) {
        return complete(vertex, touch->tau, gap(*touch, end.z), touch->at);
      }
    }
    if (at.edge < 0) return {};
    return complete(vertex, 1.0, at.distance - clearance_.separation, at);
  }

  std::size_t queries() const { return queries_; }

 private:
  // A point of A at a time, in B's frame.
  struct PathPoint {
    double tau;
    Complex z;
  };

  // A place of the path at which the distance from B has fallen to the separation.
  struct Touch {
    double tau;
    Complex z;
    ClosestPoint at;
  };

  PathPoint start_of(Complex x) const { return {0.0, path_.start()(x)}; }
  PathPoint end_of(Complex x) const { return {1.0, path_.end()(x)}; }
  PathPoint point_at(Complex x, double tau) const { return {tau, path_.at(tau)(x)}; }

  // Returns the gap at the end from the line through the touched point (10.5).
  double gap(const Touch& touch, Complex end) const {
    return touch.at.distance - clearance_.separation + dot(touch.at.normal, end - touch.z);
  }

  // Returns true if chords of the path of a point X of A prove that X never goes deep. This
  // suffices for most points. The path is halved up to `halvings` times.
  bool is_never_deep(Complex x, const PathPoint& from, const PathPoint& to, int halvings) {
    if (is_clear(x, from, to, deep_)) return true;
    if (halvings == 0) return false;
    const PathPoint middle = point_at(x, 0.5 * (from.tau + to.tau));
    return is_never_deep(x, from, middle, halvings - 1) &&
           is_never_deep(x, middle, to, halvings - 1);
  }

  // Finds the contact in which a point X of A goes deep and ends beyond the touched line. Returns
  // the touch at the start of this contact, or the first deep place if X ends beyond the line there
  // only. Returns nothing if there is no such contact. Advances by (10.3) with the bound (10.4).
  std::optional<Touch> find_deep_touch(Complex x, Complex end) {
    const double speed = path_.speed_bound(std::abs(x)), separation = clearance_.separation,
                 tolerance = clearance_.tolerance;
    std::optional<Touch> touch;
    double tau = 0.0, previous = std::numeric_limits<double>::infinity(), stretch = 1.0;
    while (tau < 1.0) {
      const Complex z = path_.at(tau)(x);
      const ClosestPoint at = closest(z, separation + tolerance + speed * (1.0 - tau));
      if (at.edge < 0) return {};
      const double excess = at.distance - separation;
      double step = excess / speed;  // (10.3): no contact before tau + step
      if (excess > tolerance) {
        touch.reset();
        // If steps hardly shrink, try chords of growing length.
        stretch = step > 0.5 * previous ? 2.0 * stretch : 1.0;
        previous = step;
        const double longer = std::min(stretch * step, 1.0 - tau);
        if (longer > step && is_clear(x, {tau, z}, point_at(x, tau + longer), separation)) {
          step = longer;
        } else {
          stretch = 1.0;
        }
      } else {
        if (!touch) touch = Touch{tau, z, at};
        if (at.distance <= deep_) {
          for (const Touch& line : {*touch, Touch{tau, z, at}}) {
            if (gap(line, end) < -tolerance) return line;
          }
        }
        // In contact, a step of half the separation cannot pass through B.
        step = 0.5 * std::max(at.distance, separation) / speed;
      }
      tau += std::max(step, std::numeric_limits<double>::epsilon());
    }
    return {};
  }

  // Returns whether the chord between two places of X proves that the path between them keeps a
  // distance from B.
  bool is_clear(Complex x, const PathPoint& from, const PathPoint& to, double distance) {
    ++queries_;
    return polygon_.is_clear_of({from.z, to.z},
                                distance + path_.stray_bound(std::abs(x), to.tau - from.tau));
  }

  ClosestPoint closest(Complex z, double at_most) {
    ++queries_;
    return polygon_.closest(z, at_most);
  }

  VertexEvent complete(Index vertex, double time, double gap, const ClosestPoint& at) const {
    return {vertex, at.edge, a_.weights[vertex], time, gap, at.point, at.normal};
  }

  const ContactShape& a_;
  const Polygon& polygon_;
  const RelativePath& path_;
  const Clearance clearance_;
  const double deep_;  // a vertex at this distance from B or nearer is deep
  std::size_t queries_ = 0;
};

}  // namespace

VertexEvents vertex_events(const ContactShape& a, const ContactShape& b, const RelativePath& path,
                           const Clearance& clearance) {
  Search search(a, b.polygon, path, clearance);
  VertexEvents result;
  for (Index vertex : search.find_candidates()) {
    ++result.cost.vertices;
    if (const auto event = search.find_event(vertex)) result.events.push_back(*event);
  }
  result.cost.queries = search.queries();
  return result;
}

}  // namespace stokesbook
