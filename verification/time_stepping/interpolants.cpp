// Measures the errors of the interpolants within one step.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "runs.hpp"

namespace stokesbook::verification::time_stepping {

using namespace study;
using Eigen::VectorXd;

namespace {

using Interpolate = std::function<VectorXd(const Step& step, double t)>;

VectorXd without_bubble(Step step, double t) {
  step.bubble = {};
  return interpolate(step, t);
}

VectorXd straight(const Step& step, double t) {
  const double part = (t - step.start.t) / step.dt();
  return (1.0 - part) * step.start.state + part * step.end.state;
}

// Measures the largest error within one step in shear. The step starts on the exact solution at
// t = 0.7.
Measure errors_within(SteppingMethod method, const Interpolate& at) {
  return [=](Size size) {
    const Motion motion = jeffery_in_shear(8.0);
    std::vector<Measurement> measurements;
    for (int k = 0; k <= (size == Size::full ? 8 : 5); ++k) {
      const double per_unit = 4.0 * std::pow(2.0, 0.5 * k), dt = 1.0 / per_unit;
      const SteppingSettings settings{
          .method = method, .dt = dt, .bound = {1e9, VectorXd::Ones(1)}};
      const VectorXd q = motion.exact(0.7);
      const Stepper stepper(settings, {motion.rate, motion.rate});
      const Step step = stepper.advance({0.7, q, motion.rate(0.7, q)}, {}, 0.7 + dt).step;
      double error = 0.0;
      for (double part = 0.05; part < 1.0; part += 0.05) {
        const double t = 0.7 + part * dt;
        error = std::max(error, std::abs((at(step, t) - motion.exact(t))[0]));
      }
      measurements.push_back({.x = per_unit, .error = error});
    }
    return measurements;
  };
}

}  // namespace

Experiment interpolants() {
  return {
      .key = "interpolants",
      .title = "Interpolation within one step, an ellipse 3:1 in shear",
      .x = "steps a unit of time, (1/h)",
      .error = "largest error of the angle within the step",
      .lines = {
          {.key = "bogacki_shampine32",
           .label = "cubic, Bogacki-Shampine 3(2)",
           .measure = errors_within(SteppingMethod::bogacki_shampine32, interpolate),
           .claim = Claim{.id = "09_15",
                          .statement = "Within one step of Bogacki and Shampine's pair the cubic "
                                       "errs by O(h^4), as its end does.",
                          .law = Algebraic{4.0, 0.2},
                          .window = {.floor = 1e-15},
                          .reason = "cubic through states and rates at both ends",
                          .api = {"stokesbook::interpolate"}},
           .control = Control{"a straight line between the ends",
                              errors_within(SteppingMethod::bogacki_shampine32, straight)}},
          {.key = "dormand_prince54",
           .label = "quartic, Dormand-Prince 5(4)",
           .measure = errors_within(SteppingMethod::dormand_prince54, interpolate),
           .claim = Claim{.id = "09_16",
                          .statement = "Within one step of Dormand and Prince's pair the quartic "
                                       "errs by O(h^5).",
                          .law = Algebraic{5.0, 0.2},
                          .window = {.floor = 1e-15},
                          .reason = "order 4: Hairer, Norsett, Wanner, II.6",
                          .api = {"stokesbook::interpolate"}},
           .control = Control{"without the bubble",
                              errors_within(SteppingMethod::dormand_prince54, without_bubble)}},
          {.key = "prince_dormand87",
           .label = "cubic, Prince-Dormand 8(7)",
           .measure = errors_within(SteppingMethod::prince_dormand87, interpolate)}}};
}

}  // namespace stokesbook::verification::time_stepping
