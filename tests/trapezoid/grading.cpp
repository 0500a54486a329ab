// Checks graded nodes: the map t(s) is the integral (06.18) at any width. Curves that are sampled
// by the map keep the rule's geometric rate, and their nodes crowd at the clusters.
#include "trapezoid/grading.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"
#include "trapezoid/shape.hpp"

using namespace stokesbook;
using Eigen::Index;
using std::numbers::pi;
using test::largest;

namespace {

const std::vector<Grading> gradings = {
    {{{0.0, 1.0}}},
    {{{2.5, 0.1}}, 1.0},
    {{{-1.0, 1e-3}}},
    {{{0.7, 1e-6}}, 4.0},
    {{{0.3, 1e-2}, {2.0, 1e-5}, {-1.0, 0.3}}},
    // These clusters have nearly or exactly the same place, or a parameter two turns away.
    {{{1.0, 1e-4}, {1.0 + 3e-5, 1e-4}}},
    {{{1.0, 1e-3}, {1.0, 1e-5}, {1.0 + 4.0 * pi, 1e-3}}, 1.0}};

ComplexVector ellipse_points(Index n) {
  return sample(Ellipse{1.4, 0.8}, n, Side::fluid_outside).x;
}

const std::vector<Shape> graded_shapes = {Circle{0.7}, Ellipse{2.0, 1.0}, Star{1.3, 0.2, 5},
                                          Superellipse{2.0, 1.0, 4},
                                          NodalCurve{ellipse_points(48), ""}};

double node_density(const Grading& grading, double t) {
  double m = 1.0;
  for (const auto& [parameter, width] : grading.clusters) {
    m += grading.strength / std::hypot(2.0 * std::sin(0.5 * (t - parameter)), width);
  }
  return m;
}

// Returns C of (06.18) from one node, where dt/ds = C / m.
double mean_density(const Grading& grading) {
  const GradedParameter node = graded_parameters(grading, 1)[0];
  return node.dt * node_density(grading, node.t);
}

// Integrates over [a, b] by Gauss' rule of three points on equal panels.
template <class Function>
double integral(const Function& f, double a, double b, int panels) {
  double sum = 0.0;
  const double half = 0.5 * (b - a) / panels, x = std::sqrt(0.6) * half;
  for (int k = 0; k < panels; ++k) {
    const double middle = a + (2 * k + 1) * half;
    sum += (5.0 * f(middle - x) + 8.0 * f(middle) + 5.0 * f(middle + x)) * half / 9.0;
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(parameters_begin_at_zero_ascend_and_go_round_once) {
  for (const Grading& grading : gradings) {
    for (Index n : {4, 30, 501}) {
      const std::vector<GradedParameter> nodes = graded_parameters(grading, n);
      BOOST_TEST(std::abs(std::remainder(nodes[0].t, 2.0 * pi)) < 1e-14);
      double turned = 0.0;
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        BOOST_TEST(nodes[j].dt > 0.0);
        const double step = std::remainder(nodes[(j + 1) % nodes.size()].t - nodes[j].t, 2.0 * pi);
        turned += step < 0.0 ? step + 2.0 * pi : step;
      }
      BOOST_TEST(std::abs(turned - 2.0 * pi) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(equal_numbers_of_nodes_hold_equal_integrals_of_their_density) {
  for (const Grading& grading : gradings) {
    const Index n = 64;
    const std::vector<GradedParameter> nodes = graded_parameters(grading, n);
    const double share = 2.0 * pi * mean_density(grading) / static_cast<double>(n);
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const double from = nodes[j].t;
      const double step = std::remainder(nodes[(j + 1) % nodes.size()].t - from, 2.0 * pi);
      // Near a cluster, the difference of two parameters is accurate only relative to the width.
      const double rounding = 1e-15 * node_density(grading, from);
      const double held = integral([&](double t) { return node_density(grading, t); }, from,
                                   from + (step < 0.0 ? step + 2.0 * pi : step), 400);
      BOOST_TEST(std::abs(held / share - 1.0) < 1e-9 + 10.0 * rounding / share);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_cluster_at_zero_keeps_the_digits_of_small_parameters) {
  // If t is so small that the other terms of m are constant, t = width sinh((C s - t) / b). A fixed
  // point iteration solves this equation for t.
  for (double width : {1e-3, 1e-6, 1e-9}) {
    const Grading grading{{{0.0, width}}};
    const Index n = 512;
    const std::vector<GradedParameter> nodes = graded_parameters(grading, n);
    const double mean = mean_density(grading);
    for (Index j : {1, 5, 511}) {
      const double s = std::remainder(2.0 * pi * static_cast<double>(j) / n, 2.0 * pi);
      double t = 0.0;
      for (int k = 0; k < 60; ++k) t = width * std::sinh((mean * s - t) / grading.strength);
      const double got = nodes[static_cast<std::size_t>(j)].t;
      // The equation has t in place of 2 sin(t / 2), which causes a relative error of t^2 / 24.
      BOOST_TEST(std::abs(got / t - 1.0) < 1e-14 + t * t);
    }
  }
}

BOOST_AUTO_TEST_CASE(positions_among_graded_nodes_invert_parameters) {
  for (const Grading& grading : gradings) {
    const Index n = 101;
    const std::vector<GradedParameter> nodes = graded_parameters(grading, n);
    for (Index j = 0; j < n; ++j) {
      const auto [t, dt, ddt] = nodes[static_cast<std::size_t>(j)];
      const double s = 2.0 * pi * static_cast<double>(j) / static_cast<double>(n);
      const double tolerance = 1e-13 + 4e-15 / dt;  // t has a unit roundoff of 1e-15
      const std::vector<double> found =
          graded_positions(grading, {{t, dt, ddt}, {t + 2.0 * pi, dt, ddt}});
      BOOST_TEST(std::abs(std::remainder(found[0] - s, 2.0 * pi)) < tolerance);
      BOOST_TEST(std::abs(found[1] - found[0] - 2.0 * pi) < tolerance);
    }
  }
  BOOST_TEST(graded_positions({}, {{1.7, 1.0, 0.0}}).front() == 1.7);
}

BOOST_AUTO_TEST_CASE(derivatives_of_parameters_are_those_of_finite_differences) {
  // Compares with central differences of order 2.
  for (const Grading& grading : gradings) {
    const Index n = 20000;
    const std::vector<GradedParameter> nodes = graded_parameters(grading, n);
    const double h = 2.0 * pi / static_cast<double>(n);
    for (Index j = 100; j < n; j += 777) {
      const auto at = [&](Index k) { return nodes[static_cast<std::size_t>((j + k + n) % n)]; };
      const double slope = std::remainder(at(1).t - at(-1).t, 2.0 * pi) / (2.0 * h);
      const double bend = (at(1).dt - at(-1).dt) / (2.0 * h);
      const double rounding = 1e-15 / h;
      // t(s) varies over the length b / C, which is at least 0.02 here.
      BOOST_TEST(std::abs(slope - at(0).dt) < 1e-3 * at(0).dt + rounding);
      BOOST_TEST(std::abs(bend - at(0).ddt) <
                 1e-3 * (std::abs(at(0).ddt) + at(0).dt) + rounding * at(0).dt);
    }
  }
}

BOOST_AUTO_TEST_CASE(derivatives_of_curves_are_those_of_the_fourier_series) {
  // The derivatives agree up to rounding, which differentiation multiplies by 600.
  for (const Grading& grading : {Grading{{{0.4, 0.3}}}, Grading{{{0.4, 0.1}, {3.0, 0.5}}, 1.0}}) {
    for (const Shape& shape : graded_shapes) {
      const Curve curve = sample(shape, 1200, Side::fluid_outside, grading);
      BOOST_TEST(largest(differentiate(curve.x) - curve.dx) < 2e-11);
      BOOST_TEST(largest(differentiate(curve.dx) - curve.ddx) < 2e-10);
    }
  }
}

BOOST_AUTO_TEST_CASE(lengths_and_areas_do_not_depend_on_the_grading) {
  for (const Shape& shape : graded_shapes) {
    const Curve even = sample(shape, 400, Side::fluid_outside);
    for (const Grading& grading : gradings) {
      const Curve curve = sample(shape, 2000, Side::fluid_outside, grading);
      BOOST_TEST(std::abs(perimeter(curve) / perimeter(even) - 1.0) < 1e-13);
      BOOST_TEST(std::abs(area(curve) / area(even) - 1.0) < 1e-13);
      BOOST_TEST(std::abs(boundary_centroid(curve) - boundary_centroid(even)) < 1e-13);
      // The tangent turns once. The sum of curvatures depends on the second derivatives.
      BOOST_TEST(std::abs(curvatures(curve).dot(weights(curve)) - 2.0 * pi) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(lengths_converge_at_the_depth_of_the_speeds_branch_points) {
  // |x'| of an ellipse vanishes like a square root at i d and pi + i d, tanh d = b / a. The errors
  // are therefore N^(-3/2) e^{-rate N} times a cosine of N (01.8).
  const Shape ellipse = Ellipse{2.0, 1.0};
  const double exact = perimeter(sample(ellipse, 400, Side::fluid_outside));
  const double distance = std::atanh(0.5);
  for (double width : {1e-1, 1e-2, 1e-4}) {
    const Grading grading{{{0.6, width}}};
    const double rate =
        std::min(graded_depth(grading, 0.0, distance), graded_depth(grading, pi, distance));
    double largest_factor = 0.0;
    for (Index n = 16; n < 240; n += 16) {
      const double x = static_cast<double>(n);
      const double law = std::pow(x, -1.5) * std::exp(-rate * x);
      const double length = perimeter(sample(ellipse, n, Side::fluid_outside, grading));
      const double error = std::abs(length / exact - 1.0);
      BOOST_TEST(error < 10.0 * law + 2e-15);
      if (law > 1e-13) largest_factor = std::max(largest_factor, error / law);
    }
    BOOST_TEST(largest_factor > 1.0);
  }
}

BOOST_AUTO_TEST_CASE(nodes_crowd_at_clusters) {
  // The share of the nodes within the distance r of a cluster is (b asinh(r / delta) + r) / (pi C).
  const Grading grading{{{2.0, 1e-5}}};
  const Index n = 400;
  const double mean = mean_density(grading);
  for (double r : {1e-5, 1e-3, 1e-2}) {
    int within = 0;
    for (const GradedParameter& node : graded_parameters(grading, n)) {
      within += std::abs(std::remainder(node.t - 2.0, 2.0 * pi)) < r;
    }
    const double expected = n * (grading.strength * std::asinh(r / 1e-5) + r) / (pi * mean);
    BOOST_TEST(std::abs(within - expected) <= 1.0);
  }
}

BOOST_AUTO_TEST_CASE(a_symmetric_grading_gives_symmetric_nodes) {
  // The nodes far from the cluster follow from C s, which is up to 70. The rounding of this product
  // is visible.
  for (double width : {1.0, 1e-3, 1e-6}) {
    const Curve curve = sample(Circle{1.0}, 64, Side::fluid_outside, {{{0.0, width}}});
    const Curve both = sample(Circle{1.0}, 64, Side::fluid_outside, {{{0.0, width}, {pi, width}}});
    for (Index j = 1; j < 64; ++j) {
      BOOST_TEST(std::abs(curve.x[j] - std::conj(curve.x[64 - j])) < 3e-14);
      BOOST_TEST(std::abs(both.x[j] + std::conj(both.x[(96 - j) % 64])) < 3e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(turns_of_a_parameter_and_the_order_of_clusters_do_not_matter) {
  const Grading grading{{{0.3, 1e-2}, {2.0, 1e-5}, {-1.0, 0.3}}};
  const Grading other{{{-1.0 + 2.0 * pi, 0.3}, {2.0 - 4.0 * pi, 1e-5}, {0.3, 1e-2}}};
  const Curve a = sample(Star{1.0, 0.2, 5}, 200, Side::fluid_outside, grading);
  const Curve b = sample(Star{1.0, 0.2, 5}, 200, Side::fluid_outside, other);
  BOOST_TEST(largest(a.x - b.x) < 1e-14);
  BOOST_TEST(largest(a.dx - b.dx) < 1e-13);
  BOOST_TEST(largest(a.ddx - b.ddx) < 1e-11);
}

BOOST_AUTO_TEST_CASE(without_clusters_a_sample_is_the_equidistant_one_bit_for_bit) {
  for (const Shape& shape : graded_shapes) {
    for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
      const Curve even = sample(shape, 48, side), graded = sample(shape, 48, side, Grading{});
      BOOST_TEST((even.x == graded.x && even.dx == graded.dx && even.ddx == graded.ddx));
      BOOST_TEST((graded.side == side));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_same_points_parametrise_a_shape_and_its_interpolant) {
  const Parametrisation ellipse = parametrisation(Ellipse{1.4, 0.8});
  for (Index n : {48, 9}) {
    ComplexVector backwards(n);
    for (Index j = 0; j < n; ++j) {
      backwards[n - 1 - j] =
          ellipse(2.0 * pi * static_cast<double>(j) / static_cast<double>(n)).value;
    }
    const Parametrisation nodal = parametrisation(NodalCurve{backwards, ""});
    // The last of the reversed points is the ellipse's first point: both curves start there.
    for (double t : {0.0, 1.3, 5.9}) {
      BOOST_TEST(std::abs(nodal(t).value - ellipse(t).value) < 1e-13);
      BOOST_TEST(std::abs(nodal(t).first - ellipse(t).first) < 1e-13);
      BOOST_TEST(std::abs(nodal(t).second - ellipse(t).second) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_depth_of_a_singularity_is_the_integral_up_to_it) {
  for (const Grading& grading : gradings) {
    const double mean = mean_density(grading);
    for (double parameter : {0.301, 0.7003, 1.00001, 3.5}) {
      for (double depth : {1e-4, 1e-2, 0.8}) {
        // Integrates m (06.18) upwards from the real axis, in panels of equal ratio. In m, square
        // roots with positive real parts continue the distances to the clusters.
        const auto continued = [&](double logarithm) {
          const double y = std::exp(logarithm);
          Complex m = 1.0;
          for (const auto& [place, width] : grading.clusters) {
            const Complex sine = std::sin(0.5 * Complex{parameter - place, y});
            m += grading.strength / std::sqrt(4.0 * sine * sine + width * width);
          }
          return m.real() * y;
        };
        const double lowest = 1e-9;
        const double sum = node_density(grading, parameter) * lowest +
                           integral(continued, std::log(lowest), std::log(depth), 8000);
        BOOST_TEST(std::abs(graded_depth(grading, parameter, depth) * mean / sum - 1.0) < 1e-6);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(over_its_cluster_a_singularity_is_as_deep_as_the_arc_sine_says) {
  const double width = 1e-3;
  const std::vector<Cluster> clusters{{0.4, width}};
  const std::vector<double> strengths{0.5, 2.0, 4.0};
  const auto check = [&](double depth, double integral_up_to_it) {
    const std::vector<double> depths = graded_depths(clusters, strengths, 0.4, depth);
    for (std::size_t i = 0; i < strengths.size(); ++i) {
      const Grading grading{clusters, strengths[i]};
      const double expected = (depth + strengths[i] * integral_up_to_it) / mean_density(grading);
      BOOST_TEST(std::abs(depths[i] / expected - 1.0) < 1e-6);
      BOOST_TEST(graded_depth(grading, 0.4, depth) == depths[i]);
    }
  };
  for (double ratio : {0.1, 0.5, 0.9}) check(ratio * width, std::asin(ratio));
  // For a depth of one width or more, the integral that is added to the depth stays pi / 2.
  for (double depth : {1e-3, 1e-2, 1.0}) check(depth, 0.5 * pi);
  BOOST_TEST(graded_depth({}, 0.4, 0.125) == 0.125);
}

BOOST_AUTO_TEST_CASE(singularities_at_any_depth) {
  // Far above the clusters, the grading adds the same constant to every depth.
  const Grading grading{{{0.3, 1e-2}, {2.0, 1e-5}}};
  const double mean = mean_density(grading);
  for (double parameter : {0.3, 1.0, 2.0 + pi}) {
    const double added = graded_depth(grading, parameter, 70.0) * mean - 70.0;
    BOOST_TEST(added > 0.0);
    for (double depth : {90.0, 1e3, 1e5}) {
      const double found = graded_depth(grading, parameter, depth) * mean - depth;
      BOOST_TEST(std::abs(found - added) < 1e-14 * depth);
    }
    BOOST_TEST(std::abs(graded_depth(grading, parameter, 1e300) * mean / 1e300 - 1.0) < 1e-14);
    BOOST_TEST(std::isinf(graded_depth(grading, parameter, INFINITY)));
  }
}

BOOST_AUTO_TEST_CASE(gradings_that_make_no_sense_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](const Grading& grading) {
    BOOST_CHECK_THROW(sample(Circle{1.0}, 16, Side::fluid_outside, grading), std::invalid_argument);
    BOOST_CHECK_THROW(graded_parameters(grading, 16), std::invalid_argument);
    BOOST_CHECK_THROW(graded_depth(grading, 0.0, 1.0), std::invalid_argument);
    BOOST_CHECK_THROW(graded_depths(grading.clusters, {1.0, grading.strength}, 0.0, 1.0),
                      std::invalid_argument);
  };
  for (double bad : {0.0, -1.0, nan, infinity}) {
    refused({{{0.0, bad}}});
    refused({{{0.0, 0.1}}, bad});
  }
  for (double bad : {nan, infinity}) refused({{{bad, 0.1}}});
  BOOST_CHECK_THROW(sample(Circle{1.0}, 15, Side::fluid_outside, {{{0.0, 0.1}}}),
                    std::invalid_argument);
}
