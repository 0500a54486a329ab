// Chapter 03: the mobility of a body without symmetry, the turn of an ellipse in shear, and the
// flow around an ellipse that settles at an angle.
//
//   chapter_03 [DIRECTORY]     also draws DIRECTORY/chapter_03_settling.svg
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <vector>

#include <Eigen/LU>

#include "closure/bordered_system.hpp"
#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "record/atomic_file.hpp"
#include "record/svg.hpp"

using namespace stokesbook;
using std::numbers::pi;

namespace {

constexpr double viscosity = 1.3;

// [body]
Component free_body(const Shape& shape, Eigen::Index nodes, double orientation) {
  const Curve curve = place(sample(shape, nodes, Side::fluid_outside), 0.0, orientation);
  return {.kind = ComponentKind::free_body,
          .curve = curve,
          .centre = 0.0,
          .force = {},
          .torque = 0.0,
          .velocity = {}};
}

// r = 1 + 0.2 cos 2t + 0.15 cos(3t + 1), times a length.
NodalCurve pebble(double length) {
  NodalCurve shape{ComplexVector(16), {}};
  for (int j = 0; j < 16; ++j) {
    const double t = 2.0 * pi * j / 16.0;
    const double r = length * (1.0 + 0.2 * std::cos(2.0 * t) + 0.15 * std::cos(3.0 * t + 1.0));
    shape.points[j] = std::polar(r, t);
  }
  return shape;
}
// [body]

// [solve]
RigidMotion motion(const StokesProblem& problem, ClosureForm form) {
  const DenseSystem system = assemble(problem, form);
  const Eigen::VectorXd solution = system.matrix.partialPivLu().solve(system.rhs);
  return complete_dense(problem, form, solution).motions[0];
}
// [solve]

// [mobility]
Eigen::Matrix3d mobility(StokesProblem problem) {
  Eigen::Matrix3d matrix;
  Component& body = problem.components[0];
  for (int column = 0; column < 3; ++column) {
    body.force = column == 0 ? Complex{1.0} : column == 1 ? imaginary : Complex{};
    body.torque = column == 2 ? 1.0 : 0.0;
    const RigidMotion m = motion(problem, ClosureForm::reduced);
    matrix.col(column) << m.velocity.real(), m.velocity.imag(), m.omega;
  }
  return matrix;
}
// [mobility]

// [condition]
double condition(const StokesProblem& problem, ClosureForm form) {
  const Eigen::MatrixXd matrix = assemble(problem, form).matrix;
  const auto norm = [](const Eigen::MatrixXd& a) {
    return a.cwiseAbs().rowwise().sum().maxCoeff();
  };
  return norm(matrix) * norm(matrix.partialPivLu().inverse());
}
// [condition]

void print_mobility() {
  const StokesProblem problem{{free_body(pebble(1.0), 128, 0.0)}, viscosity, {}, 100.0};
  const Eigen::Matrix3d m = mobility(problem);
  std::puts("Mobility of a pebble, (U_1, U_2, omega) by columns (F_1, F_2, L):");
  for (int i = 0; i < 3; ++i) std::printf("%14.10f %14.10f %14.10f\n", m(i, 0), m(i, 1), m(i, 2));
  std::printf("largest |M - M^T|: %.0e\n", (m - m.transpose()).cwiseAbs().maxCoeff());
}

void print_conditions() {
  std::puts("\nCondition number in the maximum norm:");
  std::puts("  size of the pebble     Power  scaled border  reduced");
  for (const double length : {1e-3, 1.0, 1e3}) {
    const StokesProblem problem{{free_body(pebble(length), 64, 0.0)}, viscosity, {}, {}};
    std::printf(
        "%20.0e %9.1e %14.1f %8.1f\n", length, condition(problem, ClosureForm::power_bordered),
        condition(problem, ClosureForm::scaled_bordered), condition(problem, ClosureForm::reduced));
  }
}

// [jeffery]
void print_turns() {
  const double a = 3.0, b = 1.0, rate = 1.0;
  std::puts("\nTurn of a free ellipse 3:1 in the shear flow (y, 0):");
  std::puts("  angle     computed      Jeffery");
  for (const double angle : {0.0, pi / 6.0, pi / 3.0, pi / 2.0}) {
    const Component body = free_body(Ellipse{a, b}, 96, angle);
    const ComplexVector flow = rate * body.curve.x.imag().cast<Complex>();
    const double omega = motion({{body}, viscosity, flow, {}}, ClosureForm::reduced).omega;
    const double jeffery = -rate *
                           (std::pow(a * std::sin(angle), 2) + std::pow(b * std::cos(angle), 2)) /
                           (a * a + b * b);
    std::printf("%7.4f %12.9f %12.9f\n", angle, omega, jeffery);
  }
}
// [jeffery]

// [flow]
// A settling ellipse: how it moves, and the fluid's velocity relative to it.
struct Settling {
  RigidMotion motion;
  ComplexVector velocity;
};

Settling settle(const StokesProblem& problem, const ComplexVector& points) {
  const DenseSystem system = assemble(problem, ClosureForm::reduced);
  const Eigen::VectorXd solution = system.matrix.partialPivLu().solve(system.rhs);
  const ComplexVector density = deinterleaved(solution);
  const Closure closure(problem);
  const Completion completion = closure.complete(density);
  const StressletSum double_layer({problem.components[0].curve});
  const ComplexVector velocity =
      double_layer(points, density) + closure.singular_velocity(completion, points);
  const RigidMotion motion = completion.motions[0];
  return {motion, (velocity.array() - motion.velocity).matrix()};
}
// [flow]

constexpr double tilt = 0.6;

StokesProblem settling_problem() {
  Component body = free_body(Ellipse{1.0, 0.4}, 128, tilt);
  body.force = -imaginary;
  return {{body}, viscosity, {}, 20.0};
}

// Points of a grid that are not too near the ellipse for plain sums.
ComplexVector grid_around_ellipse() {
  std::vector<Complex> points;
  for (double y = -2.4; y <= 2.4; y += 0.3) {
    for (double x = -3.0; x <= 3.0; x += 0.3) {
      const Complex own = Complex{x, y} * std::polar(1.0, -tilt);
      if (std::hypot(own.real() / 1.15, own.imag() / 0.55) > 1.0) points.emplace_back(x, y);
    }
  }
  return Eigen::Map<const ComplexVector>(points.data(), std::ssize(points));
}

Complex pixel(Complex z) {
  return {320.0 + 96.0 * z.real(), 256.0 - 96.0 * z.imag()};
}

std::string arrow(Complex from, Complex to) {
  const Complex barb = 0.3 * (from - to);
  return svg::line(pixel(from), pixel(to)) +
         svg::line(pixel(to + barb * std::polar(1.0, 0.4)), pixel(to)) +
         svg::line(pixel(to + barb * std::polar(1.0, -0.4)), pixel(to));
}

void draw(const Settling& settling, const ComplexVector& points,
          const std::filesystem::path& file) {
  const double scale = 0.3 / settling.velocity.cwiseAbs().maxCoeff();
  std::string arrows;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Complex half = 0.5 * scale * settling.velocity[i];
    arrows += arrow(points[i] - half, points[i] + half);
  }
  const Complex course = settling.motion.velocity / std::abs(settling.motion.velocity);
  const ComplexVector outline = settling_problem().components[0].curve.x.unaryExpr(&pixel);
  const std::string picture =
      svg::open({640.0, 512.0}, "Flow past an ellipse that settles at an angle") +
      svg::path(svg::polygon(outline),
                "fill=\"currentColor\" fill-opacity=\"0.15\" stroke=\"currentColor\"") +
      svg::path(arrows, "fill=\"none\" stroke=\"currentColor\"") +
      svg::path(arrow(0.0, 0.35 * course),
                "fill=\"none\" stroke=\"currentColor\" stroke-width=\"3\"") +
      "</svg>\n";
  write_atomically(file, picture, SafeFrom::kill);
}

}  // namespace

int main(int argc, char** argv) {
  print_mobility();
  print_conditions();
  print_turns();
  const ComplexVector points = grid_around_ellipse();
  const Settling settling = settle(settling_problem(), points);
  const double drift = std::arg(-imaginary / settling.motion.velocity);
  std::printf(
      "\nAn ellipse 5:2, tilted by %.0f degrees and pulled straight down, slides %.1f degrees to "
      "the "
      "left.\n",
      180.0 / pi * tilt, 180.0 / pi * drift);
  if (argc > 1) draw(settling, points, std::filesystem::path(argv[1]) / "chapter_03_settling.svg");
}
