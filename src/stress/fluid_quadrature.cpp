// Makes a quadrature rule for the fluid: Gauss's rule and the trapezoid rule in strips along the
// boundary, a square grid for the rest, and a smooth cut-off between the two (07.12).
#include "stress/fluid_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <gsl/gsl_integration.h>

#include "near_singular/closest_points.hpp"
#include "near_singular/near_field.hpp"
#include "trapezoid/fourier.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// erfc(beta) is 1e-13, so that the cut-off is smooth up to rounding at the edges of a strip.
constexpr double beta = 5.25;

// Number of Gauss's nodes across a strip: GSL tabulates this rule, which resolves the cut-off to
// rounding.
constexpr int nodes_across = 64;

// Returns chi of (07.12) as a function of the height d / delta.
double cut_off(double height) {
  return 0.5 * std::erfc(beta * (2.0 * height - 1.0));
}

SmoothCurve smooth(const Curve& curve) {
  return {
      curve, std::make_shared<const Parametrisation>(TrigonometricPolynomial(curve.x)), {}, 0.0};
}

// Returns the signed distance of a point from a curve, > 0 in the fluid. For points farther away
// than the reach, only the sign of the result is accurate.
double height(const SmoothCurve& curve, Complex z, double reach) {
  const Curve& nodes = curve.nodes;
  const Index nearest = nearest_node(nodes, z);
  const Complex to_node = z - nodes.x[nearest];
  const double step = 2.0 * std::numbers::pi / static_cast<double>(nodes.size());
  const double spacing = step * std::abs(nodes.dx[nearest]);
  if (std::abs(to_node) > reach + spacing) {
    return std::copysign(std::abs(to_node), nodes.sign() * cross(nodes.dx[nearest], to_node));
  }
  const double guess = step * static_cast<double>(nearest) + preimage(nodes, nearest, z).real();
  const auto on_curve = [&curve](double t) { return curve.at(t); };
  const TrigonometricPolynomial::Jet at = find_foot(on_curve, z, guess, step).at;
  return nodes.sign() * cross(at.first, z - at.value) / std::abs(at.first);
}

// The points and weights of a rule, one after the other.
struct Rule {
  std::vector<Complex> points;
  std::vector<double> weights;

  void add(Complex point, double weight) {
    points.push_back(point);
    weights.push_back(weight);
  }
};

// Adds the points of a strip, with the weights chi |x'| (1 - s kappa d) dt dd. The strip has twice
// as many points along the curve as the curve has nodes, because integrands are products of
// functions that the nodes resolve.
void add_strip(Rule& rule, const Curve& curve, double width) {
  const Index m = 2 * curve.size();
  const Curve fine = resample(curve, m);
  const ComplexVector normal = normals(fine);
  const Eigen::VectorXd w = weights(fine), curvature = fine.sign() * curvatures(fine);
  const std::unique_ptr<gsl_integration_glfixed_table, void (*)(gsl_integration_glfixed_table*)>
      gauss(gsl_integration_glfixed_table_alloc(nodes_across), gsl_integration_glfixed_table_free);
  for (std::size_t k = 0; k < nodes_across; ++k) {
    double d = 0.0, across = 0.0;
    gsl_integration_glfixed_point(0.0, width, k, &d, &across, gauss.get());
    for (Index j = 0; j < m; ++j) {
      const double stretch = 1.0 - curvature[j] * d;
      rule.add(fine.x[j] - d * normal[j], across * cut_off(d / width) * w[j] * stretch);
    }
  }
}

}  // namespace

double strip_width(const std::vector<Curve>& curves) {
  double width = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < curves.size(); ++a) {
    const double hollow = (curves[a].sign() * curvatures(curves[a])).maxCoeff();
    if (hollow > 0.0) width = std::min(width, 0.5 / hollow);
    for (std::size_t b = 0; b < a; ++b) {
      width = std::min(width, 0.5 * closest_points(smooth(curves[a]), smooth(curves[b])).gap);
    }
  }
  return width;
}

FluidQuadrature fluid_quadrature(const std::vector<Curve>& curves, double points_per_width) {
  const auto encloses = [](const Curve& curve) { return curve.side == Side::fluid_inside; };
  const auto walls = std::ranges::count_if(curves, encloses);
  require(walls == 1, "a quadrature over the fluid requires exactly one enclosing wall, got ",
          walls);
  const double width = strip_width(curves);
  Rule rule;
  std::vector<SmoothCurve> boundary;
  for (const Curve& curve : curves) {
    add_strip(rule, curve, width);
    boundary.push_back(smooth(curve));
  }
  // Returns the factor 1 - sum chi of the weight of a grid point; 0 outside the fluid.
  const auto grid_share = [&](Complex z) {
    double share = 1.0;
    for (const SmoothCurve& curve : boundary) {
      const double h = height(curve, z, width);
      if (h <= 0.0) return 0.0;
      share -= cut_off(h / width);
    }
    return share;
  };
  const ComplexVector& wall = std::ranges::find_if(curves, encloses)->x;
  const double spacing = width / points_per_width;
  const auto row = [&](double x) { return std::lround(x / spacing); };
  for (long j = row(wall.imag().minCoeff()); j <= row(wall.imag().maxCoeff()); ++j) {
    for (long i = row(wall.real().minCoeff()); i <= row(wall.real().maxCoeff()); ++i) {
      const Complex z = spacing * Complex{static_cast<double>(i), static_cast<double>(j)};
      const double share = grid_share(z);
      if (share > 0.0) rule.add(z, share * spacing * spacing);
    }
  }
  return {ComplexVector::Map(rule.points.data(), std::ssize(rule.points)),
          Eigen::VectorXd::Map(rule.weights.data(), std::ssize(rule.weights))};
}

}  // namespace stokesbook
