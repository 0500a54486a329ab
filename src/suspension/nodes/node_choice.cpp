// Chooses the nodes with which a solve begins, for shapes, their softest modes, and gaps (chapter
// 12, section "Nodes"). Near a gap, densities decay at a rate that follows from the limit points of
// reflections between the circles of curvature (chapter 06, section "Two circles that nearly
// touch"). The rate determines the number of equidistant nodes, or of graded nodes (06.18),
// N = ln(10^5 / T) / r with the tolerance T and the rate r.
#include "suspension/nodes/node_choice.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

#include "suspension/bodies/components.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

constexpr double period = 2.0 * std::numbers::pi;

// Factor of alpha e^{-alpha n} in the error: the largest one that was measured on pairs of circles,
// ellipses and stars.
constexpr double error_factor = 150.0;

// Curvature -s (x' x x'') / |x'|^3, positive on convex parts of bodies.
double signed_curvature(const SmoothCurve& curve, double t) {
  const TrigonometricPolynomial::Jet jet = curve.at(t);
  return -curve.nodes.sign() * cross(jet.first, jet.second) / std::pow(std::abs(jet.first), 3);
}

// alpha = asinh(c kappa) / (kappa |x'|), which tends to c / |x'| on a straight piece.
double decay_at(const SmoothCurve& curve, double t, double c) {
  const double kappa = signed_curvature(curve, t);
  const double depth = std::abs(c * kappa) < 1e-8 ? c : std::asinh(c * kappa) / kappa;
  return depth / std::abs(curve.at(t).first);
}

// Strengths b of the grading (06.18) that are tried.
const std::vector<double> strengths{0.5, 1.0, 2.0, 4.0};

int multiple_of_16(double n) {
  return 16 * static_cast<int>(std::ceil(n / 16.0));
}

void require_positive(double value, const std::string& what) {
  if (!(value > 0.0)) {
    throw std::invalid_argument(what + " must be positive, got " + short_number(value));
  }
}

// Returns clusters at the gaps that the nodes of the shape do not resolve. The narrowest gaps come
// first, because the nodes around their clusters are dense enough for wider gaps nearby: those
// whose distance from the cluster is less than their depth.
std::vector<Cluster> clusters_for(std::vector<GapRequirement> gaps, double resolved_depth) {
  std::ranges::sort(gaps, {},
                    [](const GapRequirement& gap) { return std::pair(gap.depth, gap.parameter); });
  std::vector<Cluster> clusters;
  for (const GapRequirement& gap : gaps) {
    if (gap.depth >= resolved_depth) break;
    const bool is_served = std::ranges::any_of(clusters, [&](const Cluster& cluster) {
      return std::abs(std::remainder(cluster.parameter - gap.parameter, period)) < gap.depth;
    });
    if (!is_served) clusters.push_back({gap.parameter, gap.depth});
  }
  return clusters;
}

// Returns the middles between neighbouring clusters, where nodes are sparsest.
std::vector<double> middles(const std::vector<Cluster>& clusters) {
  std::vector<double> places, result;
  for (const Cluster& cluster : clusters) {
    places.push_back(cluster.parameter - period * std::floor(cluster.parameter / period));
  }
  std::ranges::sort(places);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double next = k + 1 < places.size() ? places[k + 1] : places.front() + period;
    result.push_back(0.5 * (places[k] + next));
  }
  return result;
}

// Returns for each strength the least graded_depth() of all gaps, and of a shape whose
// singularities have the same depth all around the curve. For the shape, only the middles between
// clusters are tried: the least depth found there is at most 4 % too large.
std::vector<double> least_rates(const std::vector<Cluster>& clusters,
                                const std::vector<GapRequirement>& gaps, double shape_depth) {
  std::vector<double> rates(strengths.size(), shape_depth);
  const auto include = [&](double parameter, double depth) {
    const std::vector<double> depths = graded_depths(clusters, strengths, parameter, depth);
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = std::min(rates[i], depths[i]);
  };
  for (const double parameter : middles(clusters)) include(parameter, shape_depth);
  for (const auto& [parameter, depth] : gaps) {
    if (std::isfinite(depth)) include(parameter, depth);
  }
  return rates;
}

DensityDecay decay_at_gap(const Gap& gap, const Configuration& configuration,
                          const Discretisation& discretisation) {
  return density_decay(smooth_curve(*discretisation[gap.a], configuration[gap.a]),
                       smooth_curve(*discretisation[gap.b], configuration[gap.b]), gap.points);
}

// Returns the requirements of all open gaps on each component.
std::vector<std::vector<GapRequirement>> gap_requirements(const Discretisation& discretisation,
                                                          const Configuration& configuration,
                                                          const std::vector<Gap>& gaps) {
  std::vector<std::vector<GapRequirement>> requirements(discretisation.size());
  for (const Gap& gap : gaps) {
    if (gap.points.gap <= 0.0) continue;
    const DensityDecay decay = decay_at_gap(gap, configuration, discretisation);
    requirements[gap.a].push_back({gap.points.parameter_a, decay.a});
    requirements[gap.b].push_back({gap.points.parameter_b, decay.b});
  }
  return requirements;
}

}  // namespace

int nodes_for_shape(const Shape& shape, Side side, double tolerance, int at_least) {
  for (int n = 16 * ((at_least + 15) / 16); n <= most_nodes_for_shape;
       n += std::max(16, n / 4 / 16 * 16)) {
    if (shape_residual(shape, sample(shape, n, side)) <= tolerance) return n;
  }
  return 0;
}

int nodes_for_softest_mode(DiscretisationCache& cache, const Shape& shape, ComponentKind kind,
                           int n_nodes) {
  // delta ||B^{-1}|| <= 1/10 (chapter 12); more nodes aim at half of this bound.
  constexpr double allowed = 0.1, aimed_at = 0.05;
  while (true) {
    const auto discretised = cache.get(shape, {n_nodes, {}}, kind);
    const double error = softest_mode_error(*discretised);
    if (!(error > allowed)) return n_nodes;
    // With few nodes the mode appears stiffer than it is: the number that follows from them is
    // tested again.
    const double residual = discretised->shape_residual * aimed_at / error;
    const Side side = discretised->curve.side;
    int more = nodes_for_shape(shape, side, residual, n_nodes + 2);
    if (more == 0 || more > most_nodes_of_a_component) return n_nodes;
    // All bodies of this shape will have this number of nodes, so that the search for a slightly
    // smaller number pays.
    const auto suffice = [&](int n) {
      return n > n_nodes && shape_residual(shape, sample(shape, n, side)) <= residual;
    };
    while (suffice(more - 4)) more -= 4;
    n_nodes = more;
  }
}

std::string unresolved_shape(const Shape& shape, double tolerance) {
  // The trigonometric polynomial through points at uneven distances is not smooth.
  const bool has_points = std::holds_alternative<NodalCurve>(shape);
  return "even " + std::to_string(most_nodes_for_shape) +
         " nodes do not resolve its shape to solver.tolerance = " + short_number(tolerance) +
         (has_points
              ? ": space its points evenly along the curve, smooth it, or raise the tolerance"
              : ": smooth the curve or raise the tolerance");
}

int own_nodes(const Shape& shape, int n_nodes, Side side, double tolerance,
              const std::string& name) {
  if (n_nodes != automatic_nodes) return n_nodes;
  const int nodes = nodes_for_shape(shape, side, tolerance, 16);
  if (nodes == 0) throw SolverError(name + ": " + unresolved_shape(shape, tolerance));
  return nodes;
}

DensityDecay density_decay(const SmoothCurve& a, const SmoothCurve& b,
                           const ClosestPoints& points) {
  const double g = points.gap;
  const double k1 = signed_curvature(a, points.parameter_a);
  const double k2 = signed_curvature(b, points.parameter_b);
  const double sum = k1 + k2 + g * k1 * k2;
  // c^2 of the circles of curvature at the closest points.
  const double c2 = g * (2.0 + g * k1) * (2.0 + g * k2) * (k1 + k2 + sum) / (4.0 * sum * sum);
  if (!(c2 > 0.0) || !std::isfinite(c2)) {
    // There are no limit points where reflections accumulate: the gap requires no nodes.
    const double none = std::numeric_limits<double>::infinity();
    return {none, none};
  }
  const double c = std::sqrt(c2);
  return {decay_at(a, points.parameter_a, c), decay_at(b, points.parameter_b, c)};
}

GapResolution gap_resolution(const Gap& gap, const Configuration& configuration,
                             const Discretisation& discretisation) {
  const DensityDecay decay = decay_at_gap(gap, configuration, discretisation);
  const auto error = [&](std::size_t component, double parameter, double depth) {
    if (std::isinf(depth)) return 0.0;
    // 150 alpha e^{-alpha n}, with the depth alpha that the grading gives.
    const auto& [n_nodes, grading] = discretisation[component]->resolution;
    const double alpha = graded_depth(grading, parameter, depth);
    return error_factor * alpha * std::exp(-alpha * static_cast<double>(n_nodes));
  };
  return {decay, std::max(error(gap.a, gap.points.parameter_a, decay.a),
                          error(gap.b, gap.points.parameter_b, decay.b))};
}

int nodes_for_decay(double decay, double tolerance) {
  if (std::isinf(decay)) return 0;
  // Recommended nodes meet the tolerance divided by this margin, because the densities of loaded
  // bodies can be larger than velocities. The error estimate of the solution decides in the end.
  constexpr double margin = 10.0;
  // Solves 150 alpha e^{-alpha n} = tolerance / margin for n.
  const double needed = std::log(margin * error_factor * decay / tolerance) / decay;
  // For gaps of the size of rounding errors the formula gives huge numbers, or negative ones, since
  // it underestimates the error of few nodes. The result is limited to at least 0 and at most 1e9.
  return multiple_of_16(std::clamp(needed, 0.0, 1e9));
}

Resolution nodes_for_gaps(const std::vector<GapRequirement>& gaps, int shape_nodes,
                          double tolerance) {
  require_positive(shape_nodes, "the nodes of a shape");
  require_positive(tolerance, "a tolerance");
  int even = multiple_of_16(shape_nodes);
  for (const GapRequirement& gap : gaps) {
    require_positive(gap.depth, "the depth of a gap");
    even = std::max(even, nodes_for_decay(gap.depth, tolerance));
  }
  // Nodes are graded only if equidistant nodes would exceed them by more than this factor: graded
  // nodes belong to one configuration, and all data of the shape are computed for it anew.
  constexpr double worthwhile = 1.3;
  const Resolution equidistant{even, {}};
  if (even <= worthwhile * shape_nodes) return equidistant;  // at least as many would be graded
  // Factor of e^{-rate n} in the error: above the largest one that was measured on pairs of
  // circles.
  constexpr double graded_error_factor = 1e5;
  const double digits = std::log(graded_error_factor / tolerance);
  // Singularities at this depth require shape_nodes equidistant nodes.
  const double shape_depth = digits / shape_nodes;
  const std::vector<Cluster> clusters = clusters_for(gaps, shape_depth);
  const std::vector<double> rates = least_rates(clusters, gaps, shape_depth);
  // N = ln(10^5 / tolerance) / r for each strength, with the least rate r.
  Resolution graded{std::numeric_limits<int>::max(), {}};
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    const int n = multiple_of_16(digits / rates[i]);
    if (n < graded.n_nodes) graded = {n, {clusters, strengths[i]}};
  }
  return even > worthwhile * graded.n_nodes ? graded : equidistant;
}

int rounded_nodes(double nodes) {
  const int least = static_cast<int>(std::ceil(std::clamp(nodes, 1.0, 1e9)));
  // An eighth of the largest power of two that does not exceed the number.
  const int unit = std::max(16, static_cast<int>(std::bit_floor(static_cast<unsigned>(least))) / 8);
  return unit * ((least + unit - 1) / unit);
}

std::vector<int> recommended_nodes(const Discretisation& discretisation, double tolerance,
                                   const Configuration& configuration,
                                   const std::vector<Gap>& gaps) {
  const auto requirements = gap_requirements(discretisation, configuration, gaps);
  std::map<const DiscretisedShape*, int> shape_nodes;
  std::vector<int> nodes;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    const DiscretisedShape& discretised = *discretisation[k];
    const auto [entry, is_new] = shape_nodes.try_emplace(&discretised);
    if (is_new) {
      entry->second = nodes_for_shape(discretised.shape, discretised.curve.side, tolerance, 16);
    }
    nodes.push_back(entry->second);
    for (const GapRequirement& gap : requirements[k]) {
      nodes[k] = std::max(nodes[k], nodes_for_decay(gap.depth, tolerance));
    }
  }
  return nodes;
}

Resolutions first_resolutions(const Scene& scene, const Discretisation& discretisation,
                              const Configuration& configuration, const std::vector<Gap>& gaps) {
  const auto requirements = gap_requirements(discretisation, configuration, gaps);
  Resolutions resolutions = resolutions_of(discretisation);
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    if (!component_of(scene, k).has_automatic_nodes() || requirements[k].empty()) continue;
    const int own = resolutions[k].n_nodes;
    resolutions[k] = nodes_for_gaps(requirements[k], own, scene.solver.tolerance);
    if (resolutions[k].n_nodes > own) {
      resolutions[k].n_nodes = rounded_nodes(resolutions[k].n_nodes);
    }
  }
  return resolutions;
}

}  // namespace stokesbook
