// Tests that every background flow has the formula of the scene format and no divergence.

#include "suspension/bodies/background_flow.hpp"

#include <boost/test/unit_test.hpp>

namespace stokesbook::test {
namespace {

Complex at(const BackgroundFlow& flow, Complex point) {
  return background_velocity(flow, ComplexVector{{point}})[0];
}

}  // namespace

BOOST_AUTO_TEST_SUITE(background_flows)

BOOST_AUTO_TEST_CASE(formulas) {
  const double x = 0.7, y = -1.9, rate = 1.3;
  Eigen::Matrix2d gradient;
  gradient << 0.2, 0.5, -0.9, -0.2;
  const auto is = [&](const BackgroundFlow& flow, Complex velocity) {
    BOOST_TEST(std::abs(at(flow, {x, y}) - velocity) < 1e-15);
  };
  is(QuiescentFlow{}, 0.0);
  is(UniformFlow{{0.3, -0.4}}, {0.3, -0.4});
  is(ShearFlow{rate}, {rate * y, 0.0});
  is(ExtensionalFlow{rate}, {rate * x, -rate * y});
  is(TaylorGreenFlow{rate}, {rate * std::cos(x) * std::sin(y), -rate * std::sin(x) * std::cos(y)});
  is(LinearFlow{gradient}, {0.2 * x + 0.5 * y, -0.9 * x - 0.2 * y});
  const double cx = 3.0, cy = -0.6;
  is(ShearFlow{rate, {cx, cy}}, {rate * (y - cy), 0.0});
  is(ExtensionalFlow{rate, {cx, cy}}, {rate * (x - cx), -rate * (y - cy)});
  is(LinearFlow{gradient, {cx, cy}},
     {0.2 * (x - cx) + 0.5 * (y - cy), -0.9 * (x - cx) - 0.2 * (y - cy)});
  is(SumFlow{{UniformFlow{{0.3, -0.4}}, ShearFlow{rate, {cx, cy}}, SumFlow{{ShearFlow{-0.5}}}}},
     {0.3 + rate * (y - cy) - 0.5 * y, -0.4});
}

BOOST_AUTO_TEST_CASE(derivatives) {
  Eigen::Matrix2d gradient;
  gradient << 0.2, 0.5, -0.9, -0.2;
  const Complex point{0.7, -1.9};
  const double h = 1e-4;
  for (const BackgroundFlow& flow :
       {BackgroundFlow{QuiescentFlow{}}, BackgroundFlow{UniformFlow{{0.3, -0.4}}},
        BackgroundFlow{ShearFlow{1.3}}, BackgroundFlow{ExtensionalFlow{1.3}},
        BackgroundFlow{TaylorGreenFlow{1.3}}, BackgroundFlow{LinearFlow{gradient}},
        BackgroundFlow{SumFlow{{TaylorGreenFlow{1.3}, LinearFlow{gradient, {1.0, 2.0}}}}}}) {
    const Complex u_x = (at(flow, point + h) - at(flow, point - h)) / (2.0 * h);
    const Complex u_y =
        (at(flow, point + h * imaginary) - at(flow, point - h * imaginary)) / (2.0 * h);
    const auto [pressure, vorticity, strain] = background_derivatives(flow, point);
    BOOST_TEST(pressure == 0.0);
    BOOST_TEST(std::abs(vorticity - (u_x.imag() - u_y.real())) < 1e-8);
    BOOST_TEST(std::abs(strain - Complex(u_x.real() - u_y.imag(), u_x.imag() + u_y.real())) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(no_divergence) {
  Eigen::Matrix2d gradient;
  gradient << 0.2, 0.5, -0.9, -0.2;
  const Complex point{0.7, -1.9};
  const double h = 1e-4;
  for (const BackgroundFlow& flow :
       {BackgroundFlow{ShearFlow{1}}, BackgroundFlow{ExtensionalFlow{1}},
        BackgroundFlow{TaylorGreenFlow{1}}, BackgroundFlow{LinearFlow{gradient}}}) {
    const Complex along_x = at(flow, point + h) - at(flow, point - h);
    const Complex along_y = at(flow, point + h * imaginary) - at(flow, point - h * imaginary);
    BOOST_TEST(std::abs(along_x.real() + along_y.imag()) < 1e-15);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
