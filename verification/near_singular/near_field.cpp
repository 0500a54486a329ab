// Compares the near test (06.5) with the error of the rule at random targets.
#include "near_singular/near_field.hpp"

#include <algorithm>
#include <random>

#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

const SetUp slender{Ellipse{1.5, 0.3}, Side::fluid_outside, 200, inner_poles};
const SetUp coarse_star{Star{1.0, 0.2, 5}, Side::fluid_outside, 256, inner_poles};

/// Holds a target, and its distance from its foot on the curve in local spacings.
struct Target {
  Complex z;
  double spacings;
};

std::vector<Target> random_targets(const SetUp& set_up, Index count) {
  std::mt19937 generator(6);
  std::uniform_int_distribution<Index> anywhere(0, 9999);
  std::uniform_real_distribution<double> up_to_seven(0.0, 7.0);
  const Curve points = sample(set_up.shape, 10000, set_up.side);
  const ComplexVector normal = normals(points);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(set_up.n);
  std::vector<Target> targets;
  for (Index i = 0; i < count; ++i) {
    const Index j = anywhere(generator);
    const double spacings = up_to_seven(generator);
    targets.push_back(
        {points.x[j] - spacings * std::abs(points.dx[j]) * step * normal[j], spacings});
  }
  return targets;
}

using Exponent = double (*)(const Curve&, const Target&);

double by_the_rule(const Curve& curve, const Target& target) {
  return preimage_depth(curve, target.z);
}

double by_preimage(const Curve& curve, const Target& target) {
  const Complex s = preimage(curve, nearest_node(curve, target.z), target.z);
  return static_cast<double>(curve.size()) * std::abs(s.imag());
}

/// A planted defect: the exponent is that of a straight curve, 2 pi d/h.
double by_distance(const Curve&, const Target& target) {
  return 2.0 * std::numbers::pi * target.spacings;
}

/// Finds, for each interval of the exponent, the target for which the quotient of error and
/// exponential is largest.
Measure worst_of_intervals(const SetUp& set_up, Exponent exponent) {
  return [=](Size size) {
    const Solved solved(set_up);
    const std::vector<Target> targets = random_targets(set_up, size == Size::full ? 50000 : 5000);
    ComplexVector z(static_cast<Index>(targets.size()));
    std::ranges::transform(targets, z.begin(), &Target::z);
    const Eigen::VectorXd error =
        (StressletSum({solved.curve})(z, solved.density) - set_up.flow.velocity(z)).cwiseAbs() /
        test::largest(solved.density);
    std::vector<Measurement> worst(13);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const double q = exponent(solved.curve, targets[i]);
      if (q >= 26.0) continue;
      Measurement& interval = worst[12 - static_cast<std::size_t>(q / 2.0)];
      const double bound = std::exp(-q), found = error[static_cast<Index>(i)];
      if (interval.x == 0.0 || found / bound > interval.error / interval.x) {
        interval.x = bound;
        interval.error = found;
      }
    }
    std::erase_if(worst, [](const Measurement& interval) { return interval.x == 0.0; });
    return worst;
  };
}

Line line(const std::string& key, const std::string& id, const std::string& label,
          const SetUp& set_up) {
  return {.key = key,
          .label = label,
          .measure = worst_of_intervals(set_up, by_the_rule),
          .claim = Claim{.id = id,
                         .statement = "At " + label +
                                      " the rule errs by at most 200 e^{-N |Im s|}, and "
                                      "somewhere by as much as the exponential.",
                         .law = ErrorBelowTolerance{200.0, 1.0},
                         .reason = "the residue of the kernel's double pole is a multiple of "
                                   "1 + N |Im s|, with N |Im s| up to 26 here",
                         .api = {"stokesbook::is_near", "stokesbook::near_cut",
                                 "stokesbook::preimage_depth"}},
          .control = Control{"the distance in spacings in place of the preimage",
                             worst_of_intervals(set_up, by_distance)}};
}

}  // namespace

Experiment preimages() {
  return {.key = "preimages",
          .title = "The near test: worst of 5000 random targets",
          .x = "size of exp(iNτ) at the preimage τ, |q|",
          .error = "error of the trapezoid rule, relative to the density",
          .lines = {line("slender", "06_23", "an ellipse 5:1, 200 nodes", slender),
                    line("star", "06_24", "a star of five arms, 256 nodes", coarse_star),
                    {.key = "distance",
                     .label = "ellipse 5:1, by the distance alone",
                     .measure = worst_of_intervals(slender, by_distance)},
                    {.key = "expansion",
                     .label = "ellipse 5:1, by the preimage to second order",
                     .measure = worst_of_intervals(slender, by_preimage)}}};
}

}  // namespace stokesbook::verification::near_singular
