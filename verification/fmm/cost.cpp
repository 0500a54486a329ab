// Counts the operations of an application by the number of nodes, and finds the number of nodes
// above which an application has fewer operations than the direct sum.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "set_ups.hpp"
#include "support/point_sets.hpp"

namespace stokesbook::verification::fmm {

using namespace study;
using Eigen::Index;

namespace {

using MakeCurves = std::vector<Curve> (*)(Index n);

/// Returns a row of the table that shows the number of operations.
Measurement counted(Index n, double operations) {
  return {.x = static_cast<double>(n), .error = operations, .operations = operations};
}

template <class Count>
Measure over_nodes(const Count& count) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double most = size == Size::full ? 1.1e6 : 1.2e5;
    for (double n = 1e4; n < most; n *= std::numbers::sqrt2) {
      measurements.push_back(count(static_cast<Index>(n)));
    }
    return measurements;
  };
}

/// Counts operations of the fast multipole method for six digits.
Measure multipoles(MakeCurves make, Index least_leaf = 0) {
  return over_nodes([=](Index n) {
    FmmSettings settings = FmmSettings::for_tolerance(1e-6);
    settings.leaf_size = std::max(settings.leaf_size, least_leaf);
    const Fmm plan(make(n), {}, settings);
    return counted(plan.sources().size(), operations(plan, settings.order));
  });
}

Measurement all_pairs(Index n) {
  return counted(n, static_cast<double>(n) * static_cast<double>(n));
}

/// Counts operations with boxes of one size, side x side, without a tree (08.14). Well separated
/// pairs of boxes are converted, and all other pairs are summed directly.
double one_level(const ComplexVector& points, Index side) {
  Eigen::ArrayXXd in_box = Eigen::ArrayXXd::Zero(side, side);
  const auto place = [&](double x) {
    return std::min(side - 1, static_cast<Index>(0.5 * (x + 1.0) * static_cast<double>(side)));
  };
  for (const Complex z : points) ++in_box(place(z.real()), place(z.imag()));
  double pairs = 0.0, near_boxes = 0.0;
  for (Index i = -2; i <= 2; ++i) {
    for (Index j = -2; j <= 2; ++j) {
      if (i * i + j * j >= 5) continue;  // converts if 3 R < |D|
      const Index rows = side - std::abs(i), columns = side - std::abs(j);
      const auto from = in_box.block(std::max<Index>(i, 0), std::max<Index>(j, 0), rows, columns),
                 to = in_box.block(std::max<Index>(-i, 0), std::max<Index>(-j, 0), rows, columns);
      pairs += (from * to).sum();
      near_boxes += static_cast<double>(rows * columns);
    }
  }
  const double p = FmmSettings::for_tolerance(1e-6).order,
               boxes = static_cast<double>(in_box.size());
  return pairs + 0.5 * p * p * (boxes * boxes - near_boxes) +
         3.0 * p * static_cast<double>(points.size());
}

/// Returns the number of boxes on a side for which 13 n^2/b + b^2 p^2/2 is minimal, b = side^2
/// (08.14).
Index best_side(Index n) {
  const double ratio = static_cast<double>(n) / FmmSettings::for_tolerance(1e-6).order;
  return std::lround(std::cbrt(std::sqrt(13.0) * ratio));
}

Measurement best_level(Index n) {
  return counted(n, one_level(test::points_in_a_square(n), best_side(n)));
}
/// A planted defect: the number of boxes is that for ten thousand nodes, for any n.
Measurement fixed_level(Index n) {
  return counted(n, one_level(test::points_in_a_square(n), best_side(10000)));
}

Line linear_line(const std::string& key, const std::string& id, const std::string& label,
                 MakeCurves make) {
  return {.key = key,
          .label = "multipoles, " + label,
          .measure = multipoles(make),
          .claim = Claim{.id = id,
                         .statement = "An application takes a number of operations in proportion "
                                      "to the nodes, " +
                                      label + ".",
                         .law = Cost{1.025, 0.075},
                         .reason = "lists have a bounded length, and so have leaves; leaves fill "
                                   "up and are divided each time that N grows by four, which "
                                   "makes waves",
                         .api = {"stokesbook::Fmm", "stokesbook::find_interactions",
                                 "stokesbook::Quadtree"}},
          .control = Control{"one box for all nodes",
                             multipoles(make, std::numeric_limits<Index>::max())}};
}

/// Returns about n nodes on 25 ellipses.
std::vector<Curve> few_ellipses(Index n) {
  return test::ellipses(5, 2 * std::lround(static_cast<double>(n) / 50.0));
}

/// Returns the operations of the method relative to those of the direct sum.
Measurement share(Index n, const FmmSettings& settings) {
  const Fmm plan(few_ellipses(n), {}, settings);
  const auto nodes = static_cast<double>(plan.sources().size());
  return {.x = nodes, .error = operations(plan, settings.order) / (nodes * nodes)};
}

Measure shares(double tolerance) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (Index n = 100; n <= 12800; n *= 2) {
      measurements.push_back(share(n, FmmSettings::for_tolerance(tolerance)));
    }
    return measurements;
  };
}

/// Measures shares at the least number of nodes for which the library uses the method.
Measure shares_at_break_even(Index least_leaf) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
      FmmSettings settings = FmmSettings::for_tolerance(tolerance);
      const Index n = stokesbook::break_even(settings);
      settings.leaf_size = std::max(settings.leaf_size, least_leaf);
      measurements.push_back(share(n, settings));
    }
    return measurements;
  };
}

/// Returns the least time of five runs, in seconds.
template <class Work>
double least_seconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  double seconds = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 5; ++repeat) {
    const Clock::time_point start = Clock::now();
    work();
    seconds = std::min(seconds, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return seconds;
}

double seconds_of_sum(const std::vector<Curve>& curves, const ComplexVector& density) {
  const StressletSum sum(curves);
  return least_seconds([&] { sum(density); });
}

template <int digits>
double seconds_of_multipoles(const std::vector<Curve>& curves, const ComplexVector& density) {
  const Fmm plan(curves, {}, FmmSettings::for_tolerance(std::pow(10.0, -digits)));
  FmmWorkspace work = plan.workspace();
  return least_seconds([&] { plan.velocity(density, work); });
}

using Seconds = double (*)(const std::vector<Curve>&, const ComplexVector&);

Measure timed(Seconds seconds) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index n = 200; n <= (size == Size::full ? 51200 : 6400); n *= 2) {
      const std::vector<Curve> curves = few_ellipses(n);
      const ComplexVector density = test::random_vector(all_nodes(curves).size(), 3);
      measurements.push_back(
          {.x = static_cast<double>(density.size()), .error = seconds(curves, density)});
    }
    return measurements;
  };
}

}  // namespace

Experiment cost() {
  return {.key = "cost",
          .title = "Operations of an application, for six digits",
          .x = "nodes N",
          .error = "operations in kernel evaluations",
          .lines = {linear_line("square", "08_27", "nodes uniform in a square", square),
                    linear_line("ellipses", "08_28", "nodes on ellipses", ellipses),
                    {.key = "crowd",
                     .label = "multipoles, nodes crowding over eight decades",
                     .measure = multipoles(crowd)},
                    {.key = "level",
                     .label = "one level of boxes, nodes uniform in a square",
                     .measure = over_nodes(best_level),
                     .claim = Claim{.id = "08_29",
                                    .statement = "With one level of boxes, as many as are best, "
                                                 "it takes a multiple of N^{4/3} operations.",
                                    .law = Cost{4.0 / 3.0, 0.06},
                                    .reason = "the least of 13 N^2/b + b^2 p^2/2 over the number "
                                              "b of boxes; boxes at the edge have fewer "
                                              "neighbours",
                                    .api = {"stokesbook::find_interactions"}},
                     .control = Control{"one number of boxes for all N", over_nodes(fixed_level)}},
                    {.key = "direct", .label = "direct sum", .measure = over_nodes(all_pairs)}},
          .operation = "operations in kernel evaluations"};
}

Experiment break_even() {
  return {.key = "break_even",
          .title = "Operations of an application, over those of the direct sum",
          .x = "nodes N",
          .error = "operations over N²",
          .lines = {{.key = "three", .label = "three digits", .measure = shares(1e-3)},
                    {.key = "six", .label = "six digits", .measure = shares(1e-6)},
                    {.key = "twelve", .label = "twelve digits", .measure = shares(1e-12)},
                    {.key = "rule",
                     .label = "at the library's break-even",
                     .measure = shares_at_break_even(0),
                     .claim = Claim{.id = "08_30",
                                    .statement = "Where the library changes from the direct sum "
                                                 "to multipoles, they take half of the operations.",
                                    .law = Floor{0.5, 1.5},
                                    .reason = "by time: an operation of the direct sum, in one "
                                              "long loop, takes half as long",
                                    .api = {"stokesbook::break_even"}},
                     .control = Control{"one box for all nodes",
                                        shares_at_break_even(std::numeric_limits<Index>::max())}}}};
}

Experiment seconds() {
  return {.key = "seconds",
          .title = "Seconds an application on this machine, one thread",
          .x = "nodes N",
          .error = "seconds",
          .lines = {{.key = "direct", .label = "direct sum", .measure = timed(seconds_of_sum)},
                    {.key = "three",
                     .label = "multipoles, three digits",
                     .measure = timed(seconds_of_multipoles<3>)},
                    {.key = "six",
                     .label = "multipoles, six digits",
                     .measure = timed(seconds_of_multipoles<6>)},
                    {.key = "twelve",
                     .label = "multipoles, twelve digits",
                     .measure = timed(seconds_of_multipoles<12>)}}};
}

}  // namespace stokesbook::verification::fmm
