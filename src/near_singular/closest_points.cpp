#include "near_singular/closest_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace stokesbook {

using Eigen::Index;

TrigonometricPolynomial::Jet SmoothCurve::at(double t) const {
  const TrigonometricPolynomial::Jet jet = (*reference)(t);
  const Complex turn = std::polar(1.0, orientation);
  return {position + turn * jet.value, turn * jet.first, turn * jet.second};
}

namespace {

using Jet = TrigonometricPolynomial::Jet;

struct NodePair {
  Index a, b;
  double distance;
};

double parameter_step(const Curve& curve) {
  return 2.0 * std::numbers::pi / static_cast<double>(curve.size());
}

// The nearest node of b to every node of a.
std::vector<NodePair> nearest_nodes(const Curve& a, const Curve& b) {
  std::vector<NodePair> pairs;
  for (Index i = 0; i < a.size(); ++i) {
    Index j = 0;
    const double distance2 = (b.x.array() - a.x[i]).abs2().minCoeff(&j);
    pairs.push_back({i, j, std::sqrt(distance2)});
  }
  return pairs;
}

// Unit normal out of the fluid.
Complex normal(const SmoothCurve& curve, const Jet& jet) {
  return -imaginary * curve.nodes.sign() * jet.first / std::abs(jet.first);
}

// Newton's step to a minimum; downhill where there is none near, and no longer than allowed.
double minimising_step(double slope, double curvature, double longest) {
  return slope == 0.0 ? 0.0 : std::clamp(-slope / std::abs(curvature), -longest, longest);
}

// A point of curve a and its foot, the nearest point of curve b.
struct Footing {
  double s, t;
  Jet a, b;
  double height;  // of the point over b, positive in b's fluid

  Complex across() const { return b.value - a.value; }
};

// Finds the foot that is nearest to a parameter t of b.
Footing find_footing(const SmoothCurve& a, const SmoothCurve& b, double s, double t) {
  const Jet at_a = a.at(s);
  const auto on_b = [&b](double parameter) { return b.at(parameter); };
  const Foot foot = find_foot(on_b, at_a.value, t, parameter_step(b.nodes));
  return {s, foot.parameter, at_a, foot.at, dot(foot.at.value - at_a.value, normal(b, foot.at))};
}

// Newton's step along a to the least height over b. Unlike the distance squared, the height is as
// regular for curves that touch or overlap as it is for distant ones.
double step_down(const SmoothCurve& a, const SmoothCurve& b, const Footing& at) {
  const Complex n = normal(b, at.b);
  const double along = dot(at.a.first, at.b.first);
  const double turn =
      b.nodes.sign() * cross(at.b.first, at.b.second) / std::pow(std::abs(at.b.first), 3);
  const double foot_speed = along / (std::norm(at.b.first) + dot(at.across(), at.b.second));
  return minimising_step(-dot(at.a.first, n), -dot(at.a.second, n) - turn * along * foot_speed,
                         parameter_step(a.nodes));
}

// Descends from a pair of parameters to the least height of a over b.
Footing least_height(const SmoothCurve& a, const SmoothCurve& b, double s, double t) {
  Footing at = find_footing(a, b, s, t);
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

// Nothing lies between the closest points: where they see each other through the fluid, so does all
// of either curve.
ClosestPoints measured(const SmoothCurve& a, const Footing& at) {
  const bool separate = at.height > 0.0 && dot(at.across(), normal(a, at.a)) < 0.0;
  const double distance = std::abs(at.across());
  return {separate ? distance : -distance, at.s, at.t, at.a.value, at.b.value};
}

}  // namespace

Foot find_foot(const Parametrisation& curve, Complex point, double guess, double longest) {
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
  const std::vector<NodePair> pairs = nearest_nodes(a.nodes, b.nodes);
  const auto nearer = [](const NodePair& p, const NodePair& q) { return p.distance < q.distance; };
  const double closest = std::min_element(pairs.begin(), pairs.end(), nearer)->distance;
  const double spacing = std::max(weights(a.nodes).maxCoeff(), weights(b.nodes).maxCoeff());
  std::optional<Footing> best;
  const auto count = pairs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool local_minimum = !nearer(pairs[(i + count - 1) % count], pairs[i]) &&
                               !nearer(pairs[(i + 1) % count], pairs[i]);
    if (!local_minimum || pairs[i].distance > closest + spacing) continue;
    const Footing refined =
        least_height(a, b, parameter_step(a.nodes) * static_cast<double>(pairs[i].a),
                     parameter_step(b.nodes) * static_cast<double>(pairs[i].b));
    if (!best || refined.height < best->height) best = refined;
  }
  return measured(a, *best);
}

ClosestPoints closest_points_near(const SmoothCurve& a, const SmoothCurve& b, double s, double t) {
  return measured(a, least_height(a, b, s, t));
}

}  // namespace stokesbook
