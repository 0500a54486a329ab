// Checks that a polygon is a simple closed curve around the origin: no repeated points, no reversal
// of direction, no two edges that meet (all pairs are tested), and winding number 1 or -1.
#include "scene/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "text/number_text.hpp"

namespace stokesbook::scene_text {

namespace {

struct Edge {
  Complex from, to;
  Complex step() const { return to - from; }
};

Edge edge(const ComplexVector& points, Eigen::Index k) {
  return {points[k], points[(k + 1) % points.size()]};
}

bool overlap(double a0, double a1, double b0, double b1) {
  return std::max(a0, a1) >= std::min(b0, b1) && std::max(b0, b1) >= std::min(a0, a1);
}

/// Returns whether the ends of b lie on opposite sides of the line through a, or on this line.
bool straddles(const Edge& a, const Edge& b) {
  return cross(a.step(), b.from - a.from) * cross(a.step(), b.to - a.from) <= 0.0;
}

/// Returns whether two edges have a common point. If both lie on one line, each straddles the
/// other, and only the comparison of their bounding boxes decides.
bool meet(const Edge& a, const Edge& b) {
  return overlap(a.from.real(), a.to.real(), b.from.real(), b.to.real()) &&
         overlap(a.from.imag(), a.to.imag(), b.from.imag(), b.to.imag()) && straddles(a, b) &&
         straddles(b, a);
}

std::optional<PolygonFault> find_fault_at_corner(const ComplexVector& points) {
  for (Eigen::Index k = 0; k < points.size(); ++k) {
    const Edge here = edge(points, k);
    const Edge next = edge(points, (k + 1) % points.size());
    if (here.from == here.to) {
      return PolygonFault{k, "is the same point as the next one (the last joins the first)"};
    }
    if (cross(here.step(), next.step()) == 0.0 && dot(here.step(), next.step()) < 0.0) {
      return PolygonFault{k, "the curve turns back on itself at the next point"};
    }
  }
  return std::nullopt;
}

std::optional<PolygonFault> find_crossing(const ComplexVector& points) {
  const Eigen::Index n = points.size();
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index other = k + 2; other < n; ++other) {
      const bool neighbours = k == 0 && other == n - 1;
      if (neighbours || !meet(edge(points, k), edge(points, other))) continue;
      return PolygonFault{k, "the edge to the next point meets the edge that starts at [" +
                                 short_number(points[other].real(), 6) + ", " +
                                 short_number(points[other].imag(), 6) + "]"};
    }
  }
  return std::nullopt;
}

/// Returns whether the winding number about the origin is 1 or -1. The angles from each point to
/// the next, seen from the origin, add up to 2 pi or -2 pi, or to 0 if the origin lies outside.
bool goes_around_origin(const ComplexVector& points) {
  double angle = 0.0;
  for (Eigen::Index k = 0; k < points.size(); ++k) {
    const auto [from, to] = edge(points, k);
    const double sine = cross(from, to);
    const double cosine = dot(from, to);
    if (sine == 0.0 && cosine <= 0.0) return false;  // the edge meets the origin
    angle += std::atan2(sine, cosine);
  }
  return std::abs(angle) > std::numbers::pi;  // 2 pi or 0, up to rounding
}

}  // namespace

std::optional<PolygonFault> find_fault(const ComplexVector& points) {
  constexpr Eigen::Index fewest = 8;
  if (points.size() < fewest) {
    return PolygonFault{std::nullopt, "must be at least " + std::to_string(fewest) +
                                          " points, not " + std::to_string(points.size())};
  }
  if (auto fault = find_fault_at_corner(points)) return fault;
  if (auto fault = find_crossing(points)) return fault;
  if (!goes_around_origin(points)) {
    return PolygonFault{std::nullopt, "the curve must go around the origin: loads act there"};
  }
  return std::nullopt;
}

}  // namespace stokesbook::scene_text
