// Checks mobility matrices of bodies without symmetry: reference numbers of the specification,
// symmetry (03.15), positive definiteness, and the effect of a change of gauge.

#include <boost/test/unit_test.hpp>

#include "support/mobility_matrix.hpp"
#include "support/spectra.hpp"

namespace stokesbook::test {
namespace {

ComplexVector shear(const ComplexVector& x) {
  return x.imag().cast<Complex>();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(mobility_matrices)

BOOST_AUTO_TEST_CASE(reference_star_N1) {
  const Component star = free_body(Star{1, 0.2, 5}, 192, {});
  const StokesProblem sheared{{star}, 1.0, shear(star.curve.x), {}};
  for (const ClosureForm form : all_forms) {
    const Eigen::MatrixXd matrix = mobility_matrix({{star}, 1.0, {}, 1.0}, form);
    const Eigen::Vector3d diagonal{0.031871196888335535, 0.031871196888335535,
                                   0.064313453523979353};
    BOOST_TEST((matrix - Eigen::MatrixXd(diagonal.asDiagonal())).cwiseAbs().maxCoeff() < 1e-14);
    BOOST_TEST(distance(solve_dense(sheared, form).motions[0], {0.0, -0.5}) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(reference_lopsided_N2) {
  const Component body = free_body(lopsided_curve(), 192, {});
  const StokesProblem sheared{{body}, 1.0, shear(body.curve.x), {}};
  Eigen::Matrix3d exact;
  exact << 0.041946286524008621, 2.9207185698430717e-4, -0.0042367069525271845,  //
      2.9207185698430717e-4, 0.028597241322518053, -0.0024189436540131763,       //
      -0.0042367069525271845, -0.0024189436540131763, 0.068063075882533061;
  const RigidMotion exact_in_shear{{0.013264317184109857, 0.038045820996011732},
                                   -0.34278665599347508};
  for (const ClosureForm form : all_forms) {
    const Eigen::MatrixXd matrix = mobility_matrix({{body}, 1.0, {}, 1.0}, form);
    BOOST_TEST((matrix - exact).cwiseAbs().maxCoeff() < 1e-14);
    BOOST_TEST(distance(solve_dense(sheared, form).motions[0], exact_in_shear) < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(is_symmetric_and_positive) {
  const StokesProblem problem{{free_body(lopsided_curve(), 128, {{-1.7, 0.2}, 1.0}),
                               free_body(Ellipse{1, 0.5}, 96, {{1.2, 0.9}, 0.4}),
                               free_body(Star{0.8, 0.15, 3}, 96, {{0.6, -1.6}})},
                              1.3,
                              {},
                              100.0};
  const Eigen::MatrixXd matrix = mobility_matrix(problem, ClosureForm::reduced);
  BOOST_TEST((matrix - matrix.transpose()).cwiseAbs().maxCoeff() < 1e-13);
  // Bodies within a gauge length dissipate energy under any loads.
  BOOST_TEST(symmetric_eigenvalues(matrix)[0] > 0.0);
}

// A change ell -> ell' adds sum F log(ell' / ell) / (4 pi mu) to every velocity, and no rotation.
BOOST_AUTO_TEST_CASE(gauge_shifts_velocities) {
  const StokesProblem problem{{free_body(lopsided_curve(), 96, {{-1.7, 0.2}, 1.0}),
                               free_body(Ellipse{1, 0.5}, 96, {{1.2, 0.9}, 0.4})},
                              1.3,
                              {},
                              3.0};
  StokesProblem other = problem;
  other.gauge_length = 50.0;
  Eigen::MatrixXd shift =
      mobility_matrix(other, ClosureForm::reduced) - mobility_matrix(problem, ClosureForm::reduced);
  const double expected = std::log(50.0 / 3.0) / (4 * std::numbers::pi * 1.3);
  for (Eigen::Index i = 0; i < 6; ++i) {
    for (Eigen::Index j = 0; j < 6; ++j) {
      const bool same_direction = i % 3 == j % 3 && i % 3 != 2;
      BOOST_TEST(std::abs(shift(i, j) - (same_direction ? expected : 0.0)) < 1e-14);
    }
  }
}

// Balanced forces require no gauge; without a gauge the fluid is at rest far away, as with any
// gauge.
BOOST_AUTO_TEST_CASE(balanced_forces_need_no_gauge) {
  const Complex force{0.6, -0.8};
  StokesProblem problem{{free_body(Circle{1.0}, 48, {{-10.0, 0.0}}, {force, 0.3}),
                         free_body(Circle{2.0}, 48, {{10.0, 1.0}}, {-force, 0.0})},
                        1.3,
                        {},
                        {}};
  StokesProblem with_gauge = problem;
  for (const ClosureForm form : {ClosureForm::scaled_bordered, ClosureForm::reduced}) {
    const Completion without = solve_dense(problem, form);
    for (const double gauge : {1.0, 100.0}) {
      with_gauge.gauge_length = gauge;
      const Completion expected = solve_dense(with_gauge, form);
      for (std::size_t k = 0; k < 2; ++k) {
        BOOST_TEST(distance(without.motions[k], expected.motions[k]) < 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
