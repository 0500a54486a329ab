// Checks Green's representation u = S[sigma n] - D[u] (02.5) of an exact flow, and the flux (02.11)
// of a double layer through its curve.
#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "support/exact_flows.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::ExactFlow;
using test::largest;
using test::random_vector;

namespace {

const Complex position{0.4, -0.3};
const ComplexVector inner_points = ComplexVector{{Complex{0.5, -0.2}, Complex{0.2, -0.4}}};
const ComplexVector outer_points = ComplexVector{{Complex{2.5, 1.0}, Complex{-2.0, -2.2}}};

// Evaluates the single layer by the trapezoid rule.
ComplexVector single_layer(const Curve& curve, const ComplexVector& traction, double viscosity,
                           const ComplexVector& targets) {
  const Eigen::VectorXd w = weights(curve);
  return targets.unaryExpr([&](Complex z) {
    Complex u{};
    for (Index j = 0; j < curve.size(); ++j) {
      u += stokeslet(z - curve.x[j], w[j] * traction[j], viscosity, 0.7);
    }
    return u;
  });
}

// Returns S[sigma n] - D[u] for the boundary values of a flow.
ComplexVector represent(const ExactFlow& flow, const Curve& curve, const ComplexVector& targets) {
  constexpr double viscosity = 1.3;
  const ComplexVector normal = normals(curve);
  ComplexVector traction(curve.size());
  for (Index j = 0; j < curve.size(); ++j) {
    traction[j] = viscosity * flow.traction(curve.x[j], normal[j]);
  }
  return single_layer(curve, traction, viscosity, targets) -
         StressletSum({curve})(targets, flow.velocity(curve.x));
}

double normal_flux(const Curve& curve, const ComplexVector& velocity) {
  return normals(curve).conjugate().cwiseProduct(velocity).real().dot(weights(curve));
}

}  // namespace

BOOST_AUTO_TEST_CASE(outside_a_body) {
  const ExactFlow flow{{{{0.5, -0.3}, {0.5, -0.3}, 0.4}, {{0.2, -0.3}, {0.1, 0.8}, -0.1}}};
  const Curve body = place(sample(Star{1.0, 0.2, 5}, 400, Side::fluid_outside), position, 0.3);
  BOOST_TEST(largest(represent(flow, body, outer_points) - flow.velocity(outer_points)) < 1e-14);
  BOOST_TEST(largest(represent(flow, body, inner_points)) < 2e-13);
}

BOOST_AUTO_TEST_CASE(inside_a_wall) {
  const ExactFlow flow{{{{3.0, 1.0}, {0.5, -0.3}, 0.4}, {{-1.5, 2.0}, {0.1, 0.8}, -0.1}}, 0.7};
  const Curve wall = place(sample(Star{1.0, 0.2, 5}, 400, Side::fluid_inside), position, 0.3);
  BOOST_TEST(largest(represent(flow, wall, inner_points) - flow.velocity(inner_points)) < 1e-14);
  BOOST_TEST(largest(represent(flow, wall, outer_points)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(flux_through_one_curve) {
  // The flux (02.11) is -int eta.n for a body and 0 for an enclosing wall, for any density, smooth
  // or not. The kernel, integrated by the trapezoid rule, fulfils the identity to the accuracy of
  // the rule.
  for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
    const Curve curve = sample(Ellipse{2.0, 1.0}, 96, side);
    const ComplexVector density = random_vector(96, 1);
    const Eigen::VectorXd principal_value = double_layer_matrix(curve) * interleaved(density);
    const ComplexVector limit = deinterleaved(principal_value) - 0.5 * density;
    const double expected = side == Side::fluid_outside ? -normal_flux(curve, density) : 0.0;
    BOOST_TEST(std::abs(normal_flux(curve, limit) - expected) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(no_net_flux_out_of_a_domain_with_holes) {
  const std::vector<Curve> curves = {
      place(sample(Ellipse{0.5, 0.3}, 64, Side::fluid_outside), {0.9, 0.2}, 0.4),
      place(sample(Star{0.5, 0.2, 3}, 160, Side::fluid_outside), {-0.9, -0.1}, 1.0),
      sample(Ellipse{3.0, 2.0}, 160, Side::fluid_inside)};
  const StressletSum sum(curves);
  const ComplexVector density = random_vector(sum.size(), 2);
  const ComplexVector at_nodes = sum(density);
  double total = 0.0, largest_part = 0.0;
  Index first = 0;
  for (const Curve& curve : curves) {
    const ComplexVector own = density.segment(first, curve.size());
    const ComplexVector limit =
        at_nodes.segment(first, curve.size()) - 0.5 * own + diagonal_velocity(curve, own);
    const double flux = normal_flux(curve, limit);
    total += flux;
    largest_part = std::max(largest_part, std::abs(flux));
    first += curve.size();
  }
  BOOST_TEST(largest_part > 0.01);
  BOOST_TEST(std::abs(total) < 1e-13);
}
