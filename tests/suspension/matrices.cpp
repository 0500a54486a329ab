// Tests the resistance and mobility matrices of free bodies against closed forms for one and two
// bodies, and by symmetry, definiteness and their product, which are computed by separate solves.

#include "suspension/solver/matrices.hpp"

#include <numbers>

#include "support/closed_forms.hpp"
#include "support/dense.hpp"
#include "support/spectra.hpp"
#include "text/word_list.hpp"
#include "units.hpp"

namespace stokesbook::test {
namespace {

using Eigen::MatrixXd;

using std::numbers::pi;

void check_close(const MatrixXd& computed, const MatrixXd& exact, double tolerance) {
  BOOST_TEST((computed - exact).cwiseAbs().maxCoeff() < tolerance * exact.cwiseAbs().maxCoeff());
}

void check_properties(const HydrodynamicMatrices& matrices, double tolerance) {
  const auto [resistance_asymmetry, mobility_asymmetry, inverse_error] = matrix_errors(matrices);
  BOOST_TEST(resistance_asymmetry < tolerance);
  BOOST_TEST(mobility_asymmetry < tolerance);
  BOOST_TEST(inverse_error < tolerance);
  BOOST_TEST(symmetric_eigenvalues(matrices.resistance)[0] > 0.0);
  BOOST_TEST(symmetric_eigenvalues(matrices.mobility)[0] > 0.0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(matrices)

// In the middle of a circular container of radius b, a disk of radius a has the mobilities
// [log(b / a) - (b^2 - a^2) / (b^2 + a^2)] / (4 pi mu) and (1 / a^2 - 1 / b^2) / (4 pi mu). Loads,
// motions, the slip of the disk and the container's own motion in the scene have no effect.
BOOST_AUTO_TEST_CASE(disk_in_a_container) {
  const double a = 0.8, b = 2.0, mu = 1.3, a2 = a * a, b2 = b * b;
  Scene one = scene({body(Circle{a}, 64, {}, 0.4, {{3.0, 1.0}, -2.0})}, {},
                    {outer_wall(Circle{b}, 96, RotatingWall{0.7})});
  one.viscosity = mu;
  one.bodies[0].slip = Squirmer{{0.5}};
  const double along = std::log(b / a) - (b2 - a2) / (b2 + a2);
  const MatrixXd exact =
      Eigen::Vector3d(along, along, 1.0 / a2 - 1.0 / b2).asDiagonal().toDenseMatrix() /
      (4.0 * pi * mu);
  const HydrodynamicMatrices found = hydrodynamic_matrices(one);
  check_close(found.mobility, exact, 1e-12);
  check_close(found.resistance, inverse(exact), 1e-12);
}

// The turned ellipse couples the two directions. The gauge length exceeds twice its size.
BOOST_AUTO_TEST_CASE(ellipse_with_a_gauge_length) {
  const Ellipse ellipse{1.5, 0.6};
  const double gauge = 7.0;
  MatrixXd exact(3, 3);
  for (int j = 0; j < 3; ++j) {
    const Load load{j == 0 ? Complex{1.0} : j == 1 ? imaginary : 0.0, j == 2 ? 1.0 : 0.0};
    const auto [velocity, omega] = loaded_ellipse(ellipse, 0.5, load, 1.0, gauge);
    exact.col(j) << velocity.real(), velocity.imag(), omega;
  }
  const auto found =
      hydrodynamic_matrices(with_gauge(scene({body(ellipse, 128, {2.0, 1.0}, 0.5)}), gauge));
  check_close(found.mobility, exact, 1e-12);
  check_close(found.resistance, inverse(exact), 1e-11);
}

BOOST_AUTO_TEST_CASE(pair_of_disks) {
  const CirclePair circles{1.0, 0.3};
  const double x = 1.0 + 0.5 * circles.gap;
  Scene pair = with_gauge(scene({body(Circle{1}, 128, -x), body(Circle{1}, 128, x)}), 10.0);
  pair.solver.tolerance = 1e-11;
  const HydrodynamicMatrices found = hydrodynamic_matrices(pair);
  Eigen::VectorXd apart = Eigen::VectorXd::Zero(6), across = apart;
  apart[0] = -1.0, apart[3] = 1.0;
  across[1] = across[4] = 1.0;
  BOOST_TEST((found.mobility * apart)[3] == circles.speed_of_pull(1, 1),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST((found.mobility * across)[2] == circles.turn_of_settling(1, 1),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST((found.resistance * (found.mobility * apart))[3] == 1.0,
             boost::test_tools::tolerance(1e-9));
  check_properties(found, 1e-9);
}

// The matrices leave out the held body, which is at rest although the scene moves it, and which
// bears the forces of the other two: no gauge length is required.
BOOST_AUTO_TEST_CASE(symmetry_and_inverse) {
  std::mt19937_64 random(41);
  Scene enclosed = scene(random_bodies(random), {}, {outer_wall(Ellipse{4.2, 3.6}, 0)});
  Scene supported = scene(random_bodies(random));
  supported.bodies[1].held = true;
  supported.bodies[1].velocity = {1.0, 2.0};
  for (Scene* tested : {&enclosed, &supported}) {
    tested->solver.tolerance = 1e-7;
    check_properties(hydrodynamic_matrices(*tested), 1e-6);
  }
  const HydrodynamicMatrices two = hydrodynamic_matrices(supported);
  BOOST_TEST(two.bodies == (std::vector<std::size_t>{0, 2}), boost::test_tools::per_element());
  const std::string text = mobility_table(two);
  BOOST_TEST(text.starts_with("row,fx0,fy0,torque0,fx2,fy2,torque2\nux0,"));
  BOOST_TEST(split(text, '\n').size() == 8U);
  BOOST_TEST(resistance_table(two).find("\ntorque2,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(refusals) {
  const auto mentions = [](const char* word) {
    return [=](const SolverError& error) {
      return std::string(error.what()).find(word) != std::string::npos;
    };
  };
  BOOST_CHECK_EXCEPTION(hydrodynamic_matrices(scene({body(Circle{1}, 32, {})})), SolverError,
                        mentions("flow.gauge_length"));
  BOOST_CHECK_EXCEPTION(hydrodynamic_matrices(scene({held_body(Circle{1}, 32, {})})), SolverError,
                        mentions("free bodies"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
