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

// Factor of e^{-rate n}: more than the largest measured on pairs of circles.
constexpr double graded_error_factor = 1e5;

// Of crowding, tried in turn.
const std::vector<double> strengths{0.5, 1.0, 2.0, 4.0};

// Crowding must save this many times the nodes that the shape asks for.
constexpr double worthwhile = 1.5;

int multiple_of_16(double n) {
  return 16 * static_cast<int>(std::ceil(n / 16.0));
}

void require_positive(double value, const std::string& what) {
  if (!(value > 0.0)) {
    throw std::invalid_argument(what + " must be positive, got " + std::to_string(value));
  }
}

// The narrowest gaps first: about their clusters nodes are dense enough for wider ones.
std::vector<Cluster> clusters_for(std::vector<GapDemand> gaps, double resolved_depth) {
  std::sort(gaps.begin(), gaps.end(), [](const GapDemand& a, const GapDemand& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.parameter < b.parameter;
  });
  std::vector<Cluster> clusters;
  for (const GapDemand& gap : gaps) {
    if (gap.depth >= resolved_depth) break;
    const bool served = std::any_of(clusters.begin(), clusters.end(), [&](const Cluster& cluster) {
      return std::abs(std::remainder(cluster.parameter - gap.parameter, period)) < gap.depth;
    });
    if (!served) clusters.push_back({gap.parameter, gap.depth});
  }
  return clusters;
}

// For each strength the least depth of all gaps, and of singularities of a shape at one depth all
// around.
std::vector<double> least_rates(const std::vector<Cluster>& clusters,
                                const std::vector<GapDemand>& gaps, double shape_depth) {
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

Resolution nodes_for_gaps(const std::vector<GapDemand>& gaps, int shape_nodes, double tolerance) {
  require_positive(shape_nodes, "the nodes of a shape");
  require_positive(tolerance, "a tolerance");
  int even = multiple_of_16(shape_nodes);
  for (const GapDemand& gap : gaps) {
    require_positive(gap.depth, "the depth of a gap");
    even = std::max(even, recommended_nodes(gap.depth, tolerance));
  }
  Resolution best{even, {}};
  if (even <= worthwhile * shape_nodes) return best;
  const double digits = std::log(graded_error_factor / tolerance);
  const double shape_depth = digits / shape_nodes;
  const std::vector<Cluster> clusters = clusters_for(gaps, shape_depth);
  const std::vector<double> rates = least_rates(clusters, gaps, shape_depth);
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    const int n = multiple_of_16(digits / rates[i]);
    if (n < best.n_nodes) best = {n, {clusters, strengths[i]}};
  }
  return best;
}

}  // namespace stokesbook
