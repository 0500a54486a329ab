// Compares the relative errors of the same bodies in millimetres, metres and kilometres, which must
// be equal.
#include <algorithm>

#include "experiments.hpp"
#include "support/closed_forms.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;

namespace {

constexpr double viscosities[] = {1.0, 1.3};

/// Returns the relative error of the motion of a loaded ellipse. All lengths are multiples of one
/// length; the gauge length is given separately.
double loaded_error(double length, double gauge, ClosureForm form) {
  const Ellipse ellipse{1.7 * length, length};
  const Load load{{0.3, -1.1}, 0.6 * length};
  const double orientation = 0.4;
  double error = 0.0;
  for (const double mu : viscosities) {
    const StokesProblem problem{
        {free_body(ellipse, 64, {length * Complex{3.0, -2.0}, orientation}, load)}, mu, {}, gauge};
    const RigidMotion exact = loaded_ellipse(ellipse, orientation, load, mu, 7.0 * length);
    const RigidMotion motion = solve_dense(problem, form).motions[0];
    error = std::max(error, distance(motion, exact, length) / std::abs(exact.velocity));
  }
  return error;
}

/// Returns the relative error of the forces on two circles, one of which moves away from the other.
double held_error(double length, std::optional<double> gauge) {
  const CirclePair pair{length, 0.5 * length};
  const Complex along = std::polar(1.0, 0.35);
  const double half = length + 0.5 * pair.gap, speed = 0.8;
  double error = 0.0;
  for (const double mu : viscosities) {
    const StokesProblem problem{
        {held_body(Circle{length}, 96, {half * along, 0.35}, {speed * along}),
         held_body(Circle{length}, 96, {-half * along, 0.35}, {})},
        mu,
        {},
        gauge};
    const Completion result = solve_dense(problem, ClosureForm::reduced);
    const double force = 0.5 * speed / pair.speed_of_pull(1.0, mu);
    error = std::max({error, distance(result.loads[0], {force * along}, length) / force,
                      distance(result.loads[1], {-force * along}, length) / force});
  }
  return error;
}

/// A planted defect: the gauge length does not change with the unit of length.
constexpr double other_gauge = 5.0;

const std::vector<double> lengths = log_points(1e-8, 1e8, 17);
const std::string exact_up_to_rounding = "exact up to rounding, some hundreds of units";

Measure loaded(ClosureForm form) {
  return at(lengths, [=](double l) { return loaded_error(l, 7.0 * l, form); });
}

Line claimed_line(const std::string& key, const std::string& id, const std::string& label,
                  ClosureForm form) {
  return {.key = key,
          .label = label,
          .measure = loaded(form),
          .claim = Claim{.id = id,
                         .statement = "Motions under load do not depend on the units of length and "
                                      "viscosity.",
                         .law = Identity{1e-13},
                         .reason = exact_up_to_rounding,
                         .api = {"stokesbook::assemble", "stokesbook::complete_dense"}},
          .control =
              Control{"the gauge length kept when the unit changes",
                      at(lengths, [=](double l) { return loaded_error(l, other_gauge, form); })}};
}

}  // namespace

Experiment units() {
  return {.key = "units",
          .title = "Units of length",
          .x = "size of the bodies a",
          .error = "error of motion or load, relative to the largest entry",
          .lines = {{.key = "power",
                     .label = "Power's border",
                     .measure = loaded(ClosureForm::power_bordered)},
                    claimed_line("scaled", "03_28", "scaled border", ClosureForm::scaled_bordered),
                    claimed_line("reduced", "03_29", "reduced", ClosureForm::reduced),
                    {.key = "held",
                     .label = "reduced, two held circles",
                     .measure = at(lengths, [](double l) { return held_error(l, {}); }),
                     .claim = Claim{.id = "03_30",
                                    .statement = "Forces on two held circles in unbounded fluid, "
                                                 "which balance, are those of the closed form.",
                                    .law = Identity{1e-13},
                                    .reason = exact_up_to_rounding,
                                    .api = {"stokesbook::Closure"}},
                     .control = Control{
                         "Stokeslets of a fixed gauge length, forces not balanced",
                         at(lengths, [](double l) { return held_error(l, other_gauge); })}}}};
}

}  // namespace stokesbook::verification::closure
