// Checks pressure, vorticity and strain (06.16) of several curves. The values are those of an exact
// flow at any distance and on the nodes, turn with the curves, and have the same bits for any
// number of threads.
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "double_layer/stresslet_sum.hpp"
#include "near_singular/near_correction.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_derivatives.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::ExactFlow;
using test::largest;

namespace {

// Each body has its own exact flow, and the sum of these flows is the sum of all double layers.
struct TwoBodies {
  explicit TwoBodies(double gap) {
    const Curve ellipse = sample(Ellipse{1.0, 0.5}, 160, Side::fluid_outside);
    const Curve star = sample(Star{0.5, 0.15, 3}, 200, Side::fluid_outside);
    const Complex second = centre + std::polar(1.0, 0.4) * Complex{1.0 + gap + 0.575, 0.0};
    placed = {{std::make_shared<const CauchyCurve>(ellipse), centre, 0.4},
              {std::make_shared<const CauchyCurve>(star), second, 0.4 + std::numbers::pi / 3.0}};
    flow = {{{centre + Complex{0.1, 0.02}, {0.5, -0.3}, 0.4},
             {second + Complex{-0.05, 0.03}, {0.1, 0.2}, -0.1}}};
    density.resize(360);
    for (std::size_t k : {0U, 1U}) {
      const Curve curve = place(placed[k].curve(), placed[k].position, placed[k].orientation);
      curves.push_back(curve);
      density.segment(k == 0 ? 0 : 160, curve.size()) =
          test::density_of(curve, ExactFlow{{flow.poles[k]}}.velocity(curve.x));
    }
  }

  std::vector<FlowDerivatives> derivatives(const ComplexVector& targets, double tolerance) const {
    std::vector<FlowDerivatives> sum = StressletSum(curves).derivatives(targets, density);
    const std::vector<FlowDerivatives> corrections =
        near_derivative_corrections(placed, density, targets, tolerance);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += corrections[i];
    return sum;
  }

  // Returns the largest error relative to the largest strain.
  double error(const ComplexVector& targets) const {
    return test::derivative_error(derivatives(targets, 1e-14), flow, targets, Side::fluid_outside);
  }

  Complex centre{0.7, -0.2};
  std::vector<PlacedCurve> placed;
  ExactFlow flow;
  std::vector<Curve> curves;
  ComplexVector density;
};

}  // namespace

BOOST_AUTO_TEST_CASE(at_any_distance_and_on_the_nodes) {
  for (double gap : {1e-1, 1e-3, 1e-6}) {
    const TwoBodies bodies(gap);
    for (const Curve& curve : bodies.curves) {
      BOOST_TEST(bodies.error(curve.x) < 1e-10);
      for (double distance : {0.5 * gap, 1e-2 * gap}) {
        BOOST_TEST(bodies.error(curve.x - distance * normals(curve)) < 1e-10);
      }
    }
    BOOST_TEST(bodies.error(ComplexVector{{Complex{3.0, 1.0}, Complex{0.7, 0.4}}}) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(only_the_cauchy_scheme_has_them) {
  const Curve circle = sample(Circle{1.0}, 32, Side::fluid_outside);
  const auto scheme = std::make_shared<const InterpolationCurve>(circle, InterpolationSettings{});
  BOOST_CHECK_THROW(near_derivative_corrections({{scheme, {}, 0.0}}, circle.x, circle.x, 1e-10),
                    std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(derivatives_have_the_same_bits_for_any_number_of_threads) {
  const TwoBodies bodies(1e-2);
  const int threads_before = omp_get_max_threads();
  const auto flow = [&](int threads) {
    omp_set_num_threads(threads);
    return bodies.derivatives(bodies.curves[1].x, 1e-10);
  };
  const std::vector<FlowDerivatives> alone = flow(1), together = flow(3);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    BOOST_TEST(alone[i].pressure == together[i].pressure);
    BOOST_TEST(alone[i].strain == together[i].strain);
  }
  omp_set_num_threads(threads_before);
}
