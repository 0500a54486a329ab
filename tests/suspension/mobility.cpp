// Tests that the mobility matrix of any bodies is symmetric and positive definite, in an unbounded
// fluid within a gauge length and in a container.

#include "support/spectra.hpp"
#include "units.hpp"

namespace stokesbook::test {
namespace {

// Returns the motions (U_1, U_2, omega of every body) under unit loads, one column per load, in
// units of one.
Eigen::MatrixXd mobility(Scene scene, const Units& units) {
  const auto size = static_cast<Eigen::Index>(3 * scene.bodies.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index column = 0; column < size; ++column) {
    for (Body& body : scene.bodies) body.force = body.torque = 0.0;
    Body& loaded = scene.bodies[static_cast<std::size_t>(column / 3)];
    if (column % 3 == 2) loaded.torque = 1.0;
    if (column % 3 != 2) loaded.force = column % 3 == 0 ? Complex{1.0} : imaginary;
    const Solved solved(in_units(scene, units));
    for (Eigen::Index k = 0; k < size / 3; ++k) {
      const RigidMotion& motion = solved.motion(static_cast<std::size_t>(k));
      matrix.block<3, 1>(3 * k, column) << motion.velocity.real() / units.velocity(),
          motion.velocity.imag() / units.velocity(), motion.omega / units.rate;
    }
  }
  return matrix;
}

void check_mobility(const Scene& scene) {
  for (const Units& units : two_units) {
    const Eigen::MatrixXd matrix = mobility(scene, units);
    const double largest = matrix.cwiseAbs().maxCoeff();
    BOOST_TEST((matrix - matrix.transpose()).cwiseAbs().maxCoeff() < 1e-12 * largest);
    // The smallest eigenvalue belongs to the body that is hardest to move alone, and is of order 1
    // / (4 pi).
    const Eigen::MatrixXd symmetric = 0.5 * (matrix + matrix.transpose());
    BOOST_TEST(symmetric_eigenvalues(symmetric)[0] > 1e-4);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(mobility_matrices)

BOOST_AUTO_TEST_CASE(unbounded) {
  std::mt19937_64 random(21);
  check_mobility(with_gauge(resolved(scene(random_bodies(random))), 30.0));
}

BOOST_AUTO_TEST_CASE(bounded) {
  std::mt19937_64 random(22);
  const Wall wall = outer_wall(Ellipse{4.2, 3.6}, 0, {}, {0.1, 0.2}, 0.5);
  check_mobility(resolved(scene(random_bodies(random), {}, {wall})));
}

// A container slows down every body: the mobility without it minus the mobility in it is positive
// definite.
BOOST_AUTO_TEST_CASE(a_container_takes_mobility_away) {
  std::mt19937_64 random(23);
  const std::vector<Body> bodies = random_bodies(random);
  const auto in_container = [&](double radius) {
    return mobility(resolved(scene(bodies, {}, {outer_wall(Circle{radius}, 0)})), {});
  };
  const Eigen::MatrixXd taken = in_container(5.0) - in_container(3.5);
  const Eigen::MatrixXd symmetric = 0.5 * (taken + taken.transpose());
  BOOST_TEST(symmetric_eigenvalues(symmetric)[0] > 0.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
