// Checks the a-priori near test (06.5): the trapezoid rule's error is at most 200 exp(-N |Im s|),
// so the plain sum meets the tolerance for all targets that the test classifies as far.
#include "near_singular/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "double_layer/stresslet_sum.hpp"
#include "near_singular/cauchy.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_flows.hpp"
#include "support/vectors.hpp"
#include "trapezoid/grading.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::ExactFlow;
using test::inner_poles;
using test::largest;
using test::outer_poles;

namespace {

struct TestedCurve {
  Shape shape;
  Side side;
  Index n;
};
const std::vector<TestedCurve> tested_curves = {
    {Circle{1.0}, Side::fluid_outside, 64},        {Ellipse{1.0, 0.5}, Side::fluid_outside, 128},
    {Ellipse{1.5, 0.3}, Side::fluid_outside, 400}, {Star{1.0, 0.2, 5}, Side::fluid_outside, 400},
    {Circle{1.0}, Side::fluid_inside, 96},         {Star{1.0, 0.2, 5}, Side::fluid_inside, 400}};

// Returns targets in the fluid, at up to eight node spacings from random points of the curve.
ComplexVector random_targets(const TestedCurve& c, Index count) {
  std::mt19937 generator(2);
  std::uniform_int_distribution<Index> anywhere(0, 9999);
  std::uniform_real_distribution<double> spacings(0.0, 8.0);
  const Curve points = sample(c.shape, 10000, c.side);
  const ComplexVector normal = normals(points);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(c.n);
  ComplexVector targets(count);
  for (Complex& target : targets) {
    const Index j = anywhere(generator);
    target = points.x[j] - spacings(generator) * std::abs(points.dx[j]) * step * normal[j];
  }
  return targets;
}

// Holds the trapezoid rule's errors for an exact flow at random targets, relative to the density.
struct Errors {
  explicit Errors(const TestedCurve& c)
      : curve(sample(c.shape, c.n, c.side)), targets(random_targets(c, 3000)) {
    const ExactFlow& flow = c.side == Side::fluid_outside ? inner_poles : outer_poles;
    const ComplexVector density = test::density_of(curve, flow.velocity(curve.x));
    const ComplexVector velocity = StressletSum({curve})(targets, density);
    error = (velocity - flow.velocity(targets)).cwiseAbs() / largest(density);
  }
  // Returns N |Im s|, with the preimage s (06.4).
  double depth(Index i) const {
    const Complex s = preimage(curve, nearest_node(curve, targets[i]), targets[i]);
    return static_cast<double>(curve.size()) * std::abs(s.imag());
  }

  Curve curve;
  ComplexVector targets;
  Eigen::VectorXd error;
};

constexpr double rounding = 1e-13;

}  // namespace

BOOST_AUTO_TEST_CASE(the_bound_holds_and_is_not_idle) {
  for (const TestedCurve& c : tested_curves) {
    const Errors errors(c);
    std::vector<double> ratios;
    for (Index i = 0; i < errors.targets.size(); ++i) {
      const double bound = std::exp(-errors.depth(i));
      BOOST_TEST(errors.error[i] < 200.0 * bound + rounding);
      if (bound > 1e-10) ratios.push_back(errors.error[i] / bound);
    }
    BOOST_REQUIRE(ratios.size() > 500u);
    std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
    BOOST_TEST(ratios[ratios.size() / 2] > 0.3);
  }
}

BOOST_AUTO_TEST_CASE(far_targets_are_accurate_to_the_tolerance) {
  for (const TestedCurve& c : tested_curves) {
    const Errors errors(c);
    for (double tolerance : {1e-3, 1e-6, 1e-10, 1e-12}) {
      int far = 0, near = 0;
      for (Index i = 0; i < errors.targets.size(); ++i) {
        if (is_near(errors.curve, errors.targets[i], tolerance)) {
          ++near;
        } else {
          ++far;
          BOOST_TEST(errors.error[i] < tolerance);
        }
      }
      BOOST_TEST(far > 100);
      BOOST_TEST(near > 100);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_preimage_is_good_to_second_order) {
  // The ellipse z = cos(t + s) + i sin(t + s) / 2 is continued to complex s. Halving the distance
  // divides the error by eight.
  const Curve curve = sample(Ellipse{1.0, 0.5}, 32, Side::fluid_outside);
  for (Index node : {0, 3, 8, 21}) {
    const auto error = [&](double distance) {
      const Complex t = 2.0 * std::numbers::pi * static_cast<double>(node) / 32.0;
      const Complex target = curve.x[node] + std::polar(distance, 1.0 + static_cast<double>(node));
      const Complex u = t + preimage(curve, node, target);
      return std::abs(std::cos(u) + 0.5 * imaginary * std::sin(u) - target);
    };
    const double order = std::log2(error(2e-3) / error(1e-3));
    BOOST_TEST(std::abs(order - 3.0) < 0.1);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_near_beyond_the_reach) {
  for (const TestedCurve& c : tested_curves) {
    const Curve curve = sample(c.shape, c.n, c.side);
    for (double tolerance : {1e-3, 1e-12}) {
      const double reach = near_reach(curve, tolerance);
      int beyond = 0;
      for (Complex direction : test::random_vector(2000, 3)) {
        const Complex target = 4.0 * direction;
        const double distance = (curve.x.array() - target).abs().minCoeff();
        if (distance < reach) continue;
        ++beyond;
        BOOST_TEST(!is_near(curve, target, tolerance));
      }
      BOOST_TEST(beyond > 100);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_reach_of_a_circle_is_tight) {
  const Curve circle = sample(Circle{2.0}, 64, Side::fluid_outside);
  const double reach = near_reach(circle, 1e-6);
  BOOST_TEST(is_near(circle, 2.0 + 0.95 * reach, 1e-6));
  BOOST_TEST(!is_near(circle, 2.0 + reach, 1e-6));
}

BOOST_AUTO_TEST_CASE(graded_nodes_that_are_far_are_accurate_too) {
  // The distances from the curve cover all scales down to the cluster's width, where the map from
  // parameters to nodes is strongly nonlinear.
  const double width = 1e-3, parameter = 0.3;
  const Grading grading{{{parameter, width}}};
  for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
    const Curve curve = sample(Circle{1.0}, 128, side, grading);
    const CauchyCurve cauchy(curve);
    ComplexVector density = curve.x;
    const Complex centre = std::polar(1.0, parameter);
    for (Index j = 0; j < curve.size(); ++j) {
      density[j] = Complex{1.0, 0.5} / (1.0 + std::norm((curve.x[j] - centre) / (3.0 * width)));
    }
    const CauchyData data = cauchy.data(density);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (double tolerance : {1e-6, 1e-10}) {
      int far = 0, near = 0;
      for (int i = 0; i < 4000; ++i) {
        const double t = parameter + std::pow(10.0, 3.0 * uniform(generator) - 2.5);
        const double distance = std::pow(10.0, 3.0 * uniform(generator) - 3.1);
        const Complex target = std::polar(1.0 - curve.sign() * distance, t);
        if (is_near(curve, target, tolerance)) {
          ++near;
          continue;
        }
        ++far;
        const ComplexVector at = ComplexVector::Constant(1, target);
        const ComplexVector plain = StressletSum({curve})(at, density);
        BOOST_TEST(largest(plain - cauchy.velocity(data, 0, at)) < tolerance);
      }
      BOOST_TEST(far > 100);
      BOOST_TEST(near > 100);
    }
  }
}
