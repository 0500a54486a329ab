// Chapter 09: an ellipse turned by four methods; two disks that pass each other and return; sweeps
// of the lagged coupling; iterations that guesses save.
//
//   chapter_09 [DIRECTORY]    prints tables; draws chapter_09_return.svg into the directory
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/motion/stepping.hpp"
#include "suspension/solver/density_history.hpp"

using namespace stokesbook;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

Scene ellipse() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.bodies = {{.shape = Ellipse{3.0, 1.0}, .n_nodes = 96}};
  scene.solver.tolerance = 1e-11;
  return scene;
}

/// Two disks that the shear drives past each other.
Scene passing() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  for (const Complex position : {Complex{-8.0, 0.5}, Complex{}}) {
    scene.bodies.push_back({.shape = Circle{0.5}, .position = position, .n_nodes = 64});
  }
  scene.solver.tolerance = 1e-10;
  return scene;
}

/// Seven ellipses about each other.
Scene cluster() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  const Ellipse shape{1.0, 0.6};
  scene.bodies.push_back({.shape = shape, .n_nodes = 96});
  for (int k = 0; k < 6; ++k) {
    scene.bodies.push_back({.shape = shape,
                            .position = std::polar(2.2, pi / 3.0 * k),
                            .orientation = 2.0 * k,
                            .n_nodes = 96});
  }
  scene.solver.tolerance = 1e-5;
  scene.solver.gmres_tol = 1e-8;
  return scene;
}

// [rate]
/// A scene as a right-hand side: each evaluation is a boundary integral solve, and is counted.
class Suspension {
 public:
  explicit Suspension(const Scene& scene)
      : solver_(scene), nodes_(resolutions_of(solver_.solve(solver_.start()).discretisation)) {}

  VectorXd start() const { return to_state(solver_.start().configuration); }
  int solves() const { return solves_; }

  /// @param  amplitude  of the flow: +1, or -1 where it is reversed
  Rate rate(double amplitude) {
    return [=, this](double, const VectorXd& state) {
      ++solves_;
      return to_rate(solver_.solve_nearby({to_configuration(state), amplitude}, nodes_));
    };
  }

 private:
  SuspensionSolver solver_;
  Resolutions nodes_;
  int solves_ = 0;
};
// [rate]

// [run]
std::vector<Step> run(const SteppingSettings& settings, const Rate& rate, const VectorXd& start,
                      double t_end) {
  const Stepper stepper(settings, {rate, rate});
  TimePoint now{0.0, start, rate(0.0, start)};
  StepMemory memory;
  std::vector<Step> steps;
  while (now.t < t_end) {
    StepResult taken = stepper.advance(now, std::move(memory), t_end);
    now = taken.step.end;
    memory = std::move(taken.memory);
    steps.push_back(std::move(taken.step));
  }
  return steps;
}
// [run]

SteppingSettings fixed(SteppingMethod method, double dt) {
  return {.method = method, .dt = dt};
}

SteppingSettings adapted(double tolerance) {
  const VectorXd scale{{0.5, 0.5, 1.0, 0.5, 0.5, 1.0}};  // a radius, a radian
  return {.method = SteppingMethod::dormand_prince54, .bound = {0.5 * tolerance, scale}};
}

/// Angle of the ellipse at t < 10 pi / 3, by Jeffery.
double jeffery(double t) {
  const double phase = 0.3 * t;
  return -std::atan2(std::sin(phase), 3.0 * std::cos(phase));
}

void print_orders() {
  constexpr double t_end = 8.0;
  std::puts("An ellipse 3:1 in shear: error of its angle at t = 8\n");
  std::printf("%8s%20s%20s%20s%20s\n", "steps", "Euler", "Adams-Bashforth 2", "Heun",
              "Runge-Kutta 4");
  for (const int steps : {20, 40, 80, 160}) {
    std::printf("%8d", steps);
    for (const SteppingMethod method : {SteppingMethod::euler, SteppingMethod::adams_bashforth2,
                                        SteppingMethod::heun, SteppingMethod::rk4}) {
      Suspension suspension(ellipse());
      const std::vector<Step> path =
          run(fixed(method, t_end / steps), suspension.rate(1.0), suspension.start(), t_end);
      std::printf("%20.2e", std::abs(path.back().end.state[2] - jeffery(t_end)));
    }
    std::puts("");
  }
}

// [return]
struct Return {
  std::vector<Step> there, back;
  int solves = 0;

  /// Distance of the centres from their start, over their distance from the origin.
  double error() const {
    const VectorXd first = there.front().start.state, last = back.back().end.state;
    const auto centres = [](const VectorXd& q) { return VectorXd{{q[0], q[1], q[3], q[4]}}; };
    return centres(last - first).norm() / centres(first).norm();
  }
};

Return there_and_back(const SteppingSettings& settings) {
  Suspension suspension(passing());
  constexpr double t_reversal = 20.0;
  const std::vector<Step> there =
      run(settings, suspension.rate(1.0), suspension.start(), t_reversal);
  const std::vector<Step> back =
      run(settings, suspension.rate(-1.0), there.back().end.state, t_reversal);
  return {there, back, suspension.solves()};
}
// [return]

void print_returns() {
  std::puts("\nTwo disks in shear, reversed at t = 20: how far from their start they end\n");
  std::puts("                            solves    distance");
  const auto print = [](const std::string& name, const SteppingSettings& settings) {
    const Return found = there_and_back(settings);
    std::printf("%-26s%8d%12.1e\n", name.c_str(), found.solves, found.error());
  };
  print("Euler, dt = 0.1", fixed(SteppingMethod::euler, 0.1));
  print("Euler, dt = 0.025", fixed(SteppingMethod::euler, 0.025));
  print("Heun, dt = 0.1", fixed(SteppingMethod::heun, 0.1));
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    char name[40];
    std::snprintf(name, sizeof name, "5(4), tolerance %.0e", tolerance);
    print(name, adapted(tolerance));
  }
}

// [sweeps]
/// Block Jacobi on two circles: the lagged coupling again and again, nothing moving.
struct Sweeps {
  double factor = 0.0;  ///< of the error, by one sweep
  int count = 0;        ///< for six digits
  int gmres = 0;        ///< iterations for the same
};

Sweeps sweep(double gap) {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  for (const double side : {-1.0, 1.0}) {
    scene.bodies.push_back(
        {.shape = Circle{1.0}, .position = side * (1.0 + 0.5 * gap), .n_nodes = 128});
  }
  scene.solver.preconditioner = PreconditionerKind::block_diagonal;
  scene.solver.tolerance = 1e-6;
  scene.solver.gmres_tol = 1e-10;
  const SuspensionSolver solver(scene);
  const Instant still = solver.start();
  const Solution solution = solver.solve(still);
  const ComplexVector& exact = solution.density;

  Sweeps sweeps;
  for (const double residual : solution.gmres.history) sweeps.gmres += residual > 1e-6 ? 1 : 0;
  ComplexVector density = ComplexVector::Zero(exact.size());
  for (double error = exact.norm(); error > 1e-6 * exact.norm(); ++sweeps.count) {
    const auto before = [&](const Discretisation&) { return density; };
    density = solver.solve_lagged(still, before).density;
    const double next = (density - exact).norm();
    sweeps.factor = next / error;
    error = next;
  }
  return sweeps;
}
// [sweeps]

void print_sweeps() {
  std::puts("\nTwo circles of radius 1 in shear: sweeps of the lagged coupling\n");
  std::puts("     gap    factor    formula    sweeps to 1e-6    GMRES to 1e-6");
  for (const double gap : {1.0, 0.5, 0.2, 0.1, 0.05}) {
    const double alpha = std::acosh(1.0 + 0.5 * gap);
    const double formula = std::exp(-4.0 * alpha + std::asinh(2.0 * std::sinh(2.0 * alpha)));
    const auto [factor, count, gmres] = sweep(gap);
    std::printf("%8.2f%10.4f%11.4f%18d%17d\n", gap, factor, formula, count, gmres);
  }
}

// [warm]
/// Iterations a solve in a moving cluster, with guesses from some earlier densities.
double iterations(std::size_t kept) {
  const SuspensionSolver solver(cluster());
  DensityHistory history(std::max<std::size_t>(kept, 1));
  int solves = 0, iterations = 0;
  const Rate rate = [&](double t, const VectorXd& state) {
    const Configuration now = to_configuration(state);
    const auto guess = [&](const Discretisation& discretisation) -> ComplexVector {
      if (kept == 0) return {};
      return history.guess(t, now, discretisation);
    };
    const Solution solution = solver.solve({now}, guess);
    history.add(t, now, solution.discretisation, solution.density);
    ++solves;
    iterations += solution.gmres.iterations;
    return to_rate(solution);
  };
  run(fixed(SteppingMethod::adams_bashforth2, 0.025), rate, to_state(solver.start().configuration),
      1.0);
  return static_cast<double>(iterations) / solves;
}
// [warm]

void print_iterations() {
  std::puts(
      "\nSeven ellipses: iterations of GMRES a solve, with guesses from k earlier densities\n");
  for (const std::size_t kept : {0U, 1U, 2U, 3U, 4U, 6U}) {
    std::printf("  k = %zu%8.1f\n", kept, iterations(kept));
  }
}

/// @name The picture: the first disk's centre on its way there and back
/// @{
Complex to_pixel(Complex z) {
  return {530.0 + 50.0 * z.real(), 300.0 - 260.0 * z.imag()};
}

std::string path_of(const std::vector<Step>& steps) {
  ComplexVector points(static_cast<Eigen::Index>(20 * steps.size()));
  Eigen::Index i = 0;
  for (const Step& step : steps) {
    for (int part = 0; part < 20; ++part) {
      const VectorXd state = interpolate(step, step.start.t + step.dt() * part / 19.0);
      points[i++] = to_pixel({state[0], state[1]});
    }
  }
  return svg::polyline(points);
}

std::string dots_of(const std::vector<Step>& steps) {
  std::string dots;
  for (const Step& step : steps) {
    const Complex z = to_pixel({step.end.state[0], step.end.state[1]});
    dots += svg::line(z, z);
  }
  return dots;
}

std::string stroke(const std::string& colour, double width) {
  return "fill=\"none\" stroke-linecap=\"round\" stroke=\"" + colour + "\"" +
         svg::attribute("stroke-width", width);
}
/// @}

std::string picture_of_return() {
  const Return euler = there_and_back(fixed(SteppingMethod::euler, 0.1)),
               pair = there_and_back(adapted(1e-4));
  const Complex start = to_pixel({-8.0, 0.5});
  return svg::open({660.0, 260.0}, "A disk passes another one and returns") +
         svg::path(path_of(euler.there) + path_of(euler.back), stroke("#e8710a", 1.6)) +
         svg::path(path_of(pair.there) + path_of(pair.back), stroke("#1c7ed6", 1.6)) +
         svg::path(dots_of(pair.there), stroke("#1c7ed6", 6.0)) +
         svg::path(svg::line(start, start), stroke("currentColor", 9.0)) +
         svg::label(start + Complex{-14.0, 22.0}, "start") +
         svg::label({20.0, 222.0}, "orange: Euler, " + std::to_string(euler.solves) + " solves") +
         svg::label({20.0, 244.0}, "blue: 5(4) at 1e-4, " + std::to_string(pair.solves) +
                                       " solves; dots: ends of its steps there") +
         "</svg>\n";
}

}  // namespace

int main(int argc, char** argv) {
  print_orders();
  print_returns();
  print_sweeps();
  print_iterations();
  if (argc > 1) {
    write_atomically(std::filesystem::path(argv[1]) / "chapter_09_return.svg", picture_of_return(),
                     SafeFrom::kill);
  }
}
