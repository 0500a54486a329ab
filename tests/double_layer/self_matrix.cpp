// Checks the matrix of a curve on itself: its diagonal limit (02.9), its convergence, and its
// invariance.
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using test::largest;
using test::random_vector;

namespace {

ComplexVector smooth_density(Index n) {
  ComplexVector density(n);
  for (Index j = 0; j < n; ++j) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    density[j] = {std::cos(2.0 * t), std::exp(std::sin(t))};
  }
  return density;
}

ComplexVector layer_velocity(const Curve& curve, const ComplexVector& density) {
  const Eigen::VectorXd velocity = double_layer_matrix(curve) * interleaved(density);
  return deinterleaved(velocity);
}

}  // namespace

BOOST_AUTO_TEST_CASE(entries_are_kernel_times_weight) {
  const Curve curve = sample(Star{1.0, 0.2, 5}, 40, Side::fluid_inside);
  const MatrixXd matrix = double_layer_matrix(curve);
  const ComplexVector normal = normals(curve);
  const Eigen::VectorXd w = weights(curve);
  for (Index i : {0, 7, 39}) {
    for (Index j : {1, 20, 38}) {
      const Eigen::Vector2d column = matrix.block<2, 1>(2 * i, 2 * j + 1);
      const Complex expected = w[j] * stresslet(curve.x[i] - curve.x[j], normal[j], imaginary);
      BOOST_TEST(std::abs(Complex{column[0], column[1]} - expected) < 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_diagonal_is_the_limit_of_the_kernel) {
  // Along the curve, the kernel times the weight tends to the diagonal (02.9) as the target
  // approaches the node. The mean of both sides converges to second order.
  constexpr Index n = 1 << 14;
  for (const Shape& shape : {Shape{Ellipse{2.0, 1.0}}, Shape{Star{1.0, 0.2, 5}}}) {
    for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
      const Curve curve = sample(shape, n, side);
      const ComplexVector normal = normals(curve);
      const Eigen::VectorXd w = weights(curve);
      const ComplexVector density = random_vector(n, 1);
      const ComplexVector diagonal = diagonal_velocity(curve, density);
      for (Index j : {n / 64, n / 10, n / 2}) {
        const auto beside = [&](Index i) {
          return w[j] * stresslet(curve.x[i] - curve.x[j], normal[j], density[j]);
        };
        const Complex limit = 0.5 * (beside(j - 1) + beside(j + 1));
        BOOST_TEST(std::abs(limit - diagonal[j]) < 1e-4 * std::abs(diagonal[j]));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_diagonal_alone_is_the_matrix_diagonal) {
  const Curve curve = sample(Star{1.0, 0.2, 5}, 32, Side::fluid_outside);
  const ComplexVector density = random_vector(32, 2);
  const ComplexVector diagonal = diagonal_velocity(curve, density);
  const MatrixXd matrix = double_layer_matrix(curve);
  for (Index j = 0; j < 32; ++j) {
    const Eigen::Vector2d block =
        matrix.block<2, 2>(2 * j, 2 * j) * Eigen::Vector2d{density[j].real(), density[j].imag()};
    BOOST_TEST(std::abs(Complex{block[0], block[1]} - diagonal[j]) < 1e-16);
  }
}

BOOST_AUTO_TEST_CASE(the_sum_converges_geometrically) {
  // A wrong diagonal would leave an error of order 1/N.
  struct Case {
    Shape shape;
    Index n;
  };
  for (const auto& [shape, n] : {Case{Ellipse{2.0, 1.0}, 64}, Case{Star{1.0, 0.2, 5}, 256}}) {
    const ComplexVector coarse =
        layer_velocity(sample(shape, n, Side::fluid_outside), smooth_density(n));
    const ComplexVector fine =
        layer_velocity(sample(shape, 4 * n, Side::fluid_outside), smooth_density(4 * n));
    BOOST_TEST(largest(coarse - fine(Eigen::seqN(0, n, 4))) < 2e-13);
  }
}

BOOST_AUTO_TEST_CASE(rotation_translation_and_scaling) {
  const double orientation = 0.9;
  const Complex turn = std::polar(1.0, orientation);
  const ComplexVector density = random_vector(80, 3);
  for (Side side : {Side::fluid_outside, Side::fluid_inside}) {
    const ComplexVector velocity = layer_velocity(sample(Star{1.0, 0.3, 3}, 80, side), density);
    for (double scale : {1e-3, 1.0, 1e3}) {
      const Curve curve =
          place(sample(Star{scale, 0.3, 3}, 80, side), scale * Complex{2.0, -1.0}, orientation);
      BOOST_TEST(largest(layer_velocity(curve, turn * density) - turn * velocity) < 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_other_side_changes_the_sign) {
  const ComplexVector density = random_vector(48, 4);
  const Shape shape = Ellipse{1.0, 0.4};
  const ComplexVector body = layer_velocity(sample(shape, 48, Side::fluid_outside), density);
  const ComplexVector wall = layer_velocity(sample(shape, 48, Side::fluid_inside), density);
  BOOST_TEST(largest(body + wall) < 1e-16);
}

BOOST_AUTO_TEST_CASE(interleaved_vectors_share_the_memory) {
  const ComplexVector v = ComplexVector{{Complex{1.0, 2.0}, Complex{3.0, 4.0}}};
  BOOST_TEST((interleaved(v) == Eigen::Vector4d{1.0, 2.0, 3.0, 4.0}));
  BOOST_TEST((deinterleaved(interleaved(v)) == v));
}
