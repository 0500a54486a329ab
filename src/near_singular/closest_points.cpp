// Finds the closest points of two curves: Newton's method for the minima of the height of one curve
// over the other, started wherever the height turns from falling to rising (chapter 06).
#include "near_singular/closest_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "near_singular/near_field.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

using Jet = TrigonometricPolynomial::Jet;

double parameter_step(const Curve& curve) {
  return 2.0 * std::numbers::pi / static_cast<double>(curve.size());
}

double distance_of_parameters(double s, double t) {
  return std::abs(std::remainder(s - t, 2.0 * std::numbers::pi));
}

// Returns the unit normal that points out of the fluid.
Complex normal(const SmoothCurve& curve, const Jet& jet) {
  return -imaginary * curve.nodes.sign() * jet.first / std::abs(jet.first);
}

// Returns Newton's step to a minimum, -slope / curvature. The modulus of the curvature turns a step
// to a maximum into a step downhill; no step is longer than `longest`.
double minimising_step(double slope, double curvature, double longest) {
  return slope == 0.0 ? 0.0 : std::clamp(-slope / std::abs(curvature), -longest, longest);
}

// A point of curve a, at the parameter s, and its foot on curve b, at the parameter t.
struct Footing {
  double s, t;
  Jet a, b;
  double height;  // signed distance of the point from b, positive on the side of b's fluid

  Complex across() const { return b.value - a.value; }
};

// Finds the foot of the point a(s) on b by Newton's method, which starts at the parameter t.
Footing find_footing(const SmoothCurve& a, const SmoothCurve& b, double s, double t) {
  const Jet at_a = a.at(s);
  const auto on_b = [&b](double parameter) { return b.at(parameter); };
  const Foot foot = find_foot(on_b, at_a.value, t, parameter_step(b.nodes));
  return {s, foot.parameter, at_a, foot.at, dot(foot.at.value - at_a.value, normal(b, foot.at))};
}

// Finds the foot of the point a(s) on b by Newton's method, which starts at the closest node of b.
Footing find_footing(const SmoothCurve& a, const SmoothCurve& b, double s) {
  const Index closest = nearest_node(b.nodes, a.at(s).value);
  return find_footing(a, b, s, b.parameter(closest));
}

// Finds the feet on b of points along a, four points per node of a. Points that cannot be
// neighbours of the closest point get no foot. One point per node is too few: a curve may have only
// as many nodes as its shape requires, and two minima of the height may lie between two nodes.
std::vector<std::optional<Footing>> near_footings(const SmoothCurve& a, const SmoothCurve& b) {
  constexpr int points_a_node = 4;
  const Index count = a.nodes.size();
  const double along_a = weights(a.nodes).maxCoeff(), along_b = weights(b.nodes).maxCoeff();
  // Lower bounds of the nodes' distances from b: a point of b is at most half a spacing away from a
  // node of b. A node next to the closest point has a bound of at most `farthest`. For such nodes
  // the exact height then replaces the bound.
  Eigen::ArrayXd height(count);
  for (Index i = 0; i < count; ++i) {
    height[i] = std::sqrt((b.nodes.x.array() - a.nodes.x[i]).abs2().minCoeff()) - 0.5 * along_b;
  }
  const double farthest = height.minCoeff() + 0.5 * (along_a + along_b);
  std::vector<std::optional<Footing>> of_nodes(static_cast<std::size_t>(count));
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < count; ++i) {
    if (height[i] > farthest) continue;
    const Footing own = find_footing(a, b, a.parameter(i));
    of_nodes[static_cast<std::size_t>(i)] = own;
    height[i] = own.height;
    least = std::min(least, own.height);
  }
  // Between two nodes the height changes by at most the arclength, so that it is at least
  // (low + high - along_a) / 2 there. The piece is near if this bound is not above `least`.
  const auto is_near = [&](Index i) {
    const auto [low, high] = std::minmax({height[i], height[(i + 1) % count]});
    return low <= least || 0.5 * (low + high - along_a) <= least;
  };
  std::vector<std::optional<Footing>> footings;
  for (Index i = 0; i < count; ++i) {
    const double from = a.parameter(i), length = std::remainder(a.parameter((i + 1) % count) - from,
                                                                2.0 * std::numbers::pi);
    footings.emplace_back();
    if (is_near(i) || is_near((i + count - 1) % count)) {
      footings.back() = of_nodes[static_cast<std::size_t>(i)];
    }
    for (int k = 1; k < points_a_node; ++k) {
      footings.emplace_back();
      if (is_near(i)) footings.back() = find_footing(a, b, from + k * length / points_a_node);
    }
  }
  return footings;
}

// Returns the derivative of the height over b with respect to the parameter s of a: -a'.n.
double slope(const SmoothCurve& b, const Footing& at) {
  return -dot(at.a.first, normal(b, at.b));
}

// Returns Newton's step along a to a minimum of the height over b. Unlike the squared distance, the
// height is as regular for curves that touch or overlap as for distant curves. Its second
// derivative is -a''.n - s kappa (a'.b') dt/ds, with the side s and the curvature kappa of b, where
// the foot moves by dt/ds = a'.b' / (|b'|^2 + (b - a).b'').
double step_down(const SmoothCurve& a, const SmoothCurve& b, const Footing& at) {
  const Complex n = normal(b, at.b);
  const double along = dot(at.a.first, at.b.first);
  const double turn =
      b.nodes.sign() * cross(at.b.first, at.b.second) / std::pow(std::abs(at.b.first), 3);
  const double foot_speed = along / (std::norm(at.b.first) + dot(at.across(), at.b.second));
  return minimising_step(slope(b, at), -dot(at.a.second, n) - turn * along * foot_speed,
                         parameter_step(a.nodes));
}

// Descends from a point and its foot to a local minimum of the height of a over b. A step after
// which the height is larger is halved.
Footing least_height(const SmoothCurve& a, const SmoothCurve& b, Footing at) {
  const double rounding = 1e-15 * (std::abs(at.a.value) + std::abs(at.b.value));
  double step = step_down(a, b, at);
  for (int evaluations = 0; evaluations < 60 && std::abs(step) > 1e-14; ++evaluations) {
    const Footing next = find_footing(a, b, at.s + step, at.t);
    if (next.height <= at.height + rounding) {
      at = next;
      step = step_down(a, b, at);
    } else {
      step *= 0.5;
    }
  }
  return at;
}

// Returns the closest points with the gap between them. No other part of the curves lies between
// the closest points. Therefore the curves are separate if each of the two points is on the fluid's
// side of the other curve; else they overlap, and the gap is negative.
ClosestPoints measured(const SmoothCurve& a, const Footing& at) {
  const bool separate = at.height > 0.0 && dot(at.across(), normal(a, at.a)) < 0.0;
  const double distance = std::abs(at.across());
  return {separate ? distance : -distance, at.s, at.t, at.a.value, at.b.value};
}

}  // namespace

SmoothCurve translated(SmoothCurve curve, Complex vector) {
  curve.nodes.x.array() += vector;
  curve.position += vector;
  return curve;
}

double SmoothCurve::parameter(Index node) const {
  return parameters.empty() ? parameter_step(nodes) * static_cast<double>(node)
                            : parameters[static_cast<std::size_t>(node)].t;
}

Jet SmoothCurve::at(double t) const {
  const Jet jet = (*shape)(t);
  const Complex turn = std::polar(1.0, orientation);
  return {position + turn * jet.value, turn * jet.first, turn * jet.second};
}

Foot find_foot(const Parametrisation& curve, Complex point, double guess, double longest) {
  // Slope and curvature are the derivatives of |x(t) - z|^2 / 2.
  Foot foot{guess, curve(guess)};
  for (int iteration = 0; iteration < 30; ++iteration) {
    const auto& [value, first, second] = foot.at;
    const double curvature = std::norm(first) + dot(value - point, second);
    const double step = minimising_step(dot(value - point, first), curvature, longest);
    foot.parameter += step;
    foot.at = curve(foot.parameter);
    if (std::abs(step) < 1e-14) break;
  }
  return foot;
}

ClosestPoints closest_points(const SmoothCurve& a, const SmoothCurve& b) {
  const std::vector<std::optional<Footing>> footings = near_footings(a, b);
  const auto falls = [&](const auto& at) { return !at || slope(b, *at) <= 0.0; };
  const auto rises = [&](const auto& at) { return !at || slope(b, *at) >= 0.0; };
  const auto height = [](const auto& at) {
    return at ? at->height : std::numeric_limits<double>::infinity();
  };
  Footing lowest = **std::ranges::min_element(footings, {}, height);
  const auto descend = [&](const std::optional<Footing>& start) {
    if (!start) return;
    const Footing found = least_height(a, b, *start);
    if (found.height < lowest.height) lowest = found;
  };
  // If the height falls at one point and rises at the next, then there is a minimum between them.
  // There may be two minima if the feet are on different parts of b: descend from both points. A
  // point without a foot may fall or rise.
  for (std::size_t i = 0; i < footings.size(); ++i) {
    const auto &own = footings[i], &next = footings[(i + 1) % footings.size()];
    if (!falls(own) || !rises(next)) continue;
    const bool one_part =
        own && next && distance_of_parameters(own->t, next->t) < parameter_step(b.nodes);
    descend(own);
    if (!one_part) descend(next);
  }
  return measured(a, lowest);
}

ClosestPoints closest_points_near(const SmoothCurve& a, const SmoothCurve& b, double s, double t) {
  return measured(a, least_height(a, b, find_footing(a, b, s, t)));
}

}  // namespace stokesbook
