// Chapter 08: the boxes that act on a leaf of the quadtree, and the operations of the whole sum.
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "fmm/interactions.hpp"
#include "interactive/numbers.hpp"

namespace {

using Eigen::Index;

stokesbook::ComplexVector nodes_of_ellipses(Index bodies) {
  stokesbook::ComplexVector nodes(16 * bodies);
  for (Index i = 0; i < nodes.size(); ++i) {
    const auto k = static_cast<double>(i / 16), all = static_cast<double>(bodies);
    const double radius = std::pow((k + 0.5) / all, 0.8), angle = 2.4 * k,
                 size = 0.7 * radius / std::sqrt(k + 1.0);
    const double t = std::numbers::pi * static_cast<double>(i % 16) / 8.0;
    const stokesbook::Complex own{size * std::cos(t), 0.5 * size * std::sin(t)};
    nodes[i] = std::polar(radius, angle) + std::polar(1.0, 3.0 * angle) * own;
  }
  return nodes;
}

Index count_near(const stokesbook::Interactions& lists, std::size_t box) {
  Index count = 0;
  for (const auto& [first, last] : lists.near[box]) count += last - first;
  return count;
}

interactive::Case fmm_case(double x, double y, Index bodies, Index leaf_size, Index p) {
  const stokesbook::ComplexVector nodes = nodes_of_ellipses(bodies);
  const stokesbook::Quadtree tree(nodes, {}, leaf_size);
  const stokesbook::Interactions lists = stokesbook::find_interactions(tree, tree, p * p / 2);
  Index nearest = 0;
  (nodes.array() - stokesbook::Complex(x, y)).abs2().minCoeff(&nearest);
  double operations = 0.0, far = 0.0;
  Index leaf = 0;
  for (std::size_t b = 0; b < tree.boxes.size(); ++b) {
    const stokesbook::Box& box = tree.boxes[b];
    operations += 0.5 * static_cast<double>(p * p * std::ssize(lists.far[b])) +
                  static_cast<double>(box.size() * count_near(lists, b));
    bool holds = false;
    for (Index i = box.first; i < box.last; ++i)
      holds = holds || tree.order[static_cast<std::size_t>(i)] == nearest;
    if (!holds) continue;
    far += static_cast<double>(lists.far[b].size());
    leaf = static_cast<Index>(b);  // boxes are level by level
  }
  const auto n = static_cast<double>(nodes.size());
  return {
      .settings = {{"x", x},
                   {"y", y},
                   {"bodies", static_cast<double>(bodies)},
                   {"leafSize", static_cast<double>(leaf_size)},
                   {"p", static_cast<double>(p)}},
      .numbers = {{"n", n},
                  {"own", static_cast<double>(tree.boxes[static_cast<std::size_t>(leaf)].size())},
                  {"near", static_cast<double>(count_near(lists, static_cast<std::size_t>(leaf)))},
                  {"far", far},
                  {"operations", operations},
                  {"share", operations / (n * n)}}};
}

}  // namespace

std::vector<interactive::Case> interactive::fmm() {
  return {fmm_case(0.3, 0.3, 100, 48, 8), fmm_case(-0.05, 0.1, 200, 16, 5),
          fmm_case(-0.9, -0.2, 60, 72, 20)};
}
