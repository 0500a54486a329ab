#include "stiv/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Index edges_in_leaf = 8;

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

// Where along a chord, from 0 to 1, it is closest to a point.
double closest_fraction(const Chord& chord, Complex z) {
  const Complex along = chord.to - chord.from;
  const double length2 = std::norm(along);
  return length2 > 0.0 ? std::clamp(dot(z - chord.from, along) / length2, 0.0, 1.0) : 0.0;
}

Complex at_fraction(const Chord& chord, double t) {
  return t == 1.0 ? chord.to : chord.from + t * (chord.to - chord.from);
}

double squared_distance(const Chord& chord, Complex z) {
  return std::norm(z - at_fraction(chord, closest_fraction(chord, z)));
}

bool cross_each_other(const Chord& p, const Chord& q) {
  const auto separates = [](const Chord& line, const Chord& ends) {
    const Complex along = line.to - line.from;
    return cross(along, ends.from - line.from) * cross(along, ends.to - line.from) < 0.0;
  };
  return separates(p, q) && separates(q, p);
}

double squared_distance(const Chord& p, const Chord& q) {
  if (cross_each_other(p, q)) return 0.0;
  return std::min({squared_distance(p, q.from), squared_distance(p, q.to),
                   squared_distance(q, p.from), squared_distance(q, p.to)});
}

}  // namespace

struct Polygon::Nearest {
  double squared_distance;
  Index edge;
  double fraction;
};

Polygon::Polygon(const ComplexVector& vertices, Side side) : vertices_(vertices), side_(side) {
  if (vertices.size() < 3 || !vertices.allFinite()) {
    throw std::invalid_argument("a polygon needs three or more finite vertices, got " +
                                std::to_string(vertices.size()));
  }
  while (static_cast<Index>(leaf_count_) * edges_in_leaf < size()) leaf_count_ *= 2;
  // What holds nothing meets nothing and is infinitely far.
  const Rectangle nothing{{infinity, infinity}, {-infinity, -infinity}};
  boxes_.assign(2 * leaf_count_, nothing);
  for (std::size_t leaf = leaf_count_; leaf < 2 * leaf_count_; ++leaf) {
    for (Index e = first_edge(leaf); e < past_last_edge(leaf); ++e) {
      boxes_[leaf] = around_both(boxes_[leaf], around({vertices_[e], end_of(e)}));
    }
  }
  for (std::size_t node = leaf_count_ - 1; node > 0; --node) {
    boxes_[node] = around_both(boxes_[2 * node], boxes_[2 * node + 1]);
  }
}

Complex Polygon::end_of(Index edge) const {
  return vertices_[edge + 1 < size() ? edge + 1 : 0];
}

Index Polygon::first_edge(std::size_t node) const {
  return std::min(static_cast<Index>(node - leaf_count_) * edges_in_leaf, size());
}

Index Polygon::past_last_edge(std::size_t node) const {
  return std::min(first_edge(node) + edges_in_leaf, size());
}

void Polygon::search(std::size_t node, Complex z, Nearest& nearest) const {
  if (node >= leaf_count_) {
    for (Index e = first_edge(node); e < past_last_edge(node); ++e) {
      const Chord edge{vertices_[e], end_of(e)};
      const double fraction = closest_fraction(edge, z);
      const double distance2 = std::norm(z - at_fraction(edge, fraction));
      if (distance2 < nearest.squared_distance) nearest = {distance2, e, fraction};
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
  Nearest nearest{at_most * at_most, -1, 0.0};
  if (squared_distance(boxes_[1], z) < nearest.squared_distance) search(1, z, nearest);
  if (nearest.edge < 0) return {infinity, {}, {}, -1};
  const double inward = static_cast<double>(side_);  // of the fluid, where it is within
  const auto edge_normal = [&](Index e) {
    const Complex along = end_of(e) - vertices_[e];
    return inward * perp(along) / std::abs(along);
  };
  const auto [distance2, e, fraction] = nearest;
  const Complex point = at_fraction({vertices_[e], end_of(e)}, fraction);
  if (fraction > 0.0 && fraction < 1.0) {
    const Complex normal = edge_normal(e);
    return {dot(z - vertices_[e], normal), point, normal, e};
  }
  // At a vertex the mean normal of its edges tells the sides apart.
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
  for (Index e = first_edge(node); e < past_last_edge(node); ++e) {
    if (squared_distance(chord, {vertices_[e], end_of(e)}) <= distance * distance) return false;
  }
  return true;
}

bool Polygon::is_clear_of(const Chord& chord, double distance) const {
  return is_clear_of(1, chord, distance, widened(around(chord), distance));
}

void Polygon::collect(std::size_t node, const Rectangle& rectangle,
                      std::vector<Index>& found) const {
  if (!meet(boxes_[node], rectangle)) return;
  if (node < leaf_count_) {
    collect(2 * node, rectangle, found);
    collect(2 * node + 1, rectangle, found);
    return;
  }
  // The vertices of a leaf are those where its edges start.
  for (Index e = first_edge(node); e < past_last_edge(node); ++e) {
    if (meet({vertices_[e], vertices_[e]}, rectangle)) found.push_back(e);
  }
}

std::vector<Index> Polygon::vertices_in(const Rectangle& rectangle) const {
  std::vector<Index> found;
  collect(1, rectangle, found);
  return found;
}

}  // namespace stokesbook
