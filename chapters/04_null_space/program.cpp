// Chapter 04: a journal bearing. A shaft turns in a wider bushing that is full of viscous fluid.
//
//   chapter_04 [DIRECTORY]    prints tables; draws chapter_04_bearing.svg into the directory
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <vector>

#include <Eigen/LU>

#include "closure/bordered_system.hpp"
#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "null_space/null_space.hpp"
#include "record/atomic_file.hpp"
#include "record/svg.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

constexpr double pi = std::numbers::pi;

// [bearing]
// A shaft of radius 1 about the origin, and a bushing whose centre lies e above it.
struct Bearing {
  double radius, e;    // of the bushing, less than radius - 1
  double omega = 1.0;  // of the shaft, counter-clockwise
  double leak = 0.0;   // mean speed at which fluid passes out through the bushing
  double viscosity = 1.0;
};

StokesProblem problem(const Bearing& bearing, Index n) {
  const Complex above{0.0, bearing.e};
  Component shaft, bushing;
  shaft.kind = ComponentKind::prescribed;
  shaft.curve = sample(Circle{1.0}, n, Side::fluid_outside);
  shaft.velocity = imaginary * bearing.omega * shaft.curve.x;
  bushing.kind = ComponentKind::enclosing_wall;
  bushing.curve = place(sample(Circle{bearing.radius}, n, Side::fluid_inside), above, 0.0);
  bushing.centre = above;
  const ComplexVector normal = normals(bushing.curve);
  bushing.velocity = bearing.leak * (1.0 + normal.array().real()) * normal.array();  // to the right
  return {{shaft, bushing}, bearing.viscosity, {}, {}};
}
// [bearing]

// [solve]
// The dense system of chapter 03, and N_0 on the wall's block.
Eigen::VectorXd solve(const StokesProblem& problem, double factor = 1.0) {
  DenseSystem system = assemble(problem, ClosureForm::reduced);
  const Curve& wall = problem.components[1].curve;
  const Index size = 2 * wall.size();
  system.matrix.bottomRightCorner(size, size) += factor * null_space_matrix(wall);
  return system.matrix.partialPivLu().solve(system.rhs);
}

Load load_of_shaft(const StokesProblem& problem, const Eigen::VectorXd& solution) {
  return complete_dense(problem, ClosureForm::reduced, solution).loads[0];
}
// [solve]

// [closed form]
// The shaft's load by Jeffery and Wannier: a force along 1, across the line of centres.
Load exact_load(const Bearing& bearing) {
  const double r = bearing.radius, e = bearing.e, sum = 1.0 + r * r, difference = r * r - 1.0;
  const double tau = std::acosh((sum - e * e) / (2.0 * r)), s = r * std::sinh(tau) / e;
  const double f = -e * bearing.omega / (2.0 * tau * sum - 4.0 * s * e), stretch = tau * f / e;
  const double a = 0.25 / std::tanh(tau) * (bearing.omega - 2.0 * difference * stretch);
  const double scale = 8.0 * pi * bearing.viscosity;
  return {scale * f, scale * (a + f * (difference - e * e) / (2.0 * e))};
}
// [closed form]

// [nodes]
// Loads err as e^{-tau N} or e^{-2 d N}, whichever is more, times powers of N: e^-48 is enough.
Index nodes_needed(const Bearing& bearing) {
  const double r = bearing.radius, e = bearing.e, d = std::log(r / (1.0 + e));
  const double tau = std::acosh((1.0 + r * r - e * e) / (2.0 * r));
  return 2 * static_cast<Index>(std::ceil(24.0 / std::min(tau, 2.0 * d)));
}
// [nodes]

void print_loads() {
  std::printf("%12s %6s %20s %20s %10s\n", "eccentricity", "N", "force across", "torque", "error");
  for (const double part : {0.1, 0.3, 0.5, 0.7, 0.8}) {
    const Bearing bearing{.radius = 1.5, .e = 0.5 * part};
    const StokesProblem data = problem(bearing, nodes_needed(bearing));
    const Load load = load_of_shaft(data, solve(data)), exact = exact_load(bearing);
    const double error = std::hypot(std::abs(load.force - exact.force), load.torque - exact.torque);
    std::printf("%12.1f %6td %20.13f %20.13f %10.1e\n", part, data.components[0].curve.size(),
                load.force.real(), load.torque, error / std::abs(exact.torque));
  }
}

// [leak]
// The same bearing with a bushing that lets fluid out: no incompressible flow can do that.
void print_leak() {
  std::printf("\n%8s %12s %14s %22s %22s\n", "leak", "net flux", "of |g|", "force, with N_0",
              "force, without");
  for (const double leak : {0.0, 1e-6, 1e-3}) {
    const StokesProblem data = problem({.radius = 1.5, .e = 0.25, .leak = leak}, 128);
    std::printf("%8.0e %12.1e %14.1e %22.13f %22.13f\n", leak, net_flux(data),
                net_flux(data) / flux_scale(data), load_of_shaft(data, solve(data)).force.real(),
                load_of_shaft(data, solve(data, 0.0)).force.real());
  }
}
// [leak]

// [flow]
// The velocity in the gap, from a solution.
class Flow {
 public:
  Flow(const StokesProblem& problem, const Eigen::VectorXd& solution)
      : closure_(problem),
        completion_(closure_.complete(deinterleaved(solution))),
        density_(closure_.without_rigid_part(deinterleaved(solution))),
        layer_({problem.components[0].curve, problem.components[1].curve}) {}

  ComplexVector operator()(const ComplexVector& points) const {
    return layer_(points, density_) + closure_.singular_velocity(completion_, points);
  }

 private:
  Closure closure_;
  Completion completion_;
  ComplexVector density_;
  StressletSum layer_;
};
// [flow]

// Streamlines through points: polygons of steps of one length, by the classical Runge-Kutta method,
// until they come back to where they started.
std::vector<std::vector<Complex>> streamlines(const Flow& flow,
                                              const std::vector<Complex>& starts) {
  constexpr double step = 0.04;
  constexpr std::size_t most_steps = 1000;  // the longest line has a third of them
  const auto direction = [&](Complex x) {
    const Complex u = flow(ComplexVector::Constant(1, x))[0];
    return u / std::abs(u);
  };
  std::vector<std::vector<Complex>> lines;
  for (const Complex start : starts) {
    std::vector<Complex> line{start};
    while (line.size() < 3 || std::abs(line.back() - start) > 0.7 * step) {
      if (line.size() > most_steps) throw std::runtime_error("a streamline does not close");
      const Complex x = line.back(), k1 = direction(x), k2 = direction(x + 0.5 * step * k1),
                    k3 = direction(x + 0.5 * step * k2), k4 = direction(x + step * k3);
      line.push_back(x + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4));
    }
    lines.push_back(line);
  }
  return lines;
}

// Shaft, bushing, and streamlines through the widest part of the gap, up to the centre of an eddy:
// some go round the shaft, the others round the eddy.
std::string picture() {
  const Bearing bearing{.radius = 2.0, .e = 0.6};
  const StokesProblem data = problem(bearing, 192);
  std::vector<Complex> starts;
  for (int k = 1; k < 10; ++k) starts.emplace_back(0.0, 1.0 + 0.125 * k);
  const auto pixel = [](Complex x) { return 110.0 * std::conj(x) + Complex(230.0, 296.0); };
  std::string paths;
  for (const std::vector<Complex>& line : streamlines(Flow(data, solve(data)), starts)) {
    const Eigen::Map<const ComplexVector> points(line.data(), static_cast<Index>(line.size()));
    paths += svg::polygon(points.unaryExpr(pixel));
  }
  const std::string stroke = "stroke=\"currentColor\" ";
  return svg::open({460.0, 460.0}, "Streamlines between a turning shaft and its bushing") +
         svg::path(paths, stroke + "fill=\"none\" stroke-opacity=\"0.6\"") +
         svg::path(svg::polygon(data.components[0].curve.x.unaryExpr(pixel)),
                   stroke + "stroke-width=\"2\" fill=\"currentColor\" fill-opacity=\"0.15\"") +
         svg::path(svg::polygon(data.components[1].curve.x.unaryExpr(pixel)),
                   stroke + "stroke-width=\"2\" fill=\"none\"") +
         "</svg>\n";
}

}  // namespace

int main(int argc, char** argv) {
  print_loads();
  print_leak();
  if (argc > 1) {
    write_atomically(std::filesystem::path(argv[1]) / "chapter_04_bearing.svg", picture(),
                     SafeFrom::kill);
  }
}
