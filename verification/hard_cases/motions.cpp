// Defines hard runs without contact: steps that are far too long, and very many steps.
#include <cmath>

#include "hard_run.hpp"
#include "support/known_motions.hpp"

namespace stokesbook::verification::hard_cases {

using namespace test;

namespace {

Finding thousand_steps() {
  Scene alone = scene(ShearFlow{1.0}, {body(Ellipse{1.0, 0.2}, 0.0)}, 1e-10);
  alone = over(alone, 50.0, 0.05, SteppingMethod::rk4);
  alone.output.dt_write = 50.0;
  return run(alone, 1e-5, [](const RecordedRun& recorded) {
    return std::abs(recorded.frames.back().bodies[0].orientation - jeffery_angle(5.0, 50.0));
  });
}

// Returns a scene of two circles that a flow drives together, from a distance of 3 radii to
// nearly 2.
Scene approach(double t_final, double dt, SteppingMethod method) {
  return over(scene(ExtensionalFlow{-1.0}, {body(Circle{1.0}, -1.5), body(Circle{1.0}, 1.5)}, 1e-8),
              t_final, dt, method);
}

Finding long_first_step() {
  Scene pair = approach(2.0, 2.0, SteppingMethod::dormand_prince54);
  pair.time->tolerance = 1e-6;
  return run(pair, 1e-6, [](const RecordedRun& recorded) {
    const std::vector<BodyState>& bodies = recorded.frames.back().bodies;
    const bool was_too_long = recorded.totals.rejected_steps > 0;
    const double distance = std::abs(bodies[1].position - bodies[0].position);
    return was_too_long ? std::abs(distance - circle_distance(3.0, 2.0)) : unknown;
  });
}

Finding long_fixed_steps() {
  Scene pair = approach(8.0, 2.0, SteppingMethod::euler);
  pair.time->dt_min = 1.5;
  return run(pair, 1e-6, [](const RecordedRun&) { return unknown; });
}

}  // namespace

std::vector<HardCase> motions() {
  return {{"09", "a first step twenty times too long, adapted; distance in radii", long_first_step},
          {"09",
           "fixed steps into an overlap that may not be halved enough",
           long_fixed_steps,
           Due::refusal,
           {"overlap", "dt_min"}},
          {"09", "a thousand steps of an ellipse 5:1 in shear; angle", thousand_steps}};
}

}  // namespace stokesbook::verification::hard_cases
