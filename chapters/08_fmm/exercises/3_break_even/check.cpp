// Check of exercise 08.3: counts by a table of all pairs, inequalities, and plans.
#include "chapters/check.hpp"

#include "fmm/fmm.hpp"
#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;

double operations(const Fmm& plan, int p);
Index least_nodes(double c, double q, int m);
double best_leaf(int p);
ComplexVector slow_places(Index n);

namespace {

Fmm plan_of(const ComplexVector& places, const FmmSettings& settings) {
  return Fmm({test::cloud(places, 1e-30)}, {}, settings);
}

// Pairs that are summed directly: those that no far list has.
double near_pairs(const Fmm& plan) {
  const std::vector<Box>& boxes = plan.sources().boxes;
  const auto n = static_cast<double>(plan.sources().size());
  double pairs = n * n;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    for (const Index source : plan.interactions().far[b]) {
      pairs -=
          static_cast<double>(boxes[b].size() * boxes[static_cast<std::size_t>(source)].size());
    }
  }
  return pairs;
}

void check_operations() {
  for (const Index n : {30, 1000, 3000}) {
    for (const int p : {6, 18}) {
      const Fmm plan = plan_of(test::points_in_a_square(n), {p, 40});
      const double p2 = p * p, pairs = near_pairs(plan),
                   boxes = static_cast<double>(plan.sources().boxes.size() - 1),
                   nodes = static_cast<double>(n);
      double far = 0.0, range_lengths = 0.0;
      for (const auto& list : plan.interactions().far) far += static_cast<double>(list.size());
      for (const auto& list : plan.interactions().near) {
        for (const Range range : list)
          range_lengths += static_cast<double>(range.last - range.first);
      }
      const double count = pairs + 0.5 * p2 * far + 0.5 * p2 * boxes + 3.0 * p * nodes;
      expect({.what = std::to_string(n) + " nodes, order " + std::to_string(p),
              .got = operations(plan, p),
              .expected = count,
              .tolerance = 1e-12,
              .mistakes = {{count - 0.25 * p2 * boxes, "expansions move up and down: p^2/4 each"},
                           {count - pairs + range_lengths,
                            "a range counts its nodes times those of the box"},
                           {count - 3.0 * p * nodes, "the nodes' 3p are missing"},
                           {count + 0.5 * p2, "the root has nowhere to move"}}});
    }
  }
}

void check_least_nodes() {
  for (const double c : {420.5, 900.25}) {
    for (const double q : {300.0, 5000.0}) {
      for (const int m : {1, 30}) {
        const auto least = [&](double of) { return std::floor(of) + 1.0; };
        expect({.what = "c = " + exercise::text(c) + ", q = " + exercise::text(q) +
                        ", m = " + std::to_string(m),
                .got = static_cast<double>(least_nodes(c, q, m)),
                .expected = least(c + q / m),
                .tolerance = 0.0,
                .mistakes = {{least(c), "the plan is not free"},
                             {least(c + q), "the plan is made once, for all applications"},
                             {least(c + q / m) - 1.0, "it has to take fewer operations"}}});
      }
    }
  }
}

void check_best_leaf() {
  for (const int p : {9, 18, 36}) {
    const double got = best_leaf(p);
    const auto count = [&](double s) { return 13.0 * s + 26.0 * p * p / s; };
    expect({.what = "order " + std::to_string(p),
            .got = got,
            .expected = p * std::sqrt(2.0),
            .tolerance = 1e-6,
            .mistakes = {{2.0 * p, "a conversion counts p^2/2"},
                         {count(p * std::sqrt(2.0)), "this is the count, not the leaf"}}});
  }
}

void check_slow_places() {
  for (const Index n : {400, 2000}) {
    const ComplexVector places = slow_places(n);
    const double share =
        near_pairs(plan_of(places, {18, 50})) / static_cast<double>(n) / static_cast<double>(n);
    if (places.size() == n && share >= 0.25) continue;
    const double extent = (places.array() - places[0]).abs().maxCoeff();
    throw exercise::Rejection{
        exercise::line("for", std::to_string(n) + " places") +
        exercise::line("got", exercise::text(share) + " of all pairs in near lists") +
        exercise::line("expected", "at least 0.25") +
        exercise::line("mistake", extent < 1e-3 ? "boxes are divided at any length"
                                  : places.imag().isZero()
                                      ? "leaves are small on a line too"
                                      : "leaves of 50 nodes have few near ones")};
  }
}

}  // namespace

int main() {
  return exercise::run({{.title = "the count",
                         .formula = "pairs + p^2/2 far + 2 p^2/4 (boxes - 1) + 3 p n",
                         .hint = "a pair of nodes is in a near list or in a far box, never in both",
                         .check = check_operations},
                        {.title = "break-even",
                         .formula = "n > c + q/m",
                         .hint = "divide the inequality by m n",
                         .check = check_least_nodes},
                        {.title = "the best leaf",
                         .formula = "s = p sqrt(26/13)",
                         .hint = "both terms are equal where their sum is least",
                         .check = check_best_leaf},
                        {.title = "places for which no tree helps",
                         .formula = "near pairs >= n^2/4",
                         .hint = "what does a box need that it can be divided?",
                         .check = check_slow_places}});
}
