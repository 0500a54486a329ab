// Chapter 01: a closed curve as nodes, and what the trapezoid rule makes of it.
//
//   chapter_01 [DIRECTORY]    prints tables; draws chapter_01_star.svg into the directory
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

// [star]
// The curve r = 1 + 0.3 cos(5 t), sampled at n nodes.
Curve star(Index n) {
  return sample(Star{.radius = 1.0, .amplitude = 0.3, .arms = 5}, n, Side::fluid_outside);
}
// [star]

// [integrals]
// Integrals over the curve, each a sum of node values times weights.
void print_integrals() {
  const double exact_area = std::numbers::pi * (1.0 + 0.5 * 0.3 * 0.3);
  const double fine_perimeter = perimeter(star(1024));
  std::printf("%6s %22s %12s %22s %12s\n", "N", "area", "error", "perimeter", "error");
  for (const Index n : {8, 16, 32, 64, 128, 256}) {
    const Curve curve = star(n);
    const Eigen::VectorXd w = weights(curve);
    std::printf("%6td %22.16f %12.1e %22.16f %12.1e\n", n, area(curve),
                std::abs(area(curve) - exact_area), w.sum(), std::abs(w.sum() - fine_perimeter));
  }
}
// [integrals]

// [curvature]
// The curvature by differentiating node values twice, beside the exact one.
double curvature_error(Index n) {
  const Curve curve = star(n);
  const ComplexVector dx = differentiate(curve.x);
  const ComplexVector ddx = differentiate(dx);
  double error = 0.0;
  const Eigen::VectorXd exact = curvatures(curve);
  for (Index j = 0; j < n; ++j) {
    const double speed = std::abs(dx[j]);
    error = std::max(error, std::abs(cross(dx[j], ddx[j]) / (speed * speed * speed) - exact[j]));
  }
  return error;
}
// [curvature]

void print_functions() {
  std::printf("\n%6s %28s %24s\n", "N", "curvature from nodes, error", "tail of 1 / |x'|");
  for (const Index n : {8, 16, 32, 64, 128, 256}) {
    // [tail]
    const Curve curve = star(n);
    const ComplexVector function = curve.dx.cwiseAbs().cwiseInverse().cast<Complex>();
    const double unresolved = fourier_tail(function);
    // [tail]
    std::printf("%6td %28.1e %24.1e\n", n, curvature_error(n), unresolved);
  }
}

// The curve through 400 points, its 40 nodes, and the normals there, which point out of the fluid.
std::string picture() {
  constexpr double scale = 130.0;
  const Complex middle{200.0, 200.0};
  const auto pixel = [&](Complex x) { return middle + scale * std::conj(x); };
  const Curve fine = star(400), curve = star(40);
  const ComplexVector normal = normals(curve);
  std::string dots, arrows;
  for (Index j = 0; j < curve.size(); ++j) {
    const Complex at = curve.x[j];
    arrows += svg::line(pixel(at), pixel(at + 0.16 * normal[j]));
    dots += svg::line(pixel(at), pixel(at) + 0.01);
  }
  const std::string stroke = "fill=\"none\" stroke=\"currentColor\" stroke-linecap=\"round\" ";
  return svg::open({400.0, 400.0}, "Forty nodes of a star with their normals") +
         svg::path(svg::polygon(fine.x.unaryExpr(pixel)), stroke + "stroke-opacity=\"0.5\"") +
         svg::path(arrows, stroke) + svg::path(dots, stroke + "stroke-width=\"6\"") + "</svg>\n";
}

}  // namespace

int main(int argc, char** argv) {
  print_integrals();
  print_functions();
  if (argc > 1) {
    write_atomically(std::filesystem::path(argv[1]) / "chapter_01_star.svg", picture(),
                     SafeFrom::kill);
  }
}
