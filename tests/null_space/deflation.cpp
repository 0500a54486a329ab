// Checks that N_0 (04.6) on a wall moves the eigenvalue of the normal from 0 to -1, at any length
// of the wall, and no other eigenvalue: a circle has condition number 2. Without N_0 the matrix is
// singular. With the unscaled term \int n(x) n(y) . eta ds the condition number depends on the
// wall's length, and therefore on the unit of length.

#include <boost/test/unit_test.hpp>

#include "support/spectra.hpp"
#include "support/walls.hpp"

namespace stokesbook::test {
namespace {

Eigen::MatrixXd layer_with_jump(const Curve& wall) {
  const Eigen::Index size = 2 * wall.size();
  return double_layer_matrix(wall) - 0.5 * Eigen::MatrixXd::Identity(size, size);
}

Curve circle(double radius) {
  return place(sample(Circle{radius}, 64, Side::fluid_inside), {0.1 * radius, radius}, 0.2);
}

Eigen::VectorXd sorted_eigenvalues(const Eigen::MatrixXd& matrix) {
  Eigen::VectorXd values = eigenvalues(matrix).real();
  std::sort(values.begin(), values.end());
  return values;
}

const std::vector<Shape> shapes{Circle{3}, Ellipse{2, 1}, Star{1.5, 0.15, 4}, lopsided_curve()};

}  // namespace

BOOST_AUTO_TEST_SUITE(deflation)

BOOST_AUTO_TEST_CASE(singular_without) {
  for (const double radius : {0.03, 3.0, 300.0}) {
    BOOST_TEST(singular_values(layer_with_jump(circle(radius))).minCoeff() < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(condition_number_2_with) {
  for (const double radius : {0.03, 3.0, 300.0}) {
    const Curve wall = circle(radius);
    BOOST_TEST(condition_number(layer_with_jump(wall) + null_space_matrix(wall)) == 2.0,
               boost::test_tools::tolerance(1e-12));
  }
}

// The unscaled term + \int n(x) n(y) . eta ds = -|Gamma_0| N_0 moves the eigenvalue from 0 to the
// wall's length. The condition numbers are 5.3, 38 and 3770.
BOOST_AUTO_TEST_CASE(condition_number_of_the_unscaled_term) {
  const auto condition = [](double radius) {
    const Curve wall = circle(radius);
    return condition_number(layer_with_jump(wall) - perimeter(wall) * null_space_matrix(wall));
  };
  using std::numbers::pi;
  BOOST_TEST(condition(0.03) == 1.0 / (2 * pi * 0.03), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(condition(3.0) == 2 * (2 * pi * 3.0), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(condition(300.0) == 2 * (2 * pi * 300.0), boost::test_tools::tolerance(1e-11));
}

// On any wall n ds is the left null vector of -1/2 + D (04.3), and the left eigenvector of N_0 with
// the eigenvalue -1.
BOOST_AUTO_TEST_CASE(normal_is_deflated) {
  for (const Shape& shape : shapes) {
    const Curve wall = sample(shape, 192, Side::fluid_inside);
    const ComplexVector normal = normals(wall);
    const ComplexVector weighted = normal.cwiseProduct(weights(wall)) / perimeter(wall);
    const Eigen::VectorXd left = interleaved(weighted);
    BOOST_TEST((layer_with_jump(wall).transpose() * left).cwiseAbs().maxCoeff() < 1e-14);
    const Eigen::MatrixXd fix = null_space_matrix(wall);
    BOOST_TEST((fix.transpose() * left + left).cwiseAbs().maxCoeff() < 1e-15);
    BOOST_TEST((null_space_velocity(wall, normal) + normal).cwiseAbs().maxCoeff() < 1e-14);
  }
}

// All other eigenvalues stay: their eigenvectors are orthogonal to n ds, so N_0 vanishes on them.
BOOST_AUTO_TEST_CASE(other_eigenvalues_stay) {
  for (const Shape& shape : {shapes[0], shapes[1]}) {
    const Curve wall = sample(shape, 64, Side::fluid_inside);
    Eigen::VectorXd expected = sorted_eigenvalues(layer_with_jump(wall));
    BOOST_TEST(std::abs(expected.maxCoeff()) < 1e-12);
    expected.tail(1)[0] = -1.0;
    std::sort(expected.begin(), expected.end());
    const Eigen::VectorXd values =
        sorted_eigenvalues(layer_with_jump(wall) + null_space_matrix(wall));
    // Eigenvalues that coalesce at -1/2 have errors of the square root of rounding.
    BOOST_TEST((values - expected).cwiseAbs().maxCoeff() < 1e-7);
  }
}

BOOST_AUTO_TEST_CASE(is_its_matrix_and_a_projection) {
  const Curve wall = place(sample(lopsided_curve(), 64, Side::fluid_inside), {1, 2}, 0.4);
  const ComplexVector density = wall.x.cwiseProduct(wall.x);
  const ComplexVector once = null_space_velocity(wall, density);
  BOOST_TEST(
      (null_space_matrix(wall) * interleaved(density) - interleaved(once)).cwiseAbs().maxCoeff() <
      1e-13);
  BOOST_TEST((null_space_velocity(wall, once) + once).cwiseAbs().maxCoeff() < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
