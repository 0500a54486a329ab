// Checks lengths, areas, centroids, curvatures (01.4) and normals (01.3) of curves against closed
// forms, and under rigid motions.
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;
using std::numbers::pi;
using test::largest;

namespace {

const std::vector<Shape> shapes = {Circle{0.7}, Ellipse{2.0, 1.0}, Ellipse{0.3, 1.5},
                                   Star{1.3, 0.2, 5}, Superellipse{2.0, 1.0, 4}};

double ellipse_perimeter(double a, double b) {
  const double major = std::max(a, b), minor = std::min(a, b);
  return 4.0 * major * std::comp_ellint_2(std::sqrt(1.0 - minor * minor / (major * major)));
}

Curve body(const Shape& shape, Index n) {
  return sample(shape, n, Side::fluid_outside);
}

}  // namespace

BOOST_AUTO_TEST_CASE(areas) {
  BOOST_TEST(std::abs(area(body(Circle{0.7}, 8)) - 0.49 * pi) < 1e-15);
  BOOST_TEST(std::abs(area(body(Ellipse{2.0, 0.5}, 8)) - pi) < 1e-15);
  BOOST_TEST(std::abs(area(body(Star{1.3, 0.2, 5}, 32)) - 1.69 * pi * 1.02) < 1e-14);
  const double gamma = std::tgamma(1.25);
  const double superellipse = 4.0 * 2.0 * 0.5 * gamma * gamma / std::tgamma(1.5);
  BOOST_TEST(std::abs(area(body(Superellipse{2.0, 0.5, 4}, 128)) - superellipse) < 1e-14);
}

BOOST_AUTO_TEST_CASE(perimeters) {
  BOOST_TEST(std::abs(perimeter(body(Circle{0.7}, 4)) - 1.4 * pi) < 1e-15);
  // The standard library's elliptic integral has a relative error of about 1e-14.
  for (double b : {0.5, 1.0, 2.5}) {
    const double exact = ellipse_perimeter(1.0, b);
    BOOST_TEST(std::abs(perimeter(body(Ellipse{1.0, b}, 128)) / exact - 1.0) < 5e-14);
  }
  // The limacon r = 1 + A cos t has the speed sqrt(1 + A^2 + 2 A cos t).
  const double amplitude = 0.3;
  const double limacon =
      4.0 * (1.0 + amplitude) * std::comp_ellint_2(2.0 * std::sqrt(amplitude) / (1.0 + amplitude));
  BOOST_TEST(std::abs(perimeter(body(Star{1.0, amplitude, 1}, 96)) / limacon - 1.0) < 5e-14);
}

BOOST_AUTO_TEST_CASE(the_centroid_weighs_by_arclength) {
  // A Moebius map of the unit circle onto itself crowds the nodes on one side of the circle about
  // c.
  const Complex c{0.4, -0.3};
  ComplexVector points(128);
  for (Index j = 0; j < 128; ++j) {
    const Complex w = std::polar(1.0, 2.0 * pi * static_cast<double>(j) / 128.0);
    points[j] = c + (w + 0.5) / (1.0 + 0.5 * w);
  }
  const Curve curve = body(NodalCurve{points, ""}, 128);
  BOOST_TEST(std::abs(curve.x.mean() - c) > 0.4);
  BOOST_TEST(std::abs(boundary_centroid(curve) - c) < 1e-14);
  BOOST_TEST(std::abs(bounding_radius(curve, c) - 1.0) < 1e-14);
  BOOST_TEST(std::abs(bounding_radius(curve, c + 0.5) - 1.5) < 1e-14);
}

BOOST_AUTO_TEST_CASE(the_outer_radius_holds_the_curve_between_nodes) {
  // The star's tips lie a quarter of the spacing from the nearest node.
  const Shape star = Star{1.0, -0.3, 4};
  BOOST_TEST(bounding_radius(body(star, 66), 0.0) < 1.2987);
  BOOST_TEST(outer_radius(body(star, 66), 0.0) >= 1.3);
  BOOST_TEST(outer_radius(body(star, 66), 0.0) < 1.3004);
  for (const Shape& shape : {star, shapes[1], shapes[2], shapes[3], shapes[4]}) {
    for (const Complex c : {Complex{}, Complex{0.1, 0.07}}) {
      const double exact = bounding_radius(body(shape, 100000), c);
      for (Index n : {12, 18, 34, 66, 130, 258}) {
        const double radius = outer_radius(body(shape, n), c);
        BOOST_TEST(radius >= (1.0 - 1e-9) * exact);
        // The overestimate is of fourth order; the star of five arms determines the constant.
        BOOST_TEST(radius <= (1.0 + std::pow(20.0 / static_cast<double>(n), 4)) * exact);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(where_nodes_are_farthest_the_outer_radius_is_theirs) {
  for (Index n : {8, 32, 64, 100}) {
    const Curve circle = body(Circle{0.7}, n), ellipse = body(Ellipse{2.0, 0.5}, 2 * n);
    BOOST_TEST(outer_radius(circle, 0.0) == bounding_radius(circle, 0.0));
    BOOST_TEST(outer_radius(ellipse, 0.0) == bounding_radius(ellipse, 0.0));
  }
}

BOOST_AUTO_TEST_CASE(the_outer_radius_scales_with_the_curve) {
  // A power of two scales all numbers without rounding errors.
  for (const Shape& shape : shapes) {
    for (Index n : {4, 6, 8, 12, 20}) {
      for (const Complex c : {Complex{}, Complex{0.1, 0.07}}) {
        const Curve curve = body(shape, n);
        for (double scale : {0x1p-10, 0x1p10}) {
          const Curve scaled{scale * curve.x, scale * curve.dx, scale * curve.ddx, curve.side};
          BOOST_TEST(outer_radius(scaled, scale * c) == scale * outer_radius(curve, c));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(curvatures_are_signed) {
  const double a = 2.0, b = 0.5;
  const Curve ellipse = body(Ellipse{a, b}, 30);
  const Eigen::VectorXd kappa = curvatures(ellipse);
  for (Index j = 0; j < 30; ++j) {
    const double speed = std::hypot(a * ellipse.x[j].imag() / b, b * ellipse.x[j].real() / a);
    BOOST_TEST(std::abs(kappa[j] - a * b / std::pow(speed, 3)) < 1e-13);
  }
  // For r = 1 + A cos(k t) the curvature at a tip and in a valley, where r' = 0, is (r - r'') /
  // r^2.
  const double amplitude = 0.2;
  const Curve star = body(Star{1.0, amplitude, 5}, 10);
  const double tip = 1.0 + amplitude, valley = 1.0 - amplitude;
  const double bend = 25.0 * amplitude;
  BOOST_TEST(std::abs(curvatures(star)[0] - (tip + bend) / (tip * tip)) < 1e-14);
  BOOST_TEST(std::abs(curvatures(star)[1] - (valley - bend) / (valley * valley)) < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_tangent_turns_once_counter_clockwise) {
  for (const Shape& shape : shapes) {
    const Curve curve = body(shape, 256);
    BOOST_TEST(std::abs(curvatures(curve).dot(weights(curve)) - 2.0 * pi) < 1e-12);
    BOOST_TEST(area(curve) > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(normals_point_out_of_the_fluid) {
  for (const Shape& shape : shapes) {
    for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
      const Curve curve = sample(shape, 64, side);
      const ComplexVector normal = normals(curve);
      for (Index j = 0; j < 64; ++j) {
        BOOST_TEST(std::abs(std::abs(normal[j]) - 1.0) < 1e-15);
        BOOST_TEST(std::abs(dot(normal[j], curve.dx[j])) < 1e-14);
        // The shapes are star-shaped about the origin: outward normals point away from the origin.
        BOOST_TEST((dot(normal[j], curve.x[j]) > 0.0) == (side == Side::fluid_inside));
      }
      // By the divergence theorem, the flux of x out of the enclosed area is twice the area.
      const Eigen::VectorXd flux = (normal.conjugate().array() * curve.x.array()).real();
      BOOST_TEST(std::abs(flux.dot(weights(curve)) - 2.0 * curve.sign() * area(curve)) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_placed_curve_is_moved_rigidly) {
  const Complex position{0.3, -2.0};
  const double orientation = 0.7;
  for (const Shape& shape : shapes) {
    const Curve reference = sample(shape, 32, Side::fluid_inside);
    const Curve placed = place(reference, position, orientation);
    BOOST_TEST((placed.side == Side::fluid_inside));
    for (Index j = 0; j < 32; ++j) {
      const auto turned = [&](Complex z) {
        return Complex{std::cos(orientation) * z.real() - std::sin(orientation) * z.imag(),
                       std::sin(orientation) * z.real() + std::cos(orientation) * z.imag()};
      };
      BOOST_TEST(std::abs(placed.x[j] - position - turned(reference.x[j])) < 2e-15);
      BOOST_TEST(std::abs(placed.dx[j] - turned(reference.dx[j])) < 1e-14);
      BOOST_TEST(std::abs(placed.ddx[j] - turned(reference.ddx[j])) < 1e-13);
    }
    BOOST_TEST((curvatures(placed) - curvatures(reference)).cwiseAbs().maxCoeff() < 1e-12);
    BOOST_TEST((weights(placed) - weights(reference)).cwiseAbs().maxCoeff() < 1e-14);
    BOOST_TEST(std::abs(area(placed) - area(reference)) < 1e-13);
  }
}
