// Compares with the published table: two disks that pass each other in shear, which is then
// reversed.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"
#include "text/number_text.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

// Shear rate times step. The published table lists half of this product.
const std::array<double, 5> published_steps{0.08, 0.04, 0.02, 0.01, 0.005};

// Holds one row of the published table: a separation in node spacings, and the printed changes for
// the published steps.
struct Row {
  double separation;
  std::array<double, 5> change;
};

const std::array<Row, 7> published_rows{{{0.0, {0.135, 0.0732, 0.0374, 0.0200, 0.0101}},
                                         {1.0, {0.135, 0.0732, 0.0374, 0.0200, 0.0101}},
                                         {2.0, {0.188, 0.141, 0.117, 0.108, 0.102}},
                                         {2.25, {0.255, 0.208, 0.187, 0.178, 0.173}},
                                         {2.5, {0.305, 0.269, 0.252, 0.245, 0.240}},
                                         {2.75, {0.364, 0.331, 0.313, 0.307, 0.303}},
                                         {3.0, {0.412, 0.388, 0.372, 0.367, 0.363}}}};

std::vector<Row> rows(Size size) {
  if (size == Size::full) return {published_rows.begin(), published_rows.end()};
  return {published_rows[0], published_rows[2], published_rows[6]};
}

std::size_t columns(Size size) {
  return size == Size::full ? published_steps.size() : 2;
}

/// Returns the distance of both centres at the end from their start, relative to the distance of
/// the start from the origin.
double change(const Scene& scene) {
  const RecordedRun run = recorded_run(scene);
  double moved = 0.0, start = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Complex from = run.frames.front().bodies[k].position;
    moved += std::norm(run.frames.back().bodies[k].position - from);
    start += std::norm(from);
  }
  return std::sqrt(moved / start);
}

/// @param  separation  in node spacings; 0 means no contact
double change(double separation, double dt) {
  static Once<std::pair<double, double>, double> changes;
  return changes({separation, dt}, [&] {
    std::vector<Body> disks(2, Body{.shape = Circle{0.5}});
    disks[0].position = {-8.0, 0.5};
    Scene scene = over(in_contact(ShearFlow{1.0}, disks, separation * node_spacing), 40.0, dt);
    if (separation == 0.0) scene.contact.reset();
    scene.reverse_at = {20.0};
    scene.output.dt_write = 40.0;
    return change(scene);
  });
}

Measure changes(std::size_t column) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Row& row : rows(size)) {
      measurements.push_back(
          {.x = row.separation, .error = change(row.separation, published_steps[column])});
    }
    return measurements;
  };
}

// The separations are `wider` node spacings larger than those of the table; a value other than 0 is
// a planted defect.
Measure differences_from_table(double wider) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Row& row : rows(size)) {
      double largest = 0.0;
      for (std::size_t k = 0; k < (wider == 0.0 ? columns(size) : 1); ++k) {
        const double found = change(row.separation + wider, published_steps[k]);
        largest = std::max(largest, std::abs(found / row.change[k] - 1.0));
      }
      measurements.push_back({.x = row.separation, .error = largest});
    }
    return measurements;
  };
}

}  // namespace

Experiment reversal_table() {
  Experiment experiment{
      .key = "reversal",
      .title = "Two disks of radius 1/2 in shear that reverses: how far they end from their start",
      .x = "separation, in π/32, δ",
      .error = "distance of both centres from their start, over that of the start from the origin",
      .axes = Axes::no_law,
      .lines = {
          {.key = "difference",
           .label = "largest difference from the published table, relative",
           .measure = differences_from_table(0.0),
           .claim = Claim{.id = "12_9",
                          .statement = "The distances from the start after a reversal with contact "
                                       "agree with the published table, 35 entries, to 6 %.",
                          .law = AtMost{0.06},
                          .reason = "the table has three digits, and some of its runs are a step "
                                    "longer or shorter: at separation 0 (no contact here) one step "
                                    "more forth than back explains a difference of 5 %",
                          .api = {"stokesbook::Simulation"}},
           .control = Control{"separations wider by pi/128", differences_from_table(0.25)}}}};
  for (std::size_t k = 0; k < published_steps.size(); ++k) {
    experiment.lines.push_back({.key = "column_" + std::to_string(k),
                                .label = "rate × Δt = " + short_number(published_steps[k]),
                                .measure = changes(k),
                                .least = k < columns(Size::quick) ? Size::quick : Size::full});
  }
  return experiment;
}

}  // namespace stokesbook::verification::suspension
