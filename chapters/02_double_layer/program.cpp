// Chapter 02: the flow about a star-shaped body that pushes and turns the fluid. A completed double
// layer is solved for its density, evaluated far from the body and near it, and compared with the
// truth.
//
//   chapter_02 [DIRECTORY]    prints a table; draws chapter_02_error.svg into the directory
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

// [flow]
constexpr double viscosity = 1.3, gauge = 1.0;
const Complex force{1.0, 0.5};
constexpr double torque = -0.7;
const Complex load_point{0.3, -0.1};

/// The truth: a force and a torque on the fluid, at a point that will be hidden in the body.
Complex exact_velocity(Complex z) {
  return stokeslet(z - load_point, force, viscosity, gauge) +
         rotlet(z - load_point, torque, viscosity);
}
// [flow]

// [completion]
/// The part of the velocity that carries force and torque, from the middle of the body. Moving the
/// force there changes the torque.
Complex completion(Complex z) {
  return stokeslet(z, force, viscosity, gauge) +
         rotlet(z, torque + cross(load_point, force), viscosity);
}
// [completion]

// [system]
/// -1/2 + D - P, where P takes the mean rigid motion out of a density: without it, the three rigid
/// motions are a null space.
Eigen::MatrixXd system_matrix(const Curve& body) {
  const Index n = body.size();
  Eigen::MatrixXd matrix =
      double_layer_matrix(body) - 0.5 * Eigen::MatrixXd::Identity(2 * n, 2 * n);
  const Eigen::VectorXd share = weights(body) / perimeter(body);
  const ComplexVector one = ComplexVector::Ones(n);
  const ComplexVector arm = body.x - boundary_centroid(body) * one;
  for (const ComplexVector& motion :
       {one, ComplexVector(imaginary * one), ComplexVector(imaginary * arm)}) {
    const ComplexVector mean = motion.cwiseProduct(share) / share.dot(motion.cwiseAbs2());
    matrix -= interleaved(motion) * interleaved(mean).transpose();
  }
  return matrix;
}
// [system]

// [solve]
/// The density whose limit on the body is what the completion leaves of the boundary velocity.
ComplexVector solve_density(const Curve& body) {
  const ComplexVector remainder =
      body.x.unaryExpr([](Complex z) { return exact_velocity(z) - completion(z); });
  const Eigen::VectorXd density = system_matrix(body).partialPivLu().solve(interleaved(remainder));
  return deinterleaved(density);
}
// [solve]

// [evaluate]
/// Errors of the completed double layer at targets in the fluid, relative to the largest velocity.
Eigen::VectorXd errors(const Curve& body, const ComplexVector& density,
                       const ComplexVector& targets) {
  const ComplexVector velocity =
      StressletSum({body})(targets, density) + targets.unaryExpr(&completion);
  const ComplexVector exact = targets.unaryExpr(&exact_velocity);
  return (velocity - exact).cwiseAbs() / exact.cwiseAbs().maxCoeff();
}
// [evaluate]

const Star star{.radius = 1.0, .amplitude = 0.2, .arms = 5};

/// Points in the fluid at a distance from the body, between its nodes.
ComplexVector points_off_body(double distance) {
  const Curve places = sample(star, 26, Side::fluid_outside);
  return places.x - distance * normals(places);
}

void print_table() {
  const std::array<double, 4> distances{1.0, 0.3, 0.1, 0.01};
  std::printf("largest error of the velocity, relative to the largest, by distance\n\n   N");
  for (const double distance : distances) std::printf("%12g", distance);
  std::printf("\n");
  for (const Index n : {32, 64, 128, 256, 512}) {
    const Curve body = sample(star, n, Side::fluid_outside);
    const ComplexVector density = solve_density(body);
    std::printf("%4td", n);
    for (const double distance : distances) {
      std::printf("%12.1e", errors(body, density, points_off_body(distance)).maxCoeff());
    }
    std::printf("\n");
  }
}

/// @name The picture: squares of a grid about the body, coloured by the error in their middle
/// @{
constexpr double half_width = 1.9, cell = 0.05, pixels = 140.0;
constexpr int decades = 16;  // one colour each, from 1e-16 to 1

Complex to_pixel(Complex z) {
  return {pixels * (z.real() + half_width), pixels * (half_width - z.imag())};
}

bool in_fluid(Complex z) {
  return std::abs(z) > star.radius * (1.0 + star.amplitude * std::cos(star.arms * std::arg(z)));
}

std::string square(Complex middle) {
  const Complex corner = to_pixel(middle - 0.5 * cell * Complex{1.0, -1.0});
  const std::string side = svg::number(pixels * cell);
  return 'M' + svg::number(corner.real()) + ' ' + svg::number(corner.imag()) + 'h' + side + 'v' +
         side + "h-" + side + 'z';
}

std::string colour(int decade) {
  return "fill=\"" + colour(viridis, (decade + 0.5) / decades) +
         "\" shape-rendering=\"crispEdges\"";
}

/// Middles of the squares that lie in the fluid.
ComplexVector squares() {
  std::vector<Complex> middles;
  for (double y = -half_width + 0.5 * cell; y < half_width; y += cell) {
    for (double x = -half_width + 0.5 * cell; x < half_width; x += cell) {
      if (in_fluid({x, y})) middles.emplace_back(x, y);
    }
  }
  return Eigen::Map<const ComplexVector>(middles.data(), static_cast<Index>(middles.size()));
}

/// Error field of the plain rule, one path a decade.
std::string error_field(const Curve& body) {
  const ComplexVector middles = squares();
  const Eigen::VectorXd error = errors(body, solve_density(body), middles);
  std::array<std::string, decades> paths;
  for (Index i = 0; i < middles.size(); ++i) {
    const int decade = static_cast<int>(std::floor(std::log10(error[i]))) + decades;
    paths[static_cast<std::size_t>(std::clamp(decade, 0, decades - 1))] += square(middles[i]);
  }
  std::string picture;
  for (int k = 0; k < decades; ++k) {
    picture += svg::path(paths[static_cast<std::size_t>(k)], colour(k));
  }
  return picture;
}

std::string legend() {
  std::string text;
  for (int k = 0; k < decades; ++k) {
    const double x = 2.0 * half_width * pixels + 20.0, y = 20.0 + 24.0 * (decades - 1 - k);
    text += "<rect" + svg::attribute("x", x) + svg::attribute("y", y) +
            svg::attribute("width", 18.0) + svg::attribute("height", 24.0) + ' ' + colour(k) +
            "/>\n";
    if (k % 3 == 0) text += svg::label({x + 24.0, y + 28.0}, "1e" + std::to_string(k - decades));
  }
  return text;
}

std::string picture_of_errors(Index n) {
  const Curve body = sample(star, n, Side::fluid_outside);
  const double size = 2.0 * half_width * pixels;
  std::string nodes;
  for (const Complex node : body.x) {
    nodes += svg::line(to_pixel(node) - 1.0, to_pixel(node) + 1.0);
  }
  return svg::open({size + 90.0, size},
                   "Error of the velocity about a star, " + std::to_string(n) + " nodes") +
         error_field(body) + legend() +
         svg::path(svg::polygon(body.x.unaryExpr(&to_pixel)),
                   "fill=\"none\" stroke=\"currentColor\"") +
         svg::path(nodes, "stroke=\"currentColor\" stroke-width=\"2\"") + "</svg>\n";
}
/// @}

}  // namespace

int main(int argc, char** argv) {
  print_table();
  if (argc > 1) {
    write_atomically(std::filesystem::path(argv[1]) / "chapter_02_error.svg",
                     picture_of_errors(128), SafeFrom::kill);
  }
}
