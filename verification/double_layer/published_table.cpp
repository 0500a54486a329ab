// Compares with the published table of the trapezoid rule's errors inside an ellipse, at points
// closer and closer to its tip.
#include <cmath>

#include "experiments.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_flows.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

const test::ExactFlow extension{{}, 1.0};

double error_at(double y, Index n, Side side) {
  const Curve wall = sample(Ellipse{1.0, 2.0}, n, side);
  const ComplexVector target = ComplexVector::Constant(1, Complex{0.0, y});
  const ComplexVector density = test::density_of(wall, extension.velocity(wall.x));
  return test::largest(plain_rule(wall, density, target) - extension.velocity(target));
}

constexpr double nothing = 0.0;

struct Entry {
  Index n;
  double printed;  ///< `nothing` if the error is at the level of rounding
};

/// Returns the difference of an error from the printed error, in units of the third digit of the
/// printed error, or the error in units of 1e-13 if nothing is printed.
double units_off(double error, double printed) {
  if (printed == nothing) return error / 1e-13;
  return std::abs(error - printed) / std::pow(10.0, std::floor(std::log10(printed)) - 2.0);
}

Measure against(std::vector<Entry> entries, double y, Side side) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const Entry& entry : entries) {
      measurements.push_back({.x = static_cast<double>(entry.n),
                              .error = units_off(error_at(y, entry.n, side), entry.printed)});
    }
    return measurements;
  };
}

Line printed_line(const std::string& key, const std::string& id, double y,
                  const std::vector<Entry>& entries) {
  const std::string point = "(0, " + std::to_string(y).substr(0, 4) + ")";
  return {
      .key = key,
      .label = "at " + point,
      .measure = against(entries, y, Side::fluid_inside),
      .claim = Claim{.id = id,
                     .statement = "The published errors of the trapezoid rule at " + point +
                                  ", inside the ellipse (cos t, 2 sin t), are reproduced to "
                                  "their digits.",
                     .law = Identity{0.6},
                     .reason = "Bystricky's dissertation, table of the trapezoid rule near a "
                               "boundary; 0.6: rounding of the third digit",
                     .api = {"stokesbook::double_layer_matrix", "stokesbook::stresslet"}},
      .control = Control{"the normal into the fluid", against(entries, y, Side::fluid_outside)}};
}

}  // namespace

Experiment published_table() {
  return {.key = "published",
          .title = "The published table",
          .x = "nodes N",
          .error = "difference from print, units of the third digit",
          .lines = {
              printed_line("middle", "02_30", 1.0, {{32, 1.01e-6}, {128, nothing}, {256, nothing}}),
              printed_line("near", "02_1", 1.9, {{32, 6.04e-1}, {128, 4.17e-5}, {256, 4.59e-11}}),
              printed_line("nearer", "02_2", 1.99,
                           {{32, 2.07e1}, {128, 3.84}, {256, 1.13}, {512, 1.30e-1}})}};
}

}  // namespace stokesbook::verification::double_layer
