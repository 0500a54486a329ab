// Compares a sum in a cell with the same sum without images, by counted operations and by seconds.
#include <chrono>
#include <cmath>

#include "experiments.hpp"
#include "periodic/far_operator.hpp"
#include "support/point_sets.hpp"

namespace stokesbook::verification::periodic {

using namespace study;
using Eigen::Index;

namespace {

// Returns side x side ellipses of 64 nodes, which fill their sheared cell.
std::vector<Curve> bodies(int side) {
  return test::ellipses(side, 64);
}

Lattice lattice_about(int side) {
  return {2.5 * side, {0.9 * side, 2.5 * side}};
}

// Counts pairs and conversions in units of kernel evaluations, as chapter 08 does.
double operations(const Fmm& plan, int order) {
  double sum = 0.0;
  for (const Interactions& image : plan.all_interactions()) {
    for (std::size_t b = 0; b < image.far.size(); ++b) {
      sum += 0.5 * order * order * static_cast<double>(image.far[b].size());
      for (const Range range : image.near[b]) {
        sum += static_cast<double>((range.last - range.first) * plan.targets().boxes[b].size());
      }
    }
  }
  return sum;
}

double seconds_of(const Fmm& plan, const ComplexVector& density) {
  using Clock = std::chrono::steady_clock;
  FmmWorkspace work = plan.workspace();
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 3; ++repeat) {
    const Clock::time_point start = Clock::now();
    plan.velocity(density, work);
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return least;
}

enum class Counted { operations, seconds };

// Returns the cost in a cell over the cost without images.
Measure ratios(Counted counted, Index least_leaf = 0) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int side = 4; side <= (size == Size::full ? 64 : 16); side *= 2) {
      FmmSettings settings = FmmSettings::for_tolerance(1e-6);
      settings.leaf_size = std::max(settings.leaf_size, least_leaf);
      const std::vector<Curve> curves = bodies(side);
      const Fmm open(curves, {}, settings),
          closed(curves, {}, settings, images_in(lattice_about(side)));
      const auto cost = [&](const Fmm& plan) {
        return counted == Counted::operations
                   ? operations(plan, settings.order)
                   : seconds_of(plan, test::random_vector(open.sources().size(), 3));
      };
      measurements.push_back(
          {.x = static_cast<double>(side * side), .error = cost(closed) / cost(open)});
    }
    return measurements;
  };
}

}  // namespace

Experiment cost() {
  return {.key = "cost",
          .title = "Operations of a sum in a cell, over those of the same sum without images",
          .x = "bodies n",
          .error = "ratio of operations",
          .lines = {
              {.key = "tree",
               .label = "near images in the tree",
               .measure = ratios(Counted::operations),
               .claim = Claim{.id = "14_22",
                              .statement = "A sum in a cell takes at most two and a half "
                                           "times the operations of the same sum without "
                                           "images.",
                              .law = AtMost{2.5},
                              .reason = "large boxes convert most near images; only boxes at "
                                        "the edge have more neighbours",
                              .api = {"stokesbook::images_in", "stokesbook::Fmm"}},
               .control = Control{"one box for all nodes", ratios(Counted::operations, 1000000)}}}};
}

Experiment seconds() {
  return {.key = "seconds",
          .title = "Seconds of a sum in a cell, over those of the same sum without images",
          .x = "bodies n",
          .error = "ratio of seconds on this machine, one thread",
          .lines = {{.key = "tree",
                     .label = "near images in the tree",
                     .measure = ratios(Counted::seconds)}}};
}

}  // namespace stokesbook::verification::periodic
