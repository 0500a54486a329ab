// Compares with the published table of the trapezoid rule (Bystricky's dissertation), and shows the
// rates for a smooth periodic function and for a function with a jump.
#include <cmath>

#include "experiments.hpp"

namespace stokesbook::verification::trapezoid {

using namespace study;

namespace {

const auto exp_cos = [](double t) { return std::exp(std::cos(t)); };

/// Returns the relative error for exp(cos t), whose integral is 2 pi I_0(1).
template <class Rule>
double periodic_error(Eigen::Index n, const Rule& rule) {
  const double exact = 2.0 * std::numbers::pi * std::cyl_bessel_i(0.0, 1.0);
  return std::abs(rule(n, exp_cos) / exact - 1.0);
}

/// Returns the relative error for e^t on [0, 2 pi]. At the jump the rule takes a weighted mean of
/// the values on both sides.
double jump_error(Eigen::Index n, double share_of_the_left) {
  const double last = std::exp(2.0 * std::numbers::pi);
  const auto f = [&](double t) {
    return t == 0.0 ? (1.0 - share_of_the_left) + share_of_the_left * last : std::exp(t);
  };
  return std::abs(trapezoid_rule(n, f) / (last - 1.0) - 1.0);
}

struct Entry {
  int n;
  double printed;
};

/// Returns the difference of an error from a printed error, in units of the third digit of the
/// printed error.
double units_off(double error, double printed) {
  const double unit = std::pow(10.0, std::floor(std::log10(printed)) - 2.0);
  return std::abs(error - printed) / unit;
}

template <class Error>
Measure against(std::vector<Entry> entries, const Error& error) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const Entry& entry : entries) {
      measurements.push_back(
          {.x = static_cast<double>(entry.n), .error = units_off(error(entry.n), entry.printed)});
    }
    return measurements;
  };
}

const std::vector<Entry> printed_for_jump{{4, 1.98e-1}, {8, 5.09e-2}, {16, 1.28e-2}, {32, 3.21e-3}};

template <class Error>
Measure doubling(int from, int to, const Error& error) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (int n = from; n <= to; n *= 2) {
      measurements.push_back({.x = static_cast<double>(n), .error = error(n)});
    }
    return measurements;
  };
}

const auto each_node_once = [](Eigen::Index n, const auto& f) { return trapezoid_rule(n, f); };
const auto both_ends = [](Eigen::Index n, const auto& f) { return rule_with_both_ends(n, f); };
const auto mean_of_sides = [](Eigen::Index n) { return jump_error(n, 0.5); };
const auto right_side = [](Eigen::Index n) { return jump_error(n, 0.0); };

}  // namespace

Experiment published_table() {
  return {.key = "published",
          .title = "The published table",
          .x = "nodes N",
          .error = "difference from the printed error, units of its third digit",
          .lines = {{.key = "jump",
                     .label = "e^t on [0, 2π]",
                     .measure = against(printed_for_jump, mean_of_sides),
                     .claim = Claim{.id = "01_1",
                                    .statement = "The published errors for a function with a jump "
                                                 "are reproduced to their digits.",
                                    .law = Identity{0.6},
                                    .reason = "Bystricky's dissertation, table of the trapezoid "
                                              "rule; 0.6: rounding of the third digit",
                                    .api = {"stokesbook::weights"}},
                     .control = Control{"the value right of the jump instead of the mean",
                                        against(printed_for_jump, right_side)}}}};
}

Experiment smoothness() {
  return {
      .key = "smoothness",
      .title = "Smooth and periodic, or not",
      .x = "nodes N",
      .error = "relative error of the integral",
      .lines = {
          {.key = "periodic",
           .label = "exp(cos t)",
           .measure =
               doubling(2, 32, [](Eigen::Index n) { return periodic_error(n, each_node_once); }),
           .claim = Claim{.id = "01_2",
                          .statement = "For an entire periodic function the error falls faster "
                                       "than any power of N.",
                          .law = Superalgebraic{10.0},
                          .window = {.floor = 1e-15},
                          .reason = "Fourier coefficients I_k(1) ~ (1/2)^k / k!",
                          .api = {"stokesbook::weights"}},
           .control =
               Control{
                   "the first node counted twice",
                   doubling(2, 32, [](Eigen::Index n) { return periodic_error(n, both_ends); })}},
          {.key = "jump",
           .label = "e^t, which jumps at 2π",
           .measure = doubling(4, 512, mean_of_sides),
           .claim = Claim{.id = "01_3",
                          .statement = "A function that jumps where the period closes is "
                                       "integrated with order 2 only: the hard case that fails.",
                          .law = Algebraic{2.0, 0.05},
                          .window = {.from = 16.0},
                          .reason = "Euler and Maclaurin: h^2 (f'(2 pi) - f'(0)) / 12",
                          .api = {"stokesbook::weights"}},
           .control = Control{"the value right of the jump instead of the mean",
                              doubling(4, 512, right_side)}}}};
}

}  // namespace stokesbook::verification::trapezoid
