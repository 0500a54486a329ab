// Checks the expansions as matrices against the kernels: single precision is all that is lost.
#include "preconditioning/far_field.hpp"

#include <numbers>

#include <boost/test/unit_test.hpp>

#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"

namespace stokesbook::test {

using Eigen::MatrixXf;

namespace {

constexpr int order = 30;
constexpr double gauge = 70.0;
constexpr float rounding = 2e-5F;

const Box left{.centre = {0.4, -0.3}, .radius = 1.0}, right{.centre = {4.1, 1.7}, .radius = 1.2};
const Curve in_left = place(sample(Ellipse{0.8, 0.5}, 24, Side::fluid_outside), {0.5, -0.2}, 0.6);
const ComplexVector in_right{{Complex(4.9, 1.2), Complex(3.3, 1.5), Complex(4.0, 2.6)}};

float relative_error(const MatrixXf& found, const MatrixXf& exact) {
  return (found - exact).norm() / exact.norm();
}

// Returns the flows of the unit loads of of_loads() at the points.
MatrixXf flows_of_loads(Complex centre, double radius) {
  MatrixXf flows(2 * in_right.size(), 3);
  for (Eigen::Index i = 0; i < in_right.size(); ++i) {
    const Complex r = in_right[i] - centre;
    const double scale = -4.0 * std::numbers::pi;
    const Complex columns[] = {stokeslet(r, scale, 1.0, gauge),
                               stokeslet(r, scale * imaginary, 1.0, gauge),
                               rotlet(r, scale * radius, 1.0)};
    for (int k = 0; k < 3; ++k) {
      flows(2 * i, k) = static_cast<float>(columns[k].real());
      flows(2 * i + 1, k) = static_cast<float>(columns[k].imag());
    }
  }
  return flows;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(far_field)

BOOST_AUTO_TEST_CASE(a_conversion_gives_the_flow_of_densities) {
  const FarField far(order, gauge);
  const MatrixXf found = far.at_points(right, in_right) * far.multipole_to_local(left, right) *
                         far.of_densities(left, in_left);
  BOOST_TEST(relative_error(found, StressletSum({in_left}).matrix(in_right).cast<float>()) <
             rounding);
}

BOOST_AUTO_TEST_CASE(a_conversion_gives_the_flow_of_loads_with_their_gauge) {
  const FarField far(order, gauge);
  const Complex centre(0.6, -0.5);
  const MatrixXf found = far.at_points(right, in_right) * far.multipole_to_local(left, right) *
                         far.of_loads(left, centre, 0.7);
  BOOST_TEST(relative_error(found, flows_of_loads(centre, 0.7)) < rounding);
}

BOOST_AUTO_TEST_CASE(translations_keep_the_flow) {
  const FarField far(order, gauge);
  const Box large{.centre = {0.2, 0.1}, .radius = 1.6}, small{.centre = {4.2, 1.8}, .radius = 1.1};
  const Complex centre(0.6, -0.5);
  const MatrixXf found = far.at_points(small, in_right) * far.local_to_local(right, small) *
                         far.multipole_to_local(large, right) *
                         far.multipole_to_multipole(left, large) * far.of_loads(left, centre, 0.7);
  BOOST_TEST(relative_error(found, flows_of_loads(centre, 0.7)) < rounding);
}

BOOST_AUTO_TEST_CASE(weights_fall_by_half_with_the_order) {
  const Eigen::VectorXf weights = FarField(3, 1.0).weights();
  BOOST_TEST(weights.size() == 16);
  for (Eigen::Index k = 0; k < 16; ++k) {
    BOOST_TEST(weights[k] == 1.0F / static_cast<float>(1 << (k / 4)));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
