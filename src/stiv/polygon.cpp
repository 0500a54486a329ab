// Finds the closest point of a polygon, and vertices in a region, by a binary tree of bounding
// rectangles over runs of eight edges (section "Results: what it costs" of chapter 10).
#include "stiv/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Returns the least rectangle that holds two rectangles.
Rectangle around_both(const Rectangle& p, const Rectangle& q) {
  return {{std::min(p.lower.real(), q.lower.real()), std::min(p.lower.imag(), q.lower.imag())},
          {std::max(p.upper.real(), q.upper.real()), std::max(p.upper.imag(), q.upper.imag())}};
}

Rectangle around(const Chord& chord) {
  return around_both({chord.from, chord.from}, {chord.to, chord.to});
}

bool meet(const Rectangle& p, const Rectangle& q) {
  return p.lower.real() <= q.upper.real() && q.lower.real() <= p.upper.real() &&
         p.lower.imag() <= q.upper.imag() && q.lower.imag() <= p.upper.imag();
}

double squared_distance(const Rectangle& rectangle, Complex z) {
  const double dx =
      std::max({rectangle.lower.real() - z.real(), 0.0, z.real() - rectangle.upper.real()});
  const double dy =
      std::max({rectangle.lower.imag() - z.imag(), 0.0, z.imag() - rectangle.upper.imag()});
  return dx * dx + dy * dy;
}

// Returns from + t (to - from), exactly `to` for t = 1.
Complex at_fraction(const Chord& chord, double t) {
  return t == 1.0 ? chord.to : chord.from + t * (chord.to - chord.from);
}

void require_valid_vertices(const ComplexVector& vertices) {
  require(vertices.size() >= 3, "a polygon requires three or more vertices, got ", vertices.size());
  for (Index i = 0; i < vertices.size(); ++i) {
    require(std::isfinite(vertices[i].real()) && std::isfinite(vertices[i].imag()), "vertex ", i,
            " of a polygon is not finite: ", vertices[i]);
  }
}

}  // namespace

Polygon::Polygon(const ComplexVector& vertices, Side side) : vertices_(vertices), side_(side) {
  require_valid_vertices(vertices);
  while (static_cast<Index>(leaf_count_) * EdgeRun::size < size()) leaf_count_ *= 2;
  // An empty box meets no other box, and its distance from any point is infinite.
  const Rectangle nothing{{infinity, infinity}, {-infinity, -infinity}};
  boxes_.assign(2 * leaf_count_, nothing);
  for (Index first = 0; first < size(); first += EdgeRun::size) {
    std::array<Chord, EdgeRun::size> edges;
    Rectangle& box = boxes_[leaf_count_ + runs_.size()];
    for (Index k = 0; k < EdgeRun::size; ++k) {
      Chord& own = edges[static_cast<std::size_t>(k)];
      own = edge(std::min(first + k, size() - 1));
      box = around_both(box, around(own));
    }
    runs_.emplace_back(edges);
  }
  for (std::size_t node = leaf_count_ - 1; node > 0; --node) {
    boxes_[node] = around_both(boxes_[2 * node], boxes_[2 * node + 1]);
  }
}

Chord Polygon::edge(Index number) const {
  return {vertices_[number], vertices_[number + 1 < size() ? number + 1 : 0]};
}

Index Polygon::first_edge(std::size_t leaf) const {
  return static_cast<Index>(leaf - leaf_count_) * EdgeRun::size;
}

// Searches the tree below a node, the nearer child first, and leaves out children that are farther
// than the nearest edge so far.
void Polygon::search(std::size_t node, Complex z, EdgeRun::Closest& nearest) const {
  if (node >= leaf_count_) {
    const auto [distance2, edge, fraction] = runs_[node - leaf_count_].closest(z);
    if (distance2 < nearest.squared_distance) {
      nearest = {distance2, std::min(first_edge(node) + edge, size() - 1), fraction};
    }
    return;
  }
  std::size_t near = 2 * node, far = near + 1;
  double to_near = squared_distance(boxes_[near], z), to_far = squared_distance(boxes_[far], z);
  if (to_far < to_near) {
    std::swap(near, far);
    std::swap(to_near, to_far);
  }
  if (to_near < nearest.squared_distance) search(near, z, nearest);
  if (to_far < nearest.squared_distance) search(far, z, nearest);
}

ClosestPoint Polygon::closest(Complex z, double at_most) const {
  EdgeRun::Closest nearest{at_most * at_most, -1, 0.0};
  if (squared_distance(boxes_[1], z) < nearest.squared_distance) search(1, z, nearest);
  if (nearest.edge < 0) return {infinity, {}, {}, -1};
  // perp() of an edge points to the inside, as vertices are counter-clockwise. The side is +1 if
  // the fluid lies inside, else -1, so that the normal points into the fluid.
  const double inward = static_cast<double>(side_);
  const auto edge_normal = [&](Index e) {
    const auto [from, to] = edge(e);
    const Complex along = to - from;
    return inward * perp(along) / std::abs(along);
  };
  const auto [distance2, e, fraction] = nearest;
  const Complex point = at_fraction(edge(e), fraction);
  if (fraction > 0.0 && fraction < 1.0) {
    const Complex normal = edge_normal(e);
    return {dot(z - vertices_[e], normal), point, normal, e};
  }
  // At a vertex the mean normal of its two edges gives the sign of the distance.
  const Index other = fraction == 0.0 ? (e > 0 ? e : size()) - 1 : (e + 1 < size() ? e + 1 : 0);
  const Complex mean = edge_normal(e) + edge_normal(other);
  const double distance = std::copysign(std::sqrt(distance2), dot(z - point, mean));
  const Complex normal = distance == 0.0 ? mean / std::abs(mean) : (z - point) / distance;
  return {distance, point, normal, e};
}

bool Polygon::is_clear_of(std::size_t node, const Chord& chord, double distance,
                          const Rectangle& surroundings) const {
  if (!meet(boxes_[node], surroundings)) return true;
  if (node < leaf_count_) {
    return is_clear_of(2 * node, chord, distance, surroundings) &&
           is_clear_of(2 * node + 1, chord, distance, surroundings);
  }
  return runs_[node - leaf_count_].is_clear_of(chord, distance);
}

bool Polygon::is_clear_of(const Chord& chord, double distance) const {
  return is_clear_of(1, chord, distance, widened(around(chord), distance));
}

void Polygon::collect(std::size_t node, const Condition& holds, std::vector<Index>& found) const {
  const bool is_empty = boxes_[node].lower.real() == infinity;
  if (is_empty || !holds(boxes_[node])) return;
  if (node < leaf_count_) {
    collect(2 * node, holds, found);
    collect(2 * node + 1, holds, found);
    return;
  }
  // The vertices of a leaf are the starts of its edges.
  const Index past_last = std::min(first_edge(node) + EdgeRun::size, size());
  for (Index i = first_edge(node); i < past_last; ++i) found.push_back(i);
}

std::vector<Index> Polygon::vertices_if(const Condition& holds) const {
  std::vector<Index> found;
  collect(1, holds, found);
  return found;
}

std::vector<Index> Polygon::vertices_in(const Rectangle& rectangle) const {
  std::vector<Index> found =
      vertices_if([&](const Rectangle& box) { return meet(box, rectangle); });
  std::erase_if(found, [&](Index i) { return !meet({vertices_[i], vertices_[i]}, rectangle); });
  return found;
}

}  // namespace stokesbook
