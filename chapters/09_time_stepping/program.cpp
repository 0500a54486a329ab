// Chapter 09: an ellipse turned by four methods; a point that is carried past a disk by steps that
// know their error, with and without noise, and there and back.
//
//   chapter_09 [DIRECTORY]    prints tables; draws chapter_09_return.svg into the directory
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "time_stepping/stepper.hpp"

using namespace stokesbook;
using Eigen::VectorXd;

namespace {

// [rates]
/// The angle of an ellipse 3:1 in the flow (y, 0), by Jeffery's equation.
VectorXd turning(double, const VectorXd& q) {
  const double s = std::sin(q[0]), c = std::cos(q[0]);
  return VectorXd{{-(9.0 * s * s + c * c) / 10.0}};
}

/// A point in the flow (y, 0) past a free disk of radius 1 at the origin (09.12).
VectorXd carried(double, const VectorXd& q) {
  const double x = q[0], y = q[1], r2 = x * x + y * y, r4 = r2 * r2;
  const double strain = 0.5 * (1.0 - 1.0 / r4), radial = -2.0 * x * y * (r2 - 1.0) / (r4 * r2);
  return VectorXd{{0.5 * y + strain * y + radial * x, -0.5 * x + strain * x + radial * y}};
}
// [rates]

// [run]
struct Run {
  std::vector<Step> steps;
  int rejected = 0, evaluations = 0;
};

Run run(const SteppingSettings& settings, const Rate& f, const VectorXd& start, double t_end) {
  Run found;
  const Rate counted = [&](double t, const VectorXd& q) {
    ++found.evaluations;
    return f(t, q);
  };
  const Stepper stepper(settings, {counted, counted});
  TimePoint now{0.0, start, counted(0.0, start)};
  StepMemory memory;
  while (now.t < t_end) {
    StepResult taken = stepper.advance(now, std::move(memory), t_end);
    now = taken.step.end;
    memory = std::move(taken.memory);
    found.rejected += taken.rejected;
    found.steps.push_back(std::move(taken.step));
  }
  return found;
}

VectorXd end_of(const Run& run) {
  return run.steps.back().end.state;
}

SteppingSettings fixed(SteppingMethod method, double dt) {
  return {.method = method, .dt = dt};
}

SteppingSettings adapted(double tolerance) {  // a step may use half of the tolerance of the run
  return {.method = SteppingMethod::dormand_prince54,
          .bound = {0.5 * tolerance, VectorXd::Ones(2)}};
}
// [run]

// [orders]
void print_orders() {
  constexpr double t_end = 8.0, phase = 0.3 * t_end;
  const double exact = -std::atan2(std::sin(phase), 3.0 * std::cos(phase));  // by Jeffery
  std::puts("An ellipse 3:1 in shear: error of its angle at t = 8\n");
  std::puts(
      "   steps               Euler   Adams-Bashforth 2                Heun       Runge-Kutta 4");
  for (const int steps : {20, 40, 80, 160}) {
    std::printf("%8d", steps);
    for (const SteppingMethod method : {SteppingMethod::euler, SteppingMethod::adams_bashforth2,
                                        SteppingMethod::heun, SteppingMethod::rk4}) {
      const Run found = run(fixed(method, t_end / steps), turning, VectorXd::Zero(1), t_end);
      std::printf("%20.2e", std::abs(end_of(found)[0] - exact));
    }
    std::puts("");
  }
}
// [orders]

const VectorXd left{{-5.0, 0.2}};  // where the point begins
constexpr double t_past = 34.0;    // when it is as far on the right

// [tolerances]
void print_tolerances() {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> noise(-1e-5, 1e-5);
  const Rate noisy = [&](double t, const VectorXd& q) -> VectorXd {
    return carried(t, q) + VectorXd{{noise(random), noise(random)}};
  };
  const VectorXd exact = end_of(run(adapted(1e-13), carried, left, t_past));
  std::puts("\nA point carried past a disk by 5(4) until t = 34, without and with noise of 1e-5\n");
  std::puts("  tolerance    steps  rejected    shortest    longest      error      noisy: steps");
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Run found = run(adapted(tolerance), carried, left, t_past);
    const auto [shortest, longest] = std::ranges::minmax(found.steps, {}, &Step::dt);
    const auto with_noise = run(adapted(tolerance), noisy, left, t_past).steps.size();
    std::printf("%11.0e%9zu%10d%12.3f%11.3f%11.1e%18zu\n", tolerance, found.steps.size(),
                found.rejected, shortest.dt(), longest.dt(), (end_of(found) - exact).norm(),
                with_noise);
  }
}
// [tolerances]

// [return]
struct Return {
  Run there, back;
  double error = (end_of(back) - left).norm();
  int evaluations = there.evaluations + back.evaluations;
};

Return there_and_back(const SteppingSettings& settings) {
  const Rate reversed = [](double t, const VectorXd& q) -> VectorXd { return -carried(t, q); };
  const Run there = run(settings, carried, left, t_past);
  return {there, run(settings, reversed, end_of(there), t_past)};
}
// [return]

void print_returns() {
  std::puts("\nThe flow is reversed at t = 34: how far from its start the point ends\n");
  std::puts("                          evaluations    distance");
  const auto print = [](const char* name, const SteppingSettings& settings) {
    const Return found = there_and_back(settings);
    std::printf("%-26s%11d%12.1e\n", name, found.evaluations, found.error);
  };
  print("Euler, dt = 0.1", fixed(SteppingMethod::euler, 0.1));
  print("Euler, dt = 0.05", fixed(SteppingMethod::euler, 0.05));
  print("Heun, dt = 0.1", fixed(SteppingMethod::heun, 0.1));
  print("Heun, dt = 0.05", fixed(SteppingMethod::heun, 0.05));
  print("5(4), tolerance 1e-4", adapted(1e-4));
  print("5(4), tolerance 1e-8", adapted(1e-8));
}

// Draws a dot at the end of each step; the disk is a dot as well.
std::string dots(const std::vector<Step>& steps, double width, const std::string& colour) {
  std::string data;
  for (const Step& step : steps) {
    const VectorXd& q = step.end.state;
    const Complex z{330.0 + 60.0 * q[0], 120.0 - 60.0 * q[1]};
    data += svg::line(z, z);
  }
  return svg::path(data, "fill=\"none\" stroke-linecap=\"round\" stroke=\"" + colour + "\"" +
                             svg::attribute("stroke-width", width));
}

std::string picture_of_return() {
  const Return euler = there_and_back(fixed(SteppingMethod::euler, 0.05)),
               pair = there_and_back(adapted(1e-4));
  const std::vector<Step> disk{{{}, {1.0, VectorXd::Zero(2), {}}}};
  return svg::open({660.0, 240.0}, "A point passes a free disk in shear, and returns") +
         dots(disk, 120.0, "#999") + dots(euler.there.steps, 2.0, "#e8710a") +
         dots(euler.back.steps, 2.0, "#e8710a") + dots(pair.there.steps, 7.0, "#1c7ed6") +
         svg::label({10.0, 210.0}, "small dots: Euler's steps of 0.05, there and back") +
         svg::label({10.0, 230.0}, "large dots: steps there by 5(4) at a tolerance of 1e-4") +
         "</svg>\n";
}

}  // namespace

int main(int argc, char** argv) {
  print_orders();
  print_tolerances();
  print_returns();
  if (argc > 1) {
    write_atomically(std::filesystem::path(argv[1]) / "chapter_09_return.svg", picture_of_return(),
                     SafeFrom::kill);
  }
}
