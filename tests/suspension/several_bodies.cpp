// Tests pairs and lattices without a closed form against the reference numbers N4, N6 and N8 of the
// specification, in six systems of units. An independent first-kind method confirmed N4 and N6
// there.

#include "expected.hpp"

namespace stokesbook::test {
namespace {

constexpr double tolerance = 1e-12;

// Returns two 2:1 ellipses at right angles, with a gap between tip and flank.
Scene crossed_ellipses(double gap, int n_nodes, const BackgroundFlow& flow, Complex force = {}) {
  return scene({body(Ellipse{1, .5}, n_nodes, {}, 0.0, {force, 0.0}),
                body(Ellipse{1, .5}, n_nodes, 1.5 + gap, std::numbers::pi / 2, {-force, 0.0})},
               flow);
}

Scene nine_circles(int n_nodes) {
  std::vector<Body> bodies;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      bodies.push_back(body(Circle{.5}, n_nodes, 1.25 * Complex(i, j)));
    }
  }
  return scene(bodies, ShearFlow{1});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(several_bodies)

BOOST_AUTO_TEST_CASE(inclined_circles_N4) {
  const Complex right = std::polar(1.05, std::numbers::pi / 6);
  const RigidMotion left{{-.191091150671344, .283810287569567}, -.401306235423043};
  const RigidMotion mirrored{-left.velocity, left.omega};
  const Complex stresslet{1.18455453206008, 7.74769365645252};
  check(scene({body(Circle{1}, 128, -right), body(Circle{1}, 128, right)}, ShearFlow{1}),
        {{0, left, {}, stresslet}, {1, mirrored, {}, stresslet}}, 1e-11);
}

BOOST_AUTO_TEST_CASE(crossed_ellipses_N6) {
  const RigidMotion first{{0, .106206386485663}, -.0957791978498525};
  const RigidMotion second{{0, -.134805669299893}, -.562088129028852};
  check(
      crossed_ellipses(.1, 192, ShearFlow{1}),
      {{0, first, {}, Complex{0, 3.05945391410270}}, {1, second, {}, Complex{0, 2.62837077262654}}},
      1e-11);
  check(crossed_ellipses(.1, 192, {}, 1.0),
        {{0, RigidMotion{.00826735975392327, 0}, {}, {}},
         {1, RigidMotion{-.00409253909591736, 0}, {}, {}}},
        tolerance);
  check(crossed_ellipses(.01, 512, {}, 1.0),
        {{0, RigidMotion{4.3795142323520e-4, 0}, {}, {}},
         {1, RigidMotion{-2.0843804312089e-4, 0}, {}, {}}},
        tolerance, {{}, {1e3, 1.3, 2.5}});
}

BOOST_AUTO_TEST_CASE(nine_circles_N8) {
  check(nine_circles(96),
        {{0, RigidMotion{{-1.01876278249093, .231237217509065}, -.5}, {}, {}},
         {1, RigidMotion{-1.01750349868220, -.457580377611076}, {}, {}},
         {3, RigidMotion{{0, .232496501317799}, -.542419622388924}, {}, {}},
         {4, RigidMotion{0, -.5}, {}, {}}},
        1e-11);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
