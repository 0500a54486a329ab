// Checks the eigenvalues of the reduced operator -1/2 + D - P (03.10). On an ellipse, P moves the
// eigenvalue of the rigid motions from 0 to -1, and the other eigenvalues are those of -1/2 + D,
// which are known in closed form. On a circle, all eigenvalues are -1 or -1/2.

#include <boost/test/unit_test.hpp>

#include "support/problems.hpp"
#include "support/spectra.hpp"

namespace stokesbook::test {
namespace {

constexpr Eigen::Index enough_nodes = 96;

// Returns the eigenvalues of one body's reduced matrix, ascending, and checks that they are real.
Eigen::VectorXd eigenvalues(const Component& body) {
  const StokesProblem problem{{body}, 1.3, {}, {}};
  const Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  const Eigen::VectorXcd values = test::eigenvalues(matrix);
  BOOST_TEST(values.imag().cwiseAbs().maxCoeff() < 1e-7);
  Eigen::VectorXd real = values.real();
  std::sort(real.begin(), real.end());
  return real;
}

// Returns the eigenvalues of -1/2 + D, with the three of the rigid motions moved from 0 to -1.
Eigen::VectorXd exact_eigenvalues(const Ellipse& ellipse) {
  Eigen::VectorXd values =
      ellipse_spectrum(ellipse, Side::fluid_outside, enough_nodes).array() - 0.5;
  values.tail(3).setConstant(-1.0);
  std::ranges::sort(values);
  return values;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(spectrum)

BOOST_AUTO_TEST_CASE(circle) {
  for (const double radius : {1e-3, 1.0, 1e3}) {
    const Pose pose{{radius, 2 * radius}, 0.3};
    const Eigen::VectorXd values = eigenvalues(free_body(Circle{radius}, 32, pose));
    BOOST_TEST((values.head(4).array() + 1.0).abs().maxCoeff() < 1e-13);
    BOOST_TEST((values.tail(60).array() + 0.5).abs().maxCoeff() < 1e-13);
  }
}

// A held circle with Stokeslets of the gauge sqrt(e) a has the same spectrum at any viscosity.
BOOST_AUTO_TEST_CASE(held_circle) {
  const double radius = 0.6;
  const Component body = held_body(Circle{radius}, 32, {{1, 2}}, {});
  for (const double mu : {1.0, 1.3}) {
    const StokesProblem problem{{body}, mu, {}, std::sqrt(std::numbers::e) * radius};
    const Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
    Eigen::VectorXd values = test::eigenvalues(matrix).real();
    std::sort(values.begin(), values.end());
    BOOST_TEST((values.head(4).array() + 1.0).abs().maxCoeff() < 1e-12);
    BOOST_TEST((values.tail(60).array() + 0.5).abs().maxCoeff() < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(ellipses) {
  for (const Ellipse& ellipse : {Ellipse{2, 1}, Ellipse{3, 1}, Ellipse{0.06, 0.01}}) {
    const Eigen::VectorXd values = eigenvalues(free_body(ellipse, enough_nodes, {{1, -2}, 0.8}));
    const Eigen::VectorXd exact = exact_eigenvalues(ellipse);
    // The first eigenvalue beyond the grid's modes changes the results by aliasing.
    const double m = (ellipse.a - ellipse.b) / (ellipse.a + ellipse.b);
    const double tolerance =
        1e-12 + (1 - m * m) * 0.5 * enough_nodes * std::pow(m, enough_nodes / 2 - 1);
    BOOST_TEST((values - exact).cwiseAbs().maxCoeff() < tolerance);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
