// Chapter 14: free disks in a sheared lattice, and held disks in a square lattice.
//
//   chapter_14 [DIRECTORY]    prints viscosities and drags; draws chapter_14_period.svg into the
//                             directory
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <vector>

#include "closure/closure.hpp"
#include "double_layer/double_layer.hpp"
#include "fmm/fmm.hpp"
#include "krylov/gmres.hpp"
#include "periodic/far_operator.hpp"
#include "record/atomic_file.hpp"
#include "stress/stresslet.hpp"
#include "study/plot.hpp"

using namespace stokesbook;
using Eigen::VectorXd;

namespace {

// [cell]
// One disk in a unit cell that is sheared by gamma, in the shear flow (y, 0). The number of nodes
// grows with the ratio of the radius to the gap.
StokesProblem disk_in_cell(double area_fraction, double shear, ComponentKind kind) {
  const double radius = std::sqrt(area_fraction / std::numbers::pi), gap = 1.0 - 2.0 * radius;
  const auto nodes = 64 + 2 * static_cast<Eigen::Index>(14.0 * radius / gap);
  const Curve curve = sample(Circle{radius}, nodes, Side::fluid_outside);
  StokesProblem problem;
  problem.cell = {1.0, {shear, 1.0}};
  problem.components.push_back({kind, curve, {}, {}, 0.0, {}});
  problem.background = curve.x.imag().cast<Complex>();
  return problem;
}
// [cell]

struct Solved {
  std::size_t near_images;
  int iterations;
  ComplexVector density;  // without its rigid part
  Completion completion;
};

// [solve]
// The system of chapter 03; the fast sum adds the images, and nothing else is new.
Solved solve(const StokesProblem& problem) {
  const Lattice lattice(problem.cell->a1, problem.cell->a2);
  const Component& disk = problem.components[0];
  const Fmm fmm({disk.curve}, ComplexVector::Zero(1), FmmSettings::for_tolerance(1e-12),
                images_in(lattice));
  const Closure closure(problem);
  const auto sum = [&](const ComplexVector& density, const Load& load) -> ComplexVector {
    const ComplexVector force = ComplexVector::Constant(1, load.force);
    const VectorXd torque = VectorXd::Constant(1, load.torque);
    return fmm.velocity({density, force, torque}).topRows(density.size());
  };
  const LinearMap apply = [&](const VectorXd& v) -> VectorXd {
    const ComplexVector density = deinterleaved(v), rest = closure.without_rigid_part(density);
    const ComplexVector layer = diagonal_velocity(disk.curve, rest) - 0.5 * rest;
    return interleaved(layer + sum(rest, closure.density_loads(density)[0]) +
                       closure.smooth_velocity(density));
  };
  const ComplexVector none = ComplexVector::Zero(disk.curve.size());
  const ComplexVector rhs = closure.boundary_data() - sum(none, closure.given_loads()[0]);
  const GmresResult result = gmres(apply, {}, interleaved(rhs), {1e-10, 100});
  const ComplexVector density = deinterleaved(result.solution);
  return {near_images(lattice, fmm.cell().radius).size(), result.iterations,
          closure.without_rigid_part(density), closure.complete(density)};
}
// [solve]

// [rheology]
// Rotation, added viscosity and first normal stress difference; V, mu and the shear rate are 1.
struct Rheology {
  double omega, viscosity, normal_stress;
};

Rheology rheology_of(const StokesProblem& problem, const Solved& solved) {
  const Complex stresslet = body_stresslet(problem.components[0].curve, solved.density, 1.0);
  return {solved.completion.motions[0].omega, stresslet.imag(), 2.0 * stresslet.real()};
}
// [rheology]

// [drag]
// The drag over viscosity and mean velocity: from the force at the mean velocity 1, and from the
// mean velocity at the pressure gradient -1, when the force is -1.
double drag_at_velocity(StokesProblem problem) {
  problem.background.setOnes();
  return -solve(problem).completion.loads[0].force.real();
}

double drag_at_gradient(StokesProblem problem) {
  problem.background = {};
  problem.cell->pressure_gradient = -1.0;
  return 1.0 / solve(problem).completion.uniform_velocity.real();
}
// [drag]

study::Plot period_of(double area_fraction) {
  study::Plot plot{
      .title = "One free disk for each cell through a period of the lattice, area fraction 0.5",
      .x_label = "shear γ",
      .y_label = "in units of viscosity and shear rate",
      .log_x = false,
      .log_y = false,
      .lines = {{"added viscosity"},
                {"first normal stress difference"},
                {"rotation beside that of the mean flow"}}};
  for (int k = 0; k <= 50; ++k) {
    const double shear = 0.02 * k;
    const StokesProblem problem = disk_in_cell(area_fraction, shear, ComponentKind::free_body);
    const auto [omega, viscosity, normal_stress] = rheology_of(problem, solve(problem));
    plot.lines[0].points.push_back({shear, viscosity});
    plot.lines[1].points.push_back({shear, normal_stress});
    plot.lines[2].points.push_back({shear, omega + 0.5});
  }
  return plot;
}

}  // namespace

int main(int argc, char** argv) {
  std::puts("One free disk for each cell, area fraction 0.5, in shear\n");
  std::puts("shear  near images  iterations   rotation  viscosity       |N1|");
  for (const double shear : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0}) {
    const StokesProblem problem = disk_in_cell(0.5, shear, ComponentKind::free_body);
    const Solved solved = solve(problem);
    const auto [omega, viscosity, normal_stress] = rheology_of(problem, solved);
    std::printf("%5.1f %12zu %11d %10.6f %10.6f %10.6f\n", shear, solved.near_images,
                solved.iterations, omega, 1.0 + viscosity, std::abs(normal_stress));
  }
  std::puts("\nOne held disk for each square cell: drag over viscosity and mean velocity\n");
  std::puts("area fraction  at a mean velocity  at a pressure gradient  printed in 1982");
  for (const auto& [area_fraction, printed] : {std::pair{0.05, 15.56},
                                               {0.1, 24.83},
                                               {0.2, 51.53},
                                               {0.3, 102.90},
                                               {0.4, 217.89},
                                               {0.5, 532.55},
                                               {0.6, 1763.0},
                                               {0.7, 13520.0},
                                               {0.75, 126300.0}}) {
    const StokesProblem problem = disk_in_cell(area_fraction, 0.0, ComponentKind::prescribed);
    std::printf("%13.2f %19.4f %23.4f %16g\n", area_fraction, drag_at_velocity(problem),
                drag_at_gradient(problem), printed);
  }
  if (argc > 1) {
    write_atomically(std::filesystem::path(argv[1]) / "chapter_14_period.svg",
                     study::draw_plot(period_of(0.5)), SafeFrom::kill);
  }
}
