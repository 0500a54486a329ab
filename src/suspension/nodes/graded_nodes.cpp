// Chooses the nodes of a component for its shape and its gaps: equidistant nodes, or graded nodes
// (01.11), whose number N = ln(10^5 / T) / r follows from the tolerance T and the rate r
// (chapter 03, section "Two circles that nearly touch").
#include "suspension/nodes/graded_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "suspension/nodes/density_decay.hpp"

namespace stokesbook {

namespace {

constexpr double period = 2.0 * std::numbers::pi;

// Factor of e^{-rate n} in the error: above the largest one that was measured on pairs of circles.
constexpr double graded_error_factor = 1e5;

// Strengths b of the grading (01.11) that are tried.
const std::vector<double> strengths{0.5, 1.0, 2.0, 4.0};

// Nodes are graded only if equidistant nodes would exceed the nodes of the shape by more than this
// factor.
constexpr double worthwhile = 1.5;

int multiple_of_16(double n) {
  return 16 * static_cast<int>(std::ceil(n / 16.0));
}

void require_positive(double value, const std::string& what) {
  if (!(value > 0.0)) {
    throw std::invalid_argument(what + " must be positive, got " + std::to_string(value));
  }
}

// Returns clusters at the gaps that the nodes of the shape do not resolve. The narrowest gaps come
// first, because the nodes around their clusters are dense enough for wider gaps nearby.
std::vector<Cluster> clusters_for(std::vector<GapRequirement> gaps, double resolved_depth) {
  std::sort(gaps.begin(), gaps.end(), [](const GapRequirement& a, const GapRequirement& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.parameter < b.parameter;
  });
  std::vector<Cluster> clusters;
  for (const GapRequirement& gap : gaps) {
    if (gap.depth >= resolved_depth) break;
    const bool served = std::any_of(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
      return std::abs(std::remainder(cluster.parameter - gap.parameter, period)) < gap.depth;
    });
    if (!served) clusters.push_back({gap.parameter, gap.depth});
  }
  return clusters;
}

// Returns for each strength the least graded_depth() of all gaps, and of a shape whose
// singularities have the same depth all around the curve.
std::vector<double> least_rates(const std::vector<Cluster>& clusters,
                                const std::vector<GapRequirement>& gaps, double shape_depth) {
  constexpr int places = 64;
  std::vector<double> rates(strengths.size(), shape_depth);
  const auto look_at = [&](double parameter, double depth) {
    const std::vector<double> depths = graded_depths(clusters, strengths, parameter, depth);
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = std::min(rates[i], depths[i]);
  };
  for (int k = 0; k < places; ++k) look_at(period * k / places, shape_depth);
  for (const auto& [parameter, depth] : gaps) {
    if (std::isfinite(depth)) look_at(parameter, depth);
  }
  return rates;
}

}  // namespace

Resolution nodes_for_gaps(const std::vector<GapRequirement>& gaps, int shape_nodes,
                          double tolerance) {
  require_positive(shape_nodes, "the nodes of a shape");
  require_positive(tolerance, "a tolerance");
  int even = multiple_of_16(shape_nodes);
  for (const GapRequirement& gap : gaps) {
    require_positive(gap.depth, "the depth of a gap");
    even = std::max(even, recommended_nodes(gap.depth, tolerance));
  }
  Resolution best{even, {}};
  if (even <= worthwhile * shape_nodes) return best;
  const double digits = std::log(graded_error_factor / tolerance);
  // Singularities at this depth require shape_nodes equidistant nodes.
  const double shape_depth = digits / shape_nodes;
  const std::vector<Cluster> clusters = clusters_for(gaps, shape_depth);
  const std::vector<double> rates = least_rates(clusters, gaps, shape_depth);
  // N = ln(10^5 / tolerance) / r for each strength, with the least rate r.
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    const int n = multiple_of_16(digits / rates[i]);
    if (n < best.n_nodes) best = {n, {clusters, strengths[i]}};
  }
  return best;
}

}  // namespace stokesbook
