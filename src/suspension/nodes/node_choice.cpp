// Chooses numbers of nodes: for shapes, for their softest modes, and for the densities of a
// solution whose error estimate is too large (chapter 12, section "How fine").
#include "suspension/nodes/node_choice.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "double_layer/double_layer.hpp"
#include "suspension/bodies/components.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

// Shares of the tolerance: the error that one component may cause, and the error at which more
// nodes aim if a component causes a larger one.
constexpr double share_allowed = 0.1, share_aimed_at = 0.05;

// Least factor by which a number of nodes is increased.
constexpr double least_factor = 1.125;

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
    const auto do_as_well = [&](int n) {
      return n > n_nodes && shape_residual(shape, sample(shape, n, side)) <= residual;
    };
    while (do_as_well(more - 4)) more -= 4;
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

int rounded_nodes(double nodes) {
  const int least = static_cast<int>(std::ceil(std::clamp(nodes, 1.0, 1e9)));
  // An eighth of the largest power of two that does not exceed the number.
  const int unit = std::max(16, static_cast<int>(std::bit_floor(static_cast<unsigned>(least))) / 8);
  return unit * ((least + unit - 1) / unit);
}

Resolutions finer(Resolutions resolutions) {
  // A quarter more nodes, rounded to an even number.
  for (Resolution& resolution : resolutions) {
    resolution.n_nodes += std::max(16, 2 * ((resolution.n_nodes + 7) / 8));
  }
  return resolutions;
}

Resolutions coarser(Resolutions resolutions) {
  for (Resolution& resolution : resolutions) {
    resolution.n_nodes = rounded_nodes(0.5 * resolution.n_nodes);
  }
  return resolutions;
}

Resolutions finer_automatic(const Scene& scene, Resolutions before) {
  const Resolutions raised = finer(before);
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (component_of(scene, k).has_automatic_nodes()) before[k] = raised[k];
  }
  return before;
}

Resolutions finer_in_pairs(const Scene& scene, Resolutions before,
                           const std::vector<ComponentPair>& pairs) {
  std::set<std::size_t> components;
  for (const auto& [a, b] : pairs) components.insert({a, b});
  for (const std::size_t k : components) {
    int& nodes = before[k].n_nodes;
    if (!component_of(scene, k).has_automatic_nodes()) continue;
    nodes = std::min(rounded_nodes(1.5 * nodes), std::max(nodes, most_nodes_of_a_component));
  }
  return before;
}

double extrapolated_nodes(int n_nodes, double decay, double excess) {
  // n + ln(excess) / decay, at most 3n/2.
  const double nodes = n_nodes, orders = std::log(excess);
  return nodes + std::min(orders / std::max(decay, 1e-300), 0.5 * nodes);
}

Resolutions raised(const Scene& scene, Resolutions before, const std::vector<TailEstimate>& tails,
                   double error) {
  const double tolerance = scene.solver.tolerance;
  const double most = std::ranges::max(tails, {}, &TailEstimate::error).error;
  if (most < share_allowed * tolerance) return before;
  // The component with the largest tail is held responsible for the whole error, and the others in
  // proportion to their tails.
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double share = error * tails[k].error / most;
    if (!component_of(scene, k).has_automatic_nodes() || !(share > share_allowed * tolerance))
      continue;
    const double asked =
        extrapolated_nodes(before[k].n_nodes, tails[k].decay, share / (share_aimed_at * tolerance));
    before[k].n_nodes = rounded_nodes(std::max(asked, least_factor * before[k].n_nodes));
  }
  return before;
}

}  // namespace stokesbook
