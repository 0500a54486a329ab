#include "stiv/vertex_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "stiv/near_pairs.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The search for one pair, one way.
class Search {
 public:
  Search(const ContactShape& a, const Polygon& polygon, const RelativePath& path,
         const Clearance& clearance)
      : a_(a), polygon_(polygon), path_(path), clearance_(clearance) {}

  // The vertices of A that may come near B: none where its bounding circle does not.
  std::vector<Index> candidates() {
    const double reach = clearance_.watch + path_.speed_bound(a_.radius);
    if (closest(path_.start().shift, reach + a_.radius).edge < 0) return {};
    return near_vertices(a_.polygon, polygon_, path_.start(), reach);
  }

  std::optional<VertexEvent> event(Index vertex) {
    const Complex x = a_.polygon.vertex(vertex), end = path_.end()(x);
    const Passage passage = follow(x, end);
    if (passage.is_too_deep) {
      const Touch& touch = *passage.touch;
      return complete(vertex, touch.time, touch.time, gap(touch, end), touch.at);
    }
    const ClosestPoint at = closest(end, clearance_.watch);
    if (at.edge < 0) return {};
    return complete(vertex, passage.touch ? passage.touch->time : 1.0, 1.0,
                    at.distance - clearance_.separation, at);
  }

  std::size_t queries() const { return queries_; }

 private:
  // A place of the path at the separation.
  struct Touch {
    double time;
    Complex z;
    ClosestPoint at;
  };

  struct Passage {
    bool is_too_deep;            // and ends beyond the line that it touched
    std::optional<Touch> touch;  // that, or else the one that still lasts at the end
  };

  // The gap to the touched line at the end.
  double gap(const Touch& touch, Complex end) const {
    return touch.at.distance - clearance_.separation + dot(touch.at.normal, end - touch.z);
  }

  // The path of a point X of A.
  Passage follow(Complex x, Complex end) {
    const double radius = std::abs(x), speed = path_.speed_bound(radius),
                 separation = clearance_.separation, tolerance = clearance_.tolerance;
    std::optional<Touch> touch;
    double tau = 0.0, previous = infinity, stretch = 1.0;
    //! [follow]
    while (tau < 1.0) {
      const Complex z = path_.at(tau)(x);
      const ClosestPoint at = closest(z, separation + tolerance + speed * (1.0 - tau));
      if (at.edge < 0) return {false, {}};
      const double excess = at.distance - separation;
      double step = excess / speed;  // no contact before that
      if (excess > tolerance) {
        touch.reset();
        stretch = step > 0.5 * previous ? 2.0 * stretch : 1.0;
        previous = step;
        const double longer = std::min(stretch * step, 1.0 - tau);
        if (longer > step && is_clear(x, tau, z, longer)) {
          step = longer;
        } else {
          stretch = 1.0;
        }
      } else {
        if (!touch) touch = Touch{tau, z, at};
        if (excess <= tolerance - clearance_.dip * separation) {
          for (const Touch& line : {*touch, Touch{tau, z, at}}) {
            if (gap(line, end) < -tolerance) return {true, line};
          }
        }
        step = 0.5 * std::max(at.distance, separation) / speed;
      }
      tau += std::max(step, std::numeric_limits<double>::epsilon());
    }
    //! [follow]
    return {false, touch};
  }

  // Whether the path from z at tau keeps the separation for a while.
  bool is_clear(Complex x, double tau, Complex z, double step) {
    ++queries_;
    return polygon_.is_clear_of({z, path_.at(tau + step)(x)},
                                clearance_.separation + path_.stray_bound(std::abs(x), step));
  }

  ClosestPoint closest(Complex z, double at_most) {
    ++queries_;
    return polygon_.closest(z, at_most);
  }

  VertexEvent complete(Index vertex, double time, double measured, double gap,
                       const ClosestPoint& at) const {
    return {vertex, at.edge, a_.weights[vertex], time, measured, gap, at.point, at.normal};
  }

  const ContactShape& a_;
  const Polygon& polygon_;
  const RelativePath& path_;
  const Clearance clearance_;
  std::size_t queries_ = 0;
};

}  // namespace

VertexEvents vertex_events(const ContactShape& a, const ContactShape& b, const RelativePath& path,
                           const Clearance& clearance) {
  Search search(a, b.polygon, path, clearance);
  VertexEvents result;
  for (Index vertex : search.candidates()) {
    ++result.cost.vertices;
    if (const auto event = search.event(vertex)) result.events.push_back(*event);
  }
  result.cost.queries = search.queries();
  return result;
}

}  // namespace stokesbook
