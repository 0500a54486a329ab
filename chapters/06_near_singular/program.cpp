// Chapter 06: the flow about an ellipse, evaluated closer and closer to it: by the trapezoid rule,
// by interpolation, and by Cauchy integrals.
//
//   chapter_06 [DIRECTORY]    prints a table; draws chapter_06_error.svg into the directory
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "near_singular/cauchy.hpp"
#include "near_singular/interpolation.hpp"
#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

// [flow]
const Ellipse ellipse{1.0, 0.5};

/// The truth: a stresslet in the body, which neither pushes nor turns the fluid.
Complex exact_velocity(Complex z) {
  return stresslet(z - Complex{0.1, 0.01}, {0.6, 0.8}, {3.0, -1.0});
}
// [flow]

/// The density whose limit on the body is the exact velocity; its rigid part is zero (chapter 02).
ComplexVector solve_density(const Curve& body) {
  const Index n = body.size();
  Eigen::MatrixXd matrix =
      double_layer_matrix(body) - 0.5 * Eigen::MatrixXd::Identity(2 * n, 2 * n);
  const Eigen::VectorXd share = weights(body) / perimeter(body);
  const ComplexVector one = ComplexVector::Ones(n);
  for (const ComplexVector& motion :
       {one, ComplexVector(imaginary * one), ComplexVector(imaginary * body.x)}) {
    const ComplexVector mean = motion.cwiseProduct(share) / share.dot(motion.cwiseAbs2());
    matrix -= interleaved(motion) * interleaved(mean).transpose();
  }
  const ComplexVector velocity = body.x.unaryExpr(&exact_velocity);
  const Eigen::VectorXd density = matrix.partialPivLu().solve(interleaved(velocity));
  return deinterleaved(density);
}

/// A method's name, and its velocities at targets.
struct Method {
  const char* name;
  std::function<ComplexVector(const ComplexVector&)> velocity;
};

// [methods]
/// Three ways to evaluate the double layer of one density.
std::vector<Method> methods(const Curve& body, const ComplexVector& density) {
  const auto by_sum = [sum = StressletSum({body}), density](const ComplexVector& z) {
    return sum(z, density);
  };
  const InterpolationCurve interpolation(body, InterpolationSettings::for_tolerance(1e-6));
  const auto by_interpolation = [interpolation,
                                 data = interpolation.data(density)](const ComplexVector& z) {
    return interpolation.velocity(data, 0, z);
  };
  const CauchyCurve cauchy(body);
  const auto by_cauchy = [cauchy, data = cauchy.data(density)](const ComplexVector& z) {
    return cauchy.velocity(data, 0, z);
  };
  return {{"trapezoid", by_sum}, {"interpolation", by_interpolation}, {"Cauchy", by_cauchy}};
}
// [methods]

/// Errors relative to the largest velocity on the body.
Eigen::VectorXd errors(const Method& method, const ComplexVector& targets) {
  static const double largest =
      sample(ellipse, 200, Side::fluid_outside).x.unaryExpr(&exact_velocity).cwiseAbs().maxCoeff();
  return (method.velocity(targets) - targets.unaryExpr(&exact_velocity)).cwiseAbs() / largest;
}

/// Points at a distance from the body in spacings of its nodes.
ComplexVector points_off_body(const Curve& body, double spacings) {
  const Curve places = sample(ellipse, 90, Side::fluid_outside);
  const double step = 2.0 * std::numbers::pi * spacings / static_cast<double>(body.size());
  return places.x - step * places.dx.cwiseAbs().cwiseProduct(normals(places));
}

void print_table(const Curve& body, const std::vector<Method>& all) {
  std::printf("largest error of the velocity by the distance in spacings, %td nodes\n\ndistance",
              body.size());
  for (const Method& method : all) std::printf("%15s", method.name);
  for (const double spacings : {5.0, 3.0, 1.0, 0.3, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 0.0}) {
    std::printf("\n%8g", spacings);
    for (const Method& method : all) {
      std::printf("%15.1e", errors(method, points_off_body(body, spacings)).maxCoeff());
    }
  }
  std::printf("\n");
}

/// @name The picture: squares about the right half of the body, coloured by the error in the middle
/// @{
constexpr double left = 0.0, right = 1.5, top = 0.85, cell = 0.02, pixels = 260.0;
constexpr int decades = 16;  // one colour each, from 1e-16 to 1

Complex to_pixel(Complex z) {
  return {pixels * (z.real() - left), pixels * (top - z.imag())};
}

std::string colour(int decade) {
  return "fill=\"" + colour(viridis, (decade + 0.5) / decades) +
         "\" shape-rendering=\"crispEdges\"";
}

// [squares]
/// Middles of the squares that lie in the fluid, by the side test.
ComplexVector squares(const CauchyCurve& cauchy) {
  std::vector<Complex> middles;
  for (double y = -top + 0.5 * cell; y < top; y += cell) {
    for (double x = left + 0.5 * cell; x < right; x += cell) {
      if (cauchy.in_fluid({x, y})) middles.emplace_back(x, y);
    }
  }
  return Eigen::Map<const ComplexVector>(middles.data(), static_cast<Index>(middles.size()));
}
// [squares]

std::string square(Complex middle) {
  const Complex corner = to_pixel(middle - 0.5 * cell * Complex{1.0, -1.0});
  const std::string side = svg::number(pixels * cell);
  return 'M' + svg::number(corner.real()) + ' ' + svg::number(corner.imag()) + 'h' + side + 'v' +
         side + "h-" + side + 'z';
}

/// Error field of a method, one path a decade, with the right half of the body.
std::string error_field(const Method& method, const Curve& body, const ComplexVector& middles) {
  const Eigen::VectorXd error = errors(method, middles);
  std::array<std::string, decades> paths;
  for (Index i = 0; i < middles.size(); ++i) {
    const int decade = static_cast<int>(std::floor(std::log10(error[i]))) + decades;
    paths[static_cast<std::size_t>(std::clamp(decade, 0, decades - 1))] += square(middles[i]);
  }
  std::string picture;
  for (int k = 0; k < decades; ++k) {
    picture += svg::path(paths[static_cast<std::size_t>(k)], colour(k));
  }
  std::string nodes;
  for (const Complex node : body.x) {
    if (node.real() >= left) nodes += svg::line(to_pixel(node) - 1.0, to_pixel(node) + 1.0);
  }
  return picture + svg::path(nodes, "stroke=\"currentColor\" stroke-width=\"2\"") +
         svg::label({8.0, pixels * top}, method.name);
}

std::string legend(double x) {
  std::string text;
  for (int k = 0; k < decades; ++k) {
    const double y = 20.0 + 24.0 * (decades - 1 - k);
    text += "<rect" + svg::attribute("x", x) + svg::attribute("y", y) +
            svg::attribute("width", 18.0) + svg::attribute("height", 24.0) + ' ' + colour(k) +
            "/>\n";
    if (k % 3 == 0) text += svg::label({x + 24.0, y + 28.0}, "1e" + std::to_string(k - decades));
  }
  return text;
}

/// The trapezoid rule on the left, Cauchy integrals on the right.
std::string picture_of_errors(const Curve& body, const std::vector<Method>& all) {
  const double width = pixels * (right - left) + 10.0;
  const ComplexVector middles = squares(CauchyCurve(body));
  return svg::open(
             {2.0 * width + 80.0, 2.0 * pixels * top},
             "Error of the velocity by two methods, " + std::to_string(body.size()) + " nodes") +
         error_field(all.front(), body, middles) + "<g transform=\"translate(" +
         svg::number(width) + " 0)\">" + error_field(all.back(), body, middles) + "</g>\n" +
         legend(2.0 * width + 10.0) + "</svg>\n";
}
/// @}

}  // namespace

int main(int argc, char** argv) {
  //! [main]
  const Curve body = sample(ellipse, 128, Side::fluid_outside);
  const std::vector<Method> all = methods(body, solve_density(body));
  print_table(body, all);
  //! [main]
  if (argc > 1) {
    write_atomically(std::filesystem::path(argv[1]) / "chapter_06_error.svg",
                     picture_of_errors(body, all), SafeFrom::kill);
  }
}
