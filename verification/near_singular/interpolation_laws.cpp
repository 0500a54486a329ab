// The two errors of the interpolation scheme: that of the fine rule, and that of the polynomial.
#include <algorithm>

#include "experiments.hpp"
#include "near_singular/interpolation.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

/// Largest error over distances below a step of the polynomial.
double worst_error(const Solved& solved, const InterpolationSettings& settings) {
  const InterpolationCurve curve(solved.curve, settings);
  const InterpolationData data = curve.data(solved.density);
  double error = 0.0;
  for (const double share : {0.2, 0.4, 0.6, 0.8}) {
    const ComplexVector points = solved.points_at(share * settings.step);
    error = std::max(error, solved.error(curve.velocity(data, 0, points), points));
  }
  return error;
}

Measure over_upsampling(double step, int degree) {
  return [=](Size) {
    const Solved solved = solved_ellipse().on_nodes(512);
    std::vector<Measurement> measurements;
    for (int upsampling = 1; upsampling * step < 5.5; ++upsampling) {
      measurements.push_back({.x = static_cast<double>(upsampling),
                              .error = worst_error(solved, {degree, step, upsampling})});
    }
    return measurements;
  };
}

Line upsampling_line(const std::string& key, const std::string& id, double step,
                     const std::string& text) {
  return {.key = key,
          .label = "steps of " + text,
          .measure = over_upsampling(step, 12),
          .claim =
              Claim{.id = id,
                    .statement = "With steps of " + text +
                                 " the fine rule errs as sigma "
                                 "e^{-2 pi sigma beta}.",
                    .law = Geometric{2.0 * std::numbers::pi * step, 0.05, 1.0},
                    .window = {.floor = 1e-14},
                    .reason = "the first point of the polynomial is beta coarse spacings, "
                              "sigma beta fine ones, from the curve",
                    .api = {"stokesbook::InterpolationCurve", "stokesbook::InterpolationSettings"}},
          .control = Control{"a polynomial of degree 2", over_upsampling(step, 2)}};
}

/// The flow's poles are so deep that 60 nodes resolve it; the spacing is all that varies.
Measure over_nodes(int degree, int upsampling) {
  return [=](Size size) {
    std::vector<Index> counts{128, 192, 256, 384, 512};
    if (size == Size::full) counts.insert(counts.end(), {768, 1024});
    std::vector<Measurement> measurements;
    for (const Index n : counts) {
      measurements.push_back(
          {.x = static_cast<double>(n),
           .error = worst_error(solved_ellipse().on_nodes(n), {degree, 1.0, upsampling})});
    }
    return measurements;
  };
}

Line degree_line(const std::string& key, const std::string& id, int degree) {
  const std::string text = std::to_string(degree);
  return {.key = key,
          .label = "degree " + text,
          .measure = over_nodes(degree, 6),
          .claim = Claim{.id = id,
                         .statement = "A polynomial of degree " + text + " has the order " +
                                      std::to_string(degree + 1) + " in the spacing.",
                         .law = Algebraic{degree + 1.0, 0.3},
                         .window = {.from = 190.0, .floor = 1e-14},
                         .reason = "interpolation at m + 1 points that are proportional to h",
                         .api = {"stokesbook::InterpolationCurve"}},
          .control = Control{"one fine node a node", over_nodes(degree, 1)}};
}

/// Errors of the published parameters at half a spacing and less, over the specification's numbers.
struct TableEntry {
  double spacings, error;
};

Measure beside_table(Index n, const std::vector<TableEntry>& entries, double step) {
  return [=](Size) {
    const Solved solved = solved_ellipse().on_nodes(n);
    InterpolationSettings settings = InterpolationSettings::published(n);
    settings.step = step;
    const InterpolationCurve curve(solved.curve, settings);
    const InterpolationData data = curve.data(solved.density);
    std::vector<Measurement> measurements;
    for (const TableEntry& entry : entries) {
      const ComplexVector points = solved.points_at(entry.spacings);
      measurements.push_back(
          {.x = entry.error, .error = solved.error(curve.velocity(data, 0, points), points)});
    }
    return measurements;
  };
}

Line table_line(const std::string& key, const std::string& id, Index n,
                const std::vector<TableEntry>& entries) {
  const std::string text = std::to_string(n) + " nodes";
  return {.key = key,
          .label = text,
          .measure = beside_table(n, entries, 1.1),
          .claim =
              Claim{.id = id,
                    .statement = "The errors of the published parameters with " + text +
                                 " are those of an independent code.",
                    .law = ErrorBelowTolerance{3.0, 1.0 / 3.0},
                    .reason = "the same shape and parameters, another flow with as deep poles",
                    .api = {"stokesbook::InterpolationCurve", "stokesbook::InterpolationSettings"}},
          .control = Control{"half of the step", beside_table(n, entries, 0.55)}};
}

}  // namespace

Experiment upsampling() {
  return {.key = "upsampling",
          .title = "The fine rule of the interpolation scheme",
          .x = "fine nodes a node sigma",
          .error = "largest error of the velocity closer than a step, relative",
          .axes = Axes::semi_log,
          .lines = {upsampling_line("one", "06_14", 1.0, "a spacing"),
                    upsampling_line("half", "06_15", 0.5, "half a spacing")}};
}

Experiment degrees() {
  return {.key = "degrees",
          .title = "The polynomial of the interpolation scheme",
          .x = "nodes N",
          .error = "largest error of the velocity closer than a step, relative",
          .lines = {degree_line("two", "06_16", 2), degree_line("four", "06_17", 4),
                    degree_line("six", "06_18", 6)}};
}

Experiment tabulated() {
  return {
      .key = "tabulated",
      .title = "Published parameters beside a prototype's table",
      .x = "error of the prototype e",
      .error = "error of the velocity, relative to the largest on the curve",
      .lines = {
          table_line("n128", "06_28", 128, {{1e-4, 8e-10}, {1e-2, 8e-8}, {0.1, 6e-7}, {0.5, 1e-6}}),
          table_line("n256", "06_29", 256, {{1e-4, 1e-11}, {1e-2, 1e-9}, {0.1, 1e-8}, {0.5, 2e-8}}),
          table_line("n512", "06_30", 512,
                     {{1e-4, 2e-13}, {1e-2, 2e-11}, {0.1, 1e-10}, {0.5, 2e-10}})}};
}

}  // namespace stokesbook::verification::near_singular
