// Chapter 07: a disk sinks past an ellipse in a round vessel. Where does the pressure push, where
// does the energy go, and what do bodies do to the viscosity?
//
//   chapter_07 [DIRECTORY]    prints tables; draws chapter_07_pressure.svg and
//                             chapter_07_dissipation.svg into the directory
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "closure/bordered_system.hpp"
#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"
#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "stress/dissipation.hpp"
#include "stress/stress.hpp"
#include "stress/stresslet.hpp"
#include "stress/traction.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double viscosity = 1.0;

// [problem]
Component free_body(const Shape& shape, Index n, Complex centre, double orientation) {
  const Curve curve = place(sample(shape, n, Side::fluid_outside), centre, orientation);
  return {ComponentKind::free_body, curve, centre, {}, 0.0, {}};
}

Component vessel(double radius, Index n) {
  const Curve curve = sample(Circle{radius}, n, Side::fluid_inside);
  return {ComponentKind::enclosing_wall, curve, {}, {}, 0.0, ComplexVector::Zero(n)};
}

StokesProblem sinking_disk() {
  Component disk = free_body(Circle{0.5}, 160, {0.6, 0.6}, 0.0);
  disk.force = {0.0, -1.0};
  return {{disk, free_body(Ellipse{0.8, 0.35}, 160, {-0.6, -0.4}, 0.6), vessel(2.0, 192)},
          viscosity,
          {},
          {}};
}
// [problem]

// [solve]
// The system of chapter 04 by elimination; the wall is the last component.
SolvedFlow solve(const StokesProblem& problem) {
  DenseSystem system = assemble(problem, ClosureForm::reduced);
  const Curve& wall = problem.components.back().curve;
  const Index size = 2 * wall.size();
  system.matrix.bottomRightCorner(size, size) += null_space_matrix(wall);
  const Eigen::VectorXd density = system.matrix.partialPivLu().solve(system.rhs);
  return SolvedFlow(problem, cauchy_curves(problem), deinterleaved(density));
}
// [solve]

// [loads]
// Without the sign of what is rounded to zero.
double shown(double x) {
  return std::abs(x) < 5e-5 ? 0.0 : x;
}

void print_loads(const SolvedFlow& flow, const ComplexVector& traction) {
  const char* const names[]{"disk", "ellipse", "vessel"};
  const std::vector<Load> integrated = integrated_loads(flow.problem(), traction);
  std::printf("%8s %26s %28s %10s\n", "", "force and torque", "integrated traction", "difference");
  for (std::size_t k = 0; k < 3; ++k) {
    const Load &load = flow.completion().loads[k], &found = integrated[k];
    std::printf("%8s %8.4f %8.4f %8.4f   %8.4f %8.4f %8.4f %10.1e\n", names[k],
                shown(load.force.real()), shown(load.force.imag()), shown(load.torque),
                shown(found.force.real()), shown(found.force.imag()), shown(found.torque),
                std::max(std::abs(load.force - found.force), std::abs(load.torque - found.torque)));
  }
}
// [loads]

// [dissipation]
void print_dissipation(const SolvedFlow& flow, const ComplexVector& traction) {
  const auto sum = [](const std::vector<double>& terms) {
    return std::accumulate(terms.begin(), terms.end(), 0.0);
  };
  const FluidQuadrature rule = fluid_quadrature(curves_of(flow.problem()));
  std::printf("\ndissipation\n");
  std::printf("  motions times loads          %16.13f\n", sum(power_of_loads(flow)));
  std::printf("  velocities times tractions   %16.13f\n", sum(boundary_power(flow, traction)));
  std::printf("  2 mu e:e over the fluid      %16.13f, %td points\n",
              volume_dissipation(rule, flow.derivatives(rule.points), viscosity),
              rule.points.size());
}
// [dissipation]

// [approach]
// Pressure on a line that ends in a node at the front of the disk, above the datum of that node.
void print_approach(const SolvedFlow& flow) {
  const Curve& disk = flow.problem().components[0].curve;
  const Index front = 3 * disk.size() / 4;
  const Complex node = disk.x[front], outward = -normals(disk)[front];
  std::printf("\n%10s %20s %20s\n", "distance", "pressure rise", "over the distance");
  const double surface = flow.derivatives(ComplexVector{{node}})[0].pressure;
  for (const double distance : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const double pressure =
        flow.derivatives(ComplexVector{{node + distance * outward}})[0].pressure;
    std::printf("%10.0e %20.15f %20.6f\n", distance, pressure - surface,
                (pressure - surface) / distance);
  }
}
// [approach]

// [viscosity]
// A disk in a vessel of radius 1 whose wall is strained as by u = (x, -y): what the wall has to do,
// over what it would have to do alone, and the same from the disk's stresslet.
void print_viscosity() {
  const Complex strain = 2.0;  // e_11 - e_22
  std::printf("\n%8s %18s %18s %12s\n", "fraction", "by dissipation", "by stresslet", "1 + 2 p");
  for (const double fraction : {0.01, 0.1, 0.3, 0.5}) {
    StokesProblem problem{{free_body(Circle{std::sqrt(fraction)}, 128, {}, 0.0), vessel(1.0, 128)},
                          viscosity,
                          {},
                          {}};
    problem.components[1].velocity = problem.components[1].curve.x.conjugate();
    const SolvedFlow flow = solve(problem);
    const double alone = viscosity * std::norm(strain) * pi;
    const Complex stresslet =
        body_stresslet(problem.components[0].curve, flow.density().head(128), viscosity);
    std::printf("%8.2f %18.12f %18.12f %12.2f\n", fraction, power_of_loads(flow)[1] / alone,
                1.0 + intrinsic_viscosity(stresslet, strain, pi, viscosity), 1.0 + 2.0 * fraction);
  }
}
// [viscosity]

// Squares of a grid whose middle lies in the fluid, and the flow's derivatives there.
struct Field {
  std::vector<Complex> points;
  std::vector<FlowDerivatives> at;
};

constexpr int cells = 130;
constexpr double cell = 4.1 / cells;

Field sample_field(const SolvedFlow& flow) {
  const std::vector<PlacedCurve> curves = cauchy_curves(flow.problem());
  const auto in_fluid = [&](Complex z) {
    return std::ranges::all_of(curves, [&](const PlacedCurve& placed) {
      return std::get<std::shared_ptr<const CauchyCurve>>(placed.scheme)
          ->in_fluid(z - placed.position);
    });
  };
  Field field;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const Complex z = cell * Complex{i - 0.5 * (cells - 1), j - 0.5 * (cells - 1)};
      if (in_fluid(z)) field.points.push_back(z);
    }
  }
  const auto m = static_cast<Index>(field.points.size());
  field.at = flow.derivatives(Eigen::Map<const ComplexVector>(field.points.data(), m));
  return field;
}

Complex pixel(Complex z) {
  return 110.0 * std::conj(z) + Complex(230.0, 230.0);
}

// Squares of one colour and one row are one rectangle, rectangles of one colour are one path.
std::string squares(const std::vector<Complex>& points, const std::vector<double>& fractions,
                    const ColourMap& colours) {
  constexpr int shades = 40;
  std::map<int, std::string> paths;
  const auto shade = [&](std::size_t i) {
    return static_cast<int>(std::lround(shades * std::clamp(fractions[i], 0.0, 1.0)));
  };
  for (std::size_t first = 0, next = 0; first < points.size(); first = next) {
    next = first + 1;
    while (next < points.size() && shade(next) == shade(first) &&
           std::abs(points[next] - points[next - 1] - cell) < 0.1 * cell) {
      ++next;
    }
    const Complex half = 0.5 * cell * Complex{1.0, 1.0};
    const Complex from = points[first] - half, to = points[next - 1] + half;
    paths[shade(first)] += svg::polygon(
        ComplexVector{{from, {to.real(), from.imag()}, to, {from.real(), to.imag()}}}.unaryExpr(
            &pixel));
  }
  std::string map;
  for (const auto& [level, data] : paths) {
    const std::string fill = colour(colours, static_cast<double>(level) / shades);
    map += svg::path(data, "fill=\"" + fill + "\" stroke=\"" + fill + "\" stroke-width=\"0.5\"");
  }
  return map;
}

std::string outlines(const StokesProblem& problem) {
  std::string paths;
  for (const Component& component : problem.components) {
    paths += svg::polygon(component.curve.x.unaryExpr(&pixel));
  }
  return svg::path(paths, "fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.5\"");
}

// Force of the fluid on the free bodies, -sigma n, as lines that start at every eighth node.
std::string arrows(const StokesProblem& problem, const ComplexVector& traction) {
  std::string lines;
  Index first = 0;
  for (const Component& component : problem.components) {
    if (component.kind == ComponentKind::enclosing_wall) continue;
    const ComplexVector& x = component.curve.x;
    for (Index j = 0; j < x.size(); j += 8) {
      lines += svg::line(pixel(x[j]), pixel(x[j] - 0.6 * traction[first + j]));
    }
    first += x.size();
  }
  return svg::path(lines, "fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.2\"");
}

// A bar of the colours, with the quantity, its unit, and the numbers from bottom to top.
std::string bar(const ColourMap& colours, const std::string& quantity, const std::string& unit,
                const std::vector<std::string>& numbers) {
  constexpr double x = 480.0, top = 60.0, height = 340.0;
  std::string text = svg::colour_bar(colours, {x, top}, {14.0, height}) +
                     svg::label({x, top - 34.0}, quantity, "font-weight=\"600\"") +
                     svg::label({x, top - 16.0}, unit);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const double fraction = static_cast<double>(k) / static_cast<double>(numbers.size() - 1);
    text += svg::label({x + 20.0, top + (1.0 - fraction) * height}, numbers[k], "dy=\"0.35em\"");
  }
  return text;
}

std::string picture(const std::string& title, const std::string& content) {
  return svg::open({600.0, 460.0}, title) + content + "</svg>\n";
}

}  // namespace

int main(int argc, char** argv) {
  const SolvedFlow flow = solve(sinking_disk());
  const ComplexVector traction = boundary_traction(flow.problem(), flow.derivatives(flow.nodes()));
  print_loads(flow, traction);
  print_dissipation(flow, traction);
  print_approach(flow);
  print_viscosity();
  if (argc < 2) return 0;

  Field field = sample_field(flow);
  double mean = 0.0;
  for (const FlowDerivatives& at : field.at) mean += at.pressure;
  mean /= static_cast<double>(field.at.size());
  std::vector<double> pressures, dissipations;
  for (const FlowDerivatives& at : field.at) {
    pressures.push_back(0.5 + 0.5 * (at.pressure - mean) / 0.6);
    dissipations.push_back(1.0 + std::log10(dissipation_density(at, viscosity)) / 4.0);
  }
  // The datum of the pressure is free: the arrows show it against the mean, as the colours do.
  std::vector<FlowDerivatives> at_nodes = flow.derivatives(flow.nodes());
  for (FlowDerivatives& at : at_nodes) at.pressure -= mean;
  const std::filesystem::path directory = argv[1];
  const std::string above = outlines(flow.problem());
  write_atomically(directory / "chapter_07_pressure.svg",
                   picture("Pressure around a sinking disk, and the forces on the bodies",
                           squares(field.points, pressures, cool_to_warm) + above +
                               arrows(flow.problem(), boundary_traction(flow.problem(), at_nodes)) +
                               bar(cool_to_warm, "pressure - mean", "force / length",
                                   {"-0.6", "-0.3", "0", "0.3", "0.6"})),
                   SafeFrom::kill);
  write_atomically(directory / "chapter_07_dissipation.svg",
                   picture("Dissipation around a sinking disk, over four decades",
                           squares(field.points, dissipations, viridis) + above +
                               bar(viridis, "dissipation", "power / area",
                                   {"10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "1"})),
                   SafeFrom::kill);
}
