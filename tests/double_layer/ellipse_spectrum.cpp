// Checks the double layer of an ellipse against closed forms: action on modes, spectrum (01.10).
// With m = (a - b) / (a + b), c_k = (1 - m^2) k m^{k-1} and eta = sum eta_k e^{ikt}:
// (D eta)_k = -(s/2) [ m^|k| eta_{-k} - c_k conj(eta_k) (k >= 1 only) ].
#include <cmath>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "support/spectra.hpp"
#include "support/vectors.hpp"
#include "trapezoid/fourier.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::largest;

namespace {

double coupling(double m, Index k) {
  return (1.0 - m * m) * static_cast<double>(k) * std::pow(m, static_cast<double>(k - 1));
}

}  // namespace

BOOST_AUTO_TEST_CASE(action_on_fourier_modes) {
  const double a = 1.5, b = 0.5, m = 0.5;
  constexpr Index n = 128, highest = 20;
  const ComplexVector modes = test::random_vector(2 * highest + 1, 1);
  ComplexVector c = ComplexVector::Zero(n), expected = ComplexVector::Zero(n);
  for (Index k = -highest; k <= highest; ++k) c[(k + n) % n] = modes[k + highest];
  for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
    const Curve curve = sample(Ellipse{a, b}, n, side);
    for (Index k = -highest; k <= highest; ++k) {
      const double depth = std::pow(m, static_cast<double>(std::abs(k)));
      Complex sum = depth * modes[highest - k];
      if (k >= 1) sum -= coupling(m, k) * std::conj(modes[k + highest]);
      expected[(k + n) % n] = -0.5 * curve.sign() * sum;
    }
    const ComplexVector density = fourier_values(c);
    const Eigen::VectorXd velocity = double_layer_matrix(curve) * interleaved(density);
    BOOST_TEST(largest(fourier_coefficients(deinterleaved(velocity)) - expected) < 3e-15);
  }
}

BOOST_AUTO_TEST_CASE(closed_form_of_the_whole_spectrum) {
  for (const double aspect : {1.0, 2.0, 3.0, 6.0}) {
    const Ellipse ellipse{aspect, 1.0};
    const Index n = aspect > 3.0 ? 192 : 96;
    for (const Side side : {Side::fluid_outside, Side::fluid_inside}) {
      const Eigen::VectorXcd computed =
          test::eigenvalues(double_layer_matrix(sample(ellipse, n, side)));
      const Eigen::VectorXd exact = test::ellipse_spectrum(ellipse, side, n);
      BOOST_TEST(test::spectrum_distance(computed, exact) < 1e-12);
      BOOST_TEST(test::spectrum_distance(computed, exact, 20) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_circle_has_three_rigid_modes_and_one_normal_one) {
  const Curve circle = sample(Circle{0.7}, 32, Side::fluid_outside);
  Eigen::VectorXd known = Eigen::VectorXd::Zero(64);
  known.head(4) << 0.5, 0.5, 0.5, -0.5;
  BOOST_TEST(test::spectrum_distance(test::eigenvalues(double_layer_matrix(circle)), known) <
             1e-14);
}
