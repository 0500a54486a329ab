// Checks the projection P onto the rigid motions of a curve (03.9): P maps rigid motions to
// themselves, is idempotent, is orthogonal in the mean square, and is the same about every centre.

#include "closure/rigid_modes.hpp"

#include <random>

#include <boost/test/unit_test.hpp>

#include "support/problems.hpp"

namespace stokesbook::test {
namespace {

const std::vector<Shape> shapes{Circle{0.4}, Ellipse{2, 0.5}, Star{1, 0.3, 5},
                                Superellipse{1, 0.7, 4}, lopsided_curve()};

ComplexVector random_density(Eigen::Index n) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return ComplexVector::NullaryExpr(n, [&] { return Complex{uniform(random), uniform(random)}; });
}

Curve placed(const Shape& shape) {
  return place(sample(shape, 48, Side::fluid_outside), {2.0, -0.7}, 0.9);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rigid_modes)

BOOST_AUTO_TEST_CASE(returns_rigid_motions) {
  const RigidMotion motion{{0.3, -1.4}, 0.8};
  const Complex centre{1.5, 0.2};
  for (const Shape& shape : shapes) {
    const Curve curve = placed(shape);
    const ComplexVector velocity =
        (motion.velocity + imaginary * motion.omega * (curve.x.array() - centre)).matrix();
    const RigidModes modes(curve, centre);
    BOOST_TEST(distance(modes.project(velocity), motion) < 1e-14);
    BOOST_TEST((modes.at_nodes(motion) - velocity).cwiseAbs().maxCoeff() < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(is_idempotent_and_orthogonal) {
  for (const Shape& shape : shapes) {
    const Curve curve = placed(shape);
    const RigidModes modes(curve, {1.5, 0.2});
    const ComplexVector density = random_density(curve.size());
    const ComplexVector rigid = modes.at_nodes(modes.project(density));
    const ComplexVector rest = density - rigid;
    BOOST_TEST(distance(modes.project(rigid), modes.project(density)) < 1e-14);
    // The rest is orthogonal to every rigid motion, hence the projection of the rest vanishes.
    BOOST_TEST(distance(modes.project(rest), {}) < 1e-14);
    for (const RigidMotion& motion : {RigidMotion{1.0, 0}, {imaginary, 0}, {0.0, 1}}) {
      const ComplexVector mode = modes.at_nodes(motion);
      const double product = mode.cwiseProduct(weights(curve)).dot(rest).real();
      BOOST_TEST(std::abs(product) < 1e-13 * perimeter(curve));
    }
  }
}

// The projected field is the same for every centre. The reported velocities differ, because each
// is the velocity of the field at its own centre.
BOOST_AUTO_TEST_CASE(does_not_depend_on_the_centre) {
  for (const Shape& shape : shapes) {
    const Curve curve = placed(shape);
    const ComplexVector density = random_density(curve.size());
    const Complex c1{2.0, -0.7}, c2{-3.0, 5.0};
    const RigidModes about_c1(curve, c1), about_c2(curve, c2);
    const RigidMotion at_c1 = about_c1.project(density), at_c2 = about_c2.project(density);
    const RigidMotion moved{at_c1.velocity + at_c1.omega * perp(c2 - c1), at_c1.omega};
    BOOST_TEST(distance(moved, at_c2) < 1e-14);
    BOOST_TEST(about_c1.gyration_radius() == about_c2.gyration_radius());
  }
}

BOOST_AUTO_TEST_CASE(gyration_radius) {
  const RigidModes circle(sample(Circle{0.4}, 32, Side::fluid_outside), 0.0);
  BOOST_TEST(circle.gyration_radius() == 0.4, boost::test_tools::tolerance(1e-15));
  // The midpoint rule computes <|x|^2> over a 2:1 ellipse. The mean over the arclength is smaller
  // than (a^2 + b^2) / 2, the mean over the parameter t.
  const RigidModes ellipse(sample(Ellipse{2, 1}, 128, Side::fluid_outside), 0.0);
  double moment = 0.0, length = 0.0;
  const int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.5) / steps;
    const double speed = std::hypot(2 * std::sin(t), std::cos(t));
    moment += speed * (4 * std::cos(t) * std::cos(t) + std::sin(t) * std::sin(t));
    length += speed;
  }
  BOOST_TEST(ellipse.gyration_radius() == std::sqrt(moment / length),
             boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
