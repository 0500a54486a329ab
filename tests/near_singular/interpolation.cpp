// Checks that the interpolation scheme reaches the accuracies that (06.6) and (06.7) predict,
// inside and outside, at any distance and on the curve, and is nowhere less accurate than the plain
// trapezoid rule.
#include "near_singular/interpolation.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "near_singular/near_correction.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_flows.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::ExactFlow;
using test::inner_poles;
using test::largest;
using test::outer_poles;

namespace {

// Holds the flow of a 2:1 ellipse, with the scheme.
struct InterpolatedFlow {
  InterpolatedFlow(Side side, Index n, const InterpolationSettings& settings)
      : flow(side == Side::fluid_inside ? outer_poles : inner_poles),
        curve(sample(Ellipse{1.0, 0.5}, n, side)),
        density(test::density_of(curve, flow.velocity(curve.x))),
        scheme(curve, settings),
        data(scheme.data(density)) {}

  // Returns the largest error, relative to the flow on the curve, at a distance given in spacings
  // of the node nearest to the target.
  double error_at(double spacings) const {
    const Curve between = sample(Ellipse{1.0, 0.5}, 122, curve.side);
    const double step = spacings * 2.0 * std::numbers::pi / static_cast<double>(curve.size());
    const ComplexVector targets =
        between.x - step * between.dx.cwiseAbs().cwiseProduct(normals(between));
    return largest(scheme.velocity(data, 0, targets) - flow.velocity(targets)) /
           largest(flow.velocity(curve.x));
  }
  double worst() const {
    double error = 0.0;
    for (double spacings : {2.0, 1.1, 0.9, 0.5, 0.3, 0.1, 1e-2, 1e-6, 0.0}) {
      error = std::max(error, error_at(spacings));
    }
    return error;
  }

  const ExactFlow& flow;
  Curve curve;
  ComplexVector density;
  InterpolationCurve scheme;
  InterpolationData data;
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_tolerance_is_met_where_the_curve_resolves_the_flow) {
  for (Side side : {Side::fluid_inside, Side::fluid_outside}) {
    const Index n = 256;
    BOOST_TEST(InterpolatedFlow(side, n, InterpolationSettings::for_tolerance(1e-6)).worst() <
               1e-6);
    BOOST_TEST(InterpolatedFlow(side, n, InterpolationSettings::for_tolerance(1e-8)).worst() <
               1e-8);
    BOOST_TEST(InterpolatedFlow(side, n, InterpolationSettings::for_tolerance(1e-10)).worst() <
               1e-10);
  }
}

// With the published parameters the error is about 1e-6 at N = 128 (specification, table of section
// A), and is largest at half a spacing. Nearer to the curve the error is proportional to the
// distance.
BOOST_AUTO_TEST_CASE(published_parameters) {
  const InterpolatedFlow outside(Side::fluid_outside, 128, InterpolationSettings::published(128));
  BOOST_TEST(outside.worst() < 1e-5);
  BOOST_TEST(outside.error_at(0.5) > 1e-8);
  BOOST_TEST(outside.error_at(1e-3) < 2e-2 * outside.error_at(0.5));
  BOOST_TEST(outside.error_at(1e-4) == 0.1 * outside.error_at(1e-3),
             boost::test_tools::tolerance(0.1));
  BOOST_TEST(outside.error_at(0.0) < 1e-12);
}

BOOST_AUTO_TEST_CASE(rows_of_the_interpolation_scheme) {
  for (Side side : {Side::fluid_inside, Side::fluid_outside}) {
    const InterpolatedFlow solved(side, 64, InterpolationSettings::for_tolerance(1e-6));
    const Curve between = sample(Ellipse{1.0, 0.5}, 10, side);
    ComplexVector targets(30);
    targets << between.x - 1e-3 * normals(between), between.x - 0.1 * normals(between),
        solved.curve.x.head(10);
    const Eigen::VectorXd product =
        solved.scheme.velocity_rows(targets) * interleaved(solved.density);
    BOOST_TEST(largest(deinterleaved(product) - solved.scheme.velocity(solved.data, 0, targets)) <
               1e-12 * largest(solved.density));
  }
}

// Two ellipses lie side by side. With the scheme, the corrected sum is never less accurate than the
// plain sum; the Cauchy scheme is more accurate.
BOOST_AUTO_TEST_CASE(never_worse_than_the_plain_rule) {
  const Index n = 128;
  const Curve ellipse = sample(Ellipse{1.0, 0.5}, n, Side::fluid_outside);
  const auto interpolation = std::make_shared<const InterpolationCurve>(
      ellipse, InterpolationSettings::for_tolerance(1e-6));
  const auto cauchy = std::make_shared<const CauchyCurve>(ellipse);
  for (double gap : {0.5, 0.2, 0.1, 1e-2, 1e-4}) {
    const Complex centre{0.1, 1.0 + gap};
    const ComplexVector targets =
        place(sample(Ellipse{1.0, 0.5}, 90, Side::fluid_outside), centre, 0.0).x;
    const ComplexVector density = test::density_of(ellipse, inner_poles.velocity(ellipse.x));
    const ComplexVector exact = inner_poles.velocity(targets);
    const ComplexVector plain = StressletSum({ellipse})(targets, density);
    const auto error_with = [&](const CloseScheme& scheme) {
      const NearCorrection near({{scheme, {}, 0.0}}, targets, Targets::points, {1e-8});
      return largest(plain + near(density) - exact) / largest(exact);
    };
    const double error = error_with(interpolation);
    BOOST_TEST(error < 2e-6);
    BOOST_TEST(error < largest(plain - exact) / largest(exact) + 1e-9);
    BOOST_TEST(error_with(cauchy) < 2e-8);
  }
}

BOOST_AUTO_TEST_CASE(settings_out_of_range) {
  const Curve circle = sample(Circle{1.0}, 16, Side::fluid_outside);
  for (const InterpolationSettings& settings :
       {InterpolationSettings{.degree = 0}, InterpolationSettings{.step = 0.0},
        InterpolationSettings{.upsampling = 0}}) {
    BOOST_CHECK_THROW(InterpolationCurve(circle, settings), std::invalid_argument);
  }
}
