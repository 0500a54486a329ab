// Chapters 09 to 12: the gap of two disks that forces press together, by the library's steppers.
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/LU>

#include "closure/bordered_system.hpp"
#include "interactive/numbers.hpp"
#include "time_stepping/stepper.hpp"

namespace {

// The closing speed of unit disks that forces 4 pi mu press together, in closed form.
double closing_speed(double gap) {
  const double alpha = 2.0 * std::asinh(std::sqrt(gap / 4.0));
  return 2.0 * alpha - std::tanh(2.0 * alpha);
}

// The same by the library's boundary integral equation.
double solved_closing_speed(double gap) {
  using namespace stokesbook;
  constexpr Eigen::Index n = 200;
  StokesProblem problem;
  for (const double side : {-1.0, 1.0}) {
    Component disk;
    disk.centre = side * (1.0 + gap / 2.0);
    disk.curve = place(sample(Circle{1.0}, n, Side::fluid_outside), disk.centre, 0.0);
    disk.force = -side * 4.0 * std::numbers::pi;
    problem.components.push_back(disk);
  }
  const DenseSystem system = assemble(problem, ClosureForm::reduced);
  const Eigen::VectorXd solution = system.matrix.partialPivLu().solve(system.rhs);
  const auto motions = complete_dense(problem, ClosureForm::reduced, solution).motions;
  return (motions[0].velocity - motions[1].velocity).real();
}

struct GapRun {
  double at_turn = 0.0, end = 0.0;
  int steps = 0;
};

// Steps to t = 4, and with reversed forces to `t_end`. Overlap ends the run, or the step is not admissible.
GapRun run_of_gap(double start, const stokesbook::SteppingSettings& settings, double t_end = 8.0) {
  GapRun run{.at_turn = start, .end = start};
  stokesbook::StepMemory memory;
  double t = 0.0;
  for (const auto& [event, sign] : {std::pair{4.0, -1.0}, {t_end, 1.0}}) {
    const stokesbook::Rate rate = [&settings, sign = sign](
                                      double, const Eigen::VectorXd& gap) -> Eigen::VectorXd {
      if (gap[0] > 0.0) return Eigen::VectorXd::Constant(1, sign * closing_speed(gap[0]));
      if (stokesbook::is_embedded(settings.method)) throw stokesbook::InadmissibleState("overlap");
      return Eigen::VectorXd::Zero(1);
    };
    const stokesbook::Stepper stepper(settings, {rate, rate});
    while (t < event && run.end > 0.0) {
      const Eigen::VectorXd state = Eigen::VectorXd::Constant(1, run.end);
      const auto result = stepper.advance({t, state, rate(t, state)}, memory, event);
      t = result.step.end.t;
      run.end = result.step.end.state[0];
      memory = result.memory;
      ++run.steps;
    }
    if (event == 4.0) run.at_turn = run.end;
  }
  return run;
}

stokesbook::SteppingSettings controlled_steps(double tolerance) {
  return {.method = stokesbook::SteppingMethod::bogacki_shampine32,
          .bound = {tolerance, Eigen::VectorXd::Ones(1)}};
}

interactive::Case disks_case(double time, double gap, int count, double digits) {
  const GapRun exact = run_of_gap(gap, {.method = stokesbook::SteppingMethod::prince_dormand87,
                                        .bound = {1e-12, Eigen::VectorXd::Ones(1)}});
  // The path back is the path there, so that the gap at a time before the turn is that of 8 - time.
  const GapRun part =
      run_of_gap(gap, {.method = stokesbook::SteppingMethod::rk4, .dt = 0.01}, 8.0 - time);
  const GapRun fixed =
      run_of_gap(gap, {.method = stokesbook::SteppingMethod::euler, .dt = 4.0 / count});
  const GapRun controlled = run_of_gap(gap, controlled_steps(std::pow(10.0, -digits)));
  return {.settings = {{"time", time}, {"gap", gap}, {"count", count}, {"digits", digits}},
          .numbers = {{"speed", solved_closing_speed(part.end)},
                      {"least", exact.at_turn},
                      {"fixed", fixed.at_turn},
                      {"controlled", controlled.at_turn},
                      {"back", fixed.end},
                      {"returned", controlled.end},
                      {"step", 4.0 / count},
                      {"taken", static_cast<double>(controlled.steps)}}};
}

}  // namespace

std::vector<interactive::Case> interactive::disks() {
  return {disks_case(1.0, 1.0, 8, 3.0), disks_case(0.5, 2.0, 1, 2.0),
          disks_case(1.5, 0.4, 67, 4.5)};
}
