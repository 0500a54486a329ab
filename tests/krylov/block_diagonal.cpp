// Checks that the block-diagonal preconditioner solves for every component alone (05.11), for any
// shapes, numbers of nodes and orientations, and that equal components share their factors.
#include "krylov/block_diagonal.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "krylov/matrices.hpp"
#include "support/spectra.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Member = BlockDiagonalPreconditioner::Member;

namespace {

Component placed(const Shape& shape, Index n, double orientation, ComponentKind kind) {
  const Side side =
      kind == ComponentKind::enclosing_wall ? Side::fluid_inside : Side::fluid_outside;
  return {kind, place(sample(shape, n, side), {}, orientation), {}, {}, 0.0, {}};
}

std::shared_ptr<const MatrixXd> inverse_of(const Shape& shape, Index n, ComponentKind kind) {
  return std::make_shared<MatrixXd>(invert_block(self_block(placed(shape, n, 0.0, kind))));
}

}  // namespace

BOOST_AUTO_TEST_CASE(mixed_shapes_in_any_orientation) {
  // More components share the slender block than the preconditioner processes at once. The stars
  // share another block, and the wall has its own block.
  const Shape slender = Ellipse{1.0, 0.2}, star = Star{0.5, 0.2, 3}, wall = Ellipse{6.0, 4.0};
  const auto slender_inverse = inverse_of(slender, 32, ComponentKind::free_body);
  const auto star_inverse = inverse_of(star, 48, ComponentKind::free_body);
  std::vector<Member> members;
  std::vector<Component> components;
  for (int k = 0; k < 37; ++k) {
    const double orientation = 0.3 * k;
    if (k % 5 == 2) {
      members.push_back({star_inverse, orientation});
      components.push_back(placed(star, 48, orientation, ComponentKind::free_body));
    } else {
      members.push_back({slender_inverse, orientation});
      components.push_back(placed(slender, 32, orientation, ComponentKind::free_body));
    }
  }
  members.push_back({inverse_of(wall, 64, ComponentKind::enclosing_wall), -0.4});
  components.push_back(placed(wall, 64, -0.4, ComponentKind::enclosing_wall));

  Index size = 0;
  for (const Component& component : components) size += 2 * component.curve.size();
  const VectorXd v = test::normal_matrix(size, 1, 1);
  const VectorXd solved = BlockDiagonalPreconditioner(members)(v);
  BOOST_REQUIRE(solved.size() == size);
  Index first = 0;
  for (const Component& component : components) {
    const Index rows = 2 * component.curve.size();
    const VectorXd alone = test::solve(self_block(component), v.segment(first, rows));
    BOOST_TEST((solved.segment(first, rows) - alone).norm() < 1e-12 * alone.norm());
    first += rows;
  }
}

BOOST_AUTO_TEST_CASE(blocks_of_their_own_give_what_shared_ones_give) {
  const Shape shape = Ellipse{1.0, 0.2};
  const auto shared = inverse_of(shape, 32, ComponentKind::free_body);
  const auto copy = std::make_shared<MatrixXd>(*shared);
  const VectorXd v = test::normal_matrix(192, 1, 2);
  const VectorXd one =
      BlockDiagonalPreconditioner({{shared, 0.1}, {shared, 0.2}, {shared, 0.3}})(v);
  const VectorXd two = BlockDiagonalPreconditioner({{shared, 0.1}, {copy, 0.2}, {shared, 0.3}})(v);
  BOOST_TEST((one - two).norm() < 1e-14 * one.norm());
}

BOOST_AUTO_TEST_CASE(a_circular_wall_requires_no_inverse) {
  const auto inverse = inverse_of(Ellipse{1.0, 0.2}, 32, ComponentKind::free_body);
  const Component wall = placed(Circle{5.0}, 24, 0.0, ComponentKind::enclosing_wall);
  const VectorXd v = test::normal_matrix(64 + 48 + 64, 1, 4);
  const VectorXd solved = BlockDiagonalPreconditioner({{inverse}, {{}, 0.0, 24}, {inverse}})(v);
  BOOST_TEST((solved.head(64) - *inverse * v.head(64)).norm() < 1e-13 * v.norm());
  BOOST_TEST((solved.tail(64) - *inverse * v.tail(64)).norm() < 1e-13 * v.norm());
  BOOST_TEST((solved.segment(64, 48) == -2.0 * v.segment(64, 48)));
  // This inverts the block of the wall but for three rigid motions and the normal flow.
  const MatrixXd rest = -2.0 * self_block(wall) - MatrixXd::Identity(48, 48);
  const VectorXd sizes = test::singular_values(rest);
  BOOST_TEST(sizes[3] > 0.1);
  BOOST_TEST(sizes[4] < 1e-13);
}

BOOST_AUTO_TEST_CASE(the_same_bits_for_any_number_of_threads) {
  const auto inverse = inverse_of(Ellipse{1.0, 0.2}, 32, ComponentKind::free_body);
  std::vector<Member> members;
  for (int k = 0; k < 50; ++k) members.push_back({inverse, 0.1 * k});
  const BlockDiagonalPreconditioner precondition(members);
  const VectorXd v = test::normal_matrix(50 * 64, 1, 3);
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(1);
  const VectorXd alone = precondition(v);
  for (int threads : {2, 3}) {
    omp_set_num_threads(threads);
    BOOST_TEST((precondition(v) == alone));
  }
  omp_set_num_threads(threads_before);
}

BOOST_AUTO_TEST_CASE(a_singular_block_is_refused) {
  BOOST_CHECK_THROW(invert_block(MatrixXd::Ones(4, 4)), std::domain_error);
  BOOST_CHECK_THROW(invert_block(MatrixXd::Zero(4, 4)), std::domain_error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(invert_block(MatrixXd::Constant(4, 4, nan)), std::domain_error);
  const MatrixXd a = test::well_conditioned_matrix(6, 4);
  BOOST_TEST((invert_block(a) * a - MatrixXd::Identity(6, 6)).norm() < 1e-14);
}
