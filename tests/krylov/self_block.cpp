// Checks a component's own block: spectra of circles, and the effects of rotation, translation and
// scale.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "krylov/block_diagonal.hpp"
#include "support/spectra.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

constexpr ComponentKind all_kinds[] = {ComponentKind::free_body, ComponentKind::prescribed,
                                       ComponentKind::enclosing_wall};

// Returns a component about its boundary's centroid, moved by `offset` in the component's frame.
Component component(ComponentKind kind, const Shape& shape, Index n, Complex position,
                    double orientation, Complex offset = {}) {
  const Side side =
      kind == ComponentKind::enclosing_wall ? Side::fluid_inside : Side::fluid_outside;
  const Curve curve = place(sample(shape, n, side), position, orientation);
  return {kind, curve, position + std::polar(1.0, orientation) * offset, {}, 0.0, {}};
}

// Returns the matrix that rotates every node's vector by an angle.
MatrixXd rotation(Index n, double angle) {
  MatrixXd q = MatrixXd::Zero(2 * n, 2 * n);
  for (Index j = 0; j < n; ++j) {
    q.block<2, 2>(2 * j, 2 * j) = Eigen::Rotation2Dd(angle).toRotationMatrix();
  }
  return q;
}

double largest(const MatrixXd& matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

}  // namespace

BOOST_AUTO_TEST_CASE(eigenvalues_of_a_circle_are_minus_one_and_minus_one_half) {
  // The three rigid modes and the normal mode have the eigenvalue -1, because of P or F on a body,
  // and because of D or N_0 on a wall. All other modes have the eigenvalue -1/2, for any radius.
  for (ComponentKind kind : all_kinds) {
    for (double radius : {1e-3, 1.0, 1e3}) {
      const MatrixXd block =
          self_block(component(kind, Circle{radius}, 32, radius * Complex{0.3, -2.0}, 0.4));
      Eigen::VectorXcd values = test::eigenvalues(block);
      BOOST_TEST(values.imag().cwiseAbs().maxCoeff() < 1e-7);
      std::vector<double> real(static_cast<std::size_t>(values.size()));
      std::transform(values.begin(), values.end(), real.begin(),
                     [](Complex z) { return z.real(); });
      std::sort(real.begin(), real.end());
      for (std::size_t i = 0; i < real.size(); ++i) {
        BOOST_TEST(std::abs(real[i] - (i < 4 ? -1.0 : -0.5)) < 1e-13);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_block_turns_with_the_component) {
  const Index n = 48;
  const MatrixXd q = rotation(n, 0.7);
  for (ComponentKind kind : all_kinds) {
    for (Complex offset : {Complex{}, Complex{0.2, 0.1}}) {
      const Shape shape = Star{1.0, 0.2, 3};
      const MatrixXd reference = self_block(component(kind, shape, n, {}, 0.0, offset));
      const MatrixXd placed = self_block(component(kind, shape, n, {5.0, -3.0}, 0.7, offset));
      BOOST_TEST(largest(placed - q * reference * q.transpose()) < 2e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_block_does_not_depend_on_the_size) {
  for (ComponentKind kind : all_kinds) {
    const MatrixXd reference = self_block(component(kind, Ellipse{1.0, 0.4}, 48, {}, 0.0));
    for (double scale : {1e-3, 1e3}) {
      const Shape scaled = Ellipse{scale, 0.4 * scale};
      BOOST_TEST(largest(self_block(component(kind, scaled, 48, {}, 0.0)) - reference) < 1e-14);
    }
  }
}

BOOST_AUTO_TEST_CASE(rigid_motions_are_eigenvectors_of_a_free_body) {
  // (-1/2 + D)(I - P) - P (03.11) maps a rigid motion to its negative, about any centre.
  const Component body =
      component(ComponentKind::free_body, Star{1.0, 0.2, 5}, 100, {0.5, 0.5}, 0.3, {0.3, -0.1});
  const ComplexVector motion =
      (Complex{0.2, -0.7} + 1.3 * imaginary * (body.curve.x.array() - Complex{2.0, 1.0})).matrix();
  const Eigen::VectorXd image = self_block(body) * interleaved(motion);
  BOOST_TEST(largest(image + interleaved(motion)) < 1e-14);
}

BOOST_AUTO_TEST_CASE(the_gauge_of_a_held_circle_moves_its_translations_only) {
  // The Stokeslet F = -4 pi mu U has the mean velocity (log(a / ell) - 1/2) U on its circle
  // (03.12): -U at ell = sqrt(e) a, and zero at the degenerate scale ell = a / sqrt(e).
  const Component held = component(ComponentKind::prescribed, Circle{2.0}, 32, {}, 0.0);
  const MatrixXd own = self_block(held);
  BOOST_TEST(largest(own - self_block(held, 2.0 * std::sqrt(std::exp(1.0)))) < 1e-15);
  const ComplexVector shift = ComplexVector::Ones(32);
  for (double gauge : {1.0, 5.0, 100.0}) {
    const Eigen::VectorXd image = self_block(held, gauge) * interleaved(shift);
    const double expected = std::log(2.0 / gauge) - 0.5;
    BOOST_TEST(std::abs(deinterleaved(image).mean() - expected) <
               1e-14 * (1.0 + std::abs(expected)));
  }
  BOOST_CHECK_THROW(invert_block(self_block(held, 2.0 / std::sqrt(std::exp(1.0)))),
                    std::domain_error);
}
