// Measures the two errors of the interpolation scheme: that of the fine rule (06.6), and that of
// the polynomial (06.7).
#include <algorithm>

#include "experiments.hpp"
#include "near_singular/interpolation.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

const SetUp elliptic_container{Ellipse{1.0, 0.5}, Side::fluid_inside, 128, outer_poles};

/// Returns the largest error at distances below one step of the polynomial.
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
    const Solved solved = solved_ellipse().on_nodes(384);
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

/// Measures errors by the number of nodes. The flow's poles are so deep that 60 nodes resolve the
/// density; only the spacing changes.
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

/// Returns the order of the polynomial's error between the spacings that belong to two numbers of
/// nodes. For a pole of the flow at the distance l, u ~ 1/(l + d), the error is
/// prod_j (d - j h)/(l + j h)/(l + d).
double order_above_a_pole(int degree, double first, double last) {
  constexpr double depth = 0.49,
                   speed = 1.0;  // depth of the pole at 0.1 + 0.01 i below the flat side
  double order = degree + 1.0;
  for (int j = 1; j <= degree; ++j) {
    const auto reach = [&](double n) { return depth + j * 2.0 * std::numbers::pi * speed / n; };
    order -= std::log(reach(first) / reach(last)) / std::log(last / first);
  }
  return order;
}

Line degree_line(const std::string& key, const std::string& id, int degree) {
  const std::string text = std::to_string(degree);
  return {.key = key,
          .label = "degree " + text,
          .measure = over_nodes(degree, 6),
          .claim = Claim{.id = id,
                         .statement = "A polynomial of degree " + text + " has the order " +
                                      std::to_string(degree + 1) +
                                      " in the spacing, less what its points move away from the "
                                      "flow's pole.",
                         .law = Algebraic{order_above_a_pole(degree, 192.0, 512.0)},
                         .window = {.from = 190.0, .to = 520.0, .floor = 1e-14},
                         .reason = "prod_j (d - j h)/(l + j h) above a pole at the distance l",
                         .api = {"stokesbook::InterpolationCurve"}},
          .control = Control{"one fine node a node", over_nodes(degree, 1)}};
}

/// Measures, for each tolerance, the largest error at all distances up to three spacings, relative
/// to the density. With 256 nodes, steps of one spacing resolve the flow.
Measure over_tolerances(const SetUp& set_up, double share_of_fine_nodes) {
  return [=](Size) {
    const Solved solved = Solved(set_up).on_nodes(256);
    std::vector<Measurement> measurements;
    for (const double tolerance : {1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
      InterpolationSettings settings = InterpolationSettings::for_tolerance(tolerance);
      settings.upsampling = static_cast<int>(std::ceil(share_of_fine_nodes * settings.upsampling));
      const InterpolationCurve curve(solved.curve, settings);
      const InterpolationData data = curve.data(solved.density);
      double error = 0.0;
      for (const double d : {1e-6, 1e-2, 0.1, 0.3, 0.5, 0.7, 1.0, 2.0, 3.0}) {
        const ComplexVector points = solved.points_at(d);
        error = std::max(error, solved.error(curve.velocity(data, 0, points), points));
      }
      measurements.push_back(
          {.x = tolerance, .error = error * solved.scale / test::largest(solved.density)});
    }
    return measurements;
  };
}

Line tolerance_line(const std::string& key, const std::string& id, const std::string& label,
                    const SetUp& set_up) {
  return {.key = key,
          .label = label,
          .measure = over_tolerances(set_up, 1.0),
          .claim =
              Claim{.id = id,
                    .statement =
                        "Interpolation for a tolerance meets it " + label + ", at every distance.",
                    .law = ErrorBelowTolerance{1.0, 1e-3},
                    .reason = "sigma beta = ln(100/eps)/2 pi, rounded up to the next fine "
                              "node: at most e^{2 pi} better",
                    .api = {"stokesbook::InterpolationCurve", "stokesbook::InterpolationSettings"}},
          .control = Control{"half of the fine nodes", over_tolerances(set_up, 0.5)}};
}

/// Holds a distance, and the specification's error there, for comparison with the errors of the
/// published parameters at half a spacing and less.
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

/// Holds an entry of the specification's sweep of parameters; the polynomial's step is one spacing.
/// For fluid inside, the flow differs from the specification's flow, so the errors of the
/// polynomial differ from those of the specification; the errors of the fine rule do not differ.
struct SweepEntry {
  int degree, upsampling;
  double error;
};

Measure beside_sweep(const SetUp& set_up, Index n, const std::vector<SweepEntry>& entries,
                     double step) {
  return [=](Size) {
    const Solved solved = Solved(set_up).on_nodes(n);
    std::vector<Measurement> measurements;
    for (const SweepEntry& entry : entries) {
      measurements.push_back(
          {.x = entry.error, .error = worst_error(solved, {entry.degree, step, entry.upsampling})});
    }
    return measurements;
  };
}

Line sweep_line(const std::string& key, const std::string& id, const std::string& where,
                const SetUp& set_up, Index n, const std::vector<SweepEntry>& entries) {
  return {.key = key,
          .label = std::to_string(n) + " nodes, " + where,
          .measure = beside_sweep(set_up, n, entries, 1.0),
          .claim =
              Claim{.id = id,
                    .statement = "Over degrees and fine nodes, " + std::to_string(n) + " nodes " +
                                 where + " reach the errors of an independent code.",
                    .law = ErrorBelowTolerance{3.0, 1.0 / 3.0},
                    .reason = "the same shape and parameters, another flow with as deep poles",
                    .api = {"stokesbook::InterpolationCurve", "stokesbook::InterpolationSettings"}},
          .control = Control{"half of the step", beside_sweep(set_up, n, entries, 0.5)}};
}

}  // namespace

Experiment upsampling() {
  return {.key = "upsampling",
          .title = "The fine rule of the interpolation scheme",
          .x = "fine nodes a node σ",
          .error = "largest error of the velocity closer than a step, relative",
          .axes = Axes::semi_log,
          .lines = {upsampling_line("one", "06_13", 1.0, "a spacing"),
                    upsampling_line("half", "06_14", 0.5, "half a spacing")}};
}

Experiment degrees() {
  return {.key = "degrees",
          .title = "The polynomial of the interpolation scheme",
          .x = "nodes N",
          .error = "largest error of the velocity closer than a step, relative",
          .lines = {degree_line("two", "06_15", 2), degree_line("four", "06_16", 4),
                    degree_line("six", "06_17", 6)}};
}

Experiment tolerances() {
  return {
      .key = "tolerances",
      .title = "Interpolation for a tolerance, 256 nodes",
      .x = "tolerance ε",
      .error = "largest error at any distance, relative to the density",
      .lines = {tolerance_line("outside", "06_18", "outside an ellipse 2:1", ellipse),
                tolerance_line("inside", "06_19", "inside an ellipse 2:1", elliptic_container)}};
}

Experiment sweep() {
  return {.key = "sweep",
          .title = "Degrees and fine nodes beside a prototype's table",
          .x = "error of the prototype e",
          .error = "largest error of the velocity closer than a step, relative",
          .lines = {sweep_line("outside_128", "06_37", "outside", ellipse, 128,
                               {{14, 2, 2e-4},
                                {4, 6, 2e-5},
                                {6, 6, 1e-6},
                                {14, 3, 8e-7},
                                {8, 6, 3e-7},
                                {10, 6, 8e-8},
                                {12, 6, 3e-8},
                                {14, 6, 9e-9}}),
                    sweep_line("outside_256", "06_38", "outside", ellipse, 256,
                               {{14, 2, 1e-4},
                                {4, 6, 6e-7},
                                {14, 3, 5e-7},
                                {6, 6, 3e-8},
                                {8, 6, 2e-9},
                                {14, 4, 2e-9},
                                {10, 6, 3e-10},
                                {12, 6, 4e-11},
                                {14, 5, 7e-12},
                                {14, 6, 6e-12}}),
                    sweep_line("inside_128", "06_39", "inside", elliptic_container, 128,
                               {{14, 2, 9e-5}, {14, 3, 3e-7}, {14, 4, 9e-10}}),
                    sweep_line("inside_256", "06_40", "inside", elliptic_container, 256,
                               {{14, 2, 1e-4}, {14, 3, 3e-7}, {14, 4, 8e-10}, {14, 5, 2e-12}})}};
}

Experiment tabulated() {
  return {
      .key = "tabulated",
      .title = "Published parameters beside a prototype's table",
      .x = "error of the prototype e",
      .error = "error of the velocity, relative to the largest on the curve",
      .lines = {
          table_line("n128", "06_20", 128, {{1e-4, 8e-10}, {1e-2, 8e-8}, {0.1, 6e-7}, {0.5, 1e-6}}),
          table_line("n256", "06_21", 256, {{1e-4, 1e-11}, {1e-2, 1e-9}, {0.1, 1e-8}, {0.5, 2e-8}}),
          table_line("n512", "06_22", 512,
                     {{1e-4, 2e-13}, {1e-2, 2e-11}, {0.1, 1e-10}, {0.5, 2e-10}})}};
}

}  // namespace stokesbook::verification::near_singular
