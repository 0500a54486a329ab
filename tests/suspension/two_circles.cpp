// Tests two unit circles at gaps .5, .1, .01 and .001 against the reference numbers C11, C12, N3,
// N3F, N3G of the specification, most of them closed forms. The closer the pair, the more nodes its
// densities need, about 35 / sqrt(gap).

#include "expected.hpp"
#include "support/closed_forms.hpp"

namespace stokesbook::test {
namespace {

// One row of the reference numbers; motions are of the left circle, except in `apart` and `pulled`.
struct Row {
  double gap;
  int n_nodes;
  double apart;                     // C11: U_x of the right circle in u = (x, -y)
  double pulled;                    // C12: U_x of the right circle, forces -+ e_x
  RigidMotion shear;                // N3 in u = (y, 0)
  double shear_s12, extension_s11;  // N3
  RigidMotion opposed;              // N3F: forces +- e_y
  double settling_x;                // N3G: U_x of both circles, forces e_x
  RigidMotion settling_y;           // N3G: forces e_y
};

const Row rows[] = {{.5,
                     64,
                     .39705882352941176,
                     .020051192003185986,
                     {{0, .087077226664962}, -.369661781331970},
                     5.50789512251502,
                     16.0293344210883,
                     {{0, .0979402592686957}, -.0342250873844262},
                     .0203716312447595,
                     {{0, -.0227404986712824}, .0}},
                    {.1,
                     128,
                     .05446640948853668,
                     .002860847034107639,
                     {{0, .157664988452569}, -.302612470846086},
                     5.69598502258849,
                     16.8631930688144,
                     {{0, .0734709197454672}, -.0461047656073429},
                     .0277674420752982,
                     {{0, -.0108066006813395}, .0}},
                    {.01,
                     368,
                     .0019680453757646231,
                     1.0430371657800807e-4,
                     {{0, .206861251836237}, -.255645485395511},
                     5.93646621329877,
                     16.8027745733224,
                     {{0, .0622471416651063}, -.0540225935461096},
                     .0295040520180921,
                     {{0, -.0137956083204431}, .0}},
                    {.001,
                     1168,
                     6.3142954288021558e-5,
                     3.349502805609592e-6,
                     {{0, .22355996598051}, -.23925370372951},
                     6.03395757290491,
                     16.7651182906552,
                     {{0, .0592323273840406}, -.0566876278056451},
                     .0296792840193378,
                     {{0, -.0161026380170581}, .0}}};

Scene pair(const Row& row, const BackgroundFlow& flow, Complex left = {}, Complex right = {}) {
  const double x = 1.0 + row.gap / 2;
  Scene both = scene({body(Circle{1}, row.n_nodes, -x, 0.0, {left, 0.0}),
                      body(Circle{1}, row.n_nodes, x, 0.0, {right, 0.0})},
                     flow);
  return left + right == Complex{} ? both : with_gauge(both, 1.0);
}

// In lubrication, relative motions are small differences, so rounding errors are amplified by 1 /
// gap.
double tolerance_for(const Row& row) {
  return 1e-14 / row.gap;
}

void check_extension(const Row& row, const std::vector<Units>& units) {
  BOOST_TEST((CirclePair{1, row.gap}.speed_in_extension(1)) == row.apart,
             boost::test_tools::tolerance(1e-14));
  const Complex s11 = row.extension_s11;
  check(pair(row, ExtensionalFlow{1}),
        {{0, RigidMotion{-row.apart, 0.0}, {}, s11}, {1, RigidMotion{row.apart, 0.0}, {}, s11}},
        1e-11, units);
}

// Checks errors relative to the small speed itself, as far as rounding allows.
void check_relative_errors(const Row& row) {
  const double tolerance = row.gap > 0.05 ? 1e-12 : row.gap > 0.005 ? 3e-11 : 2e-9;
  const double apart = Solved(pair(row, ExtensionalFlow{1})).motion(1).velocity.real();
  BOOST_TEST(apart == row.apart, boost::test_tools::tolerance(tolerance));
  const double pulled = Solved(pair(row, {}, -1.0, 1.0)).motion(1).velocity.real();
  BOOST_TEST(pulled == row.pulled, boost::test_tools::tolerance(tolerance));
}

void check_pull(const Row& row, const std::vector<Units>& units) {
  BOOST_TEST((CirclePair{1, row.gap}.speed_of_pull(1, 1)) == row.pulled,
             boost::test_tools::tolerance(1e-11));
  check(pair(row, {}, -1.0, 1.0),
        {{0, RigidMotion{-row.pulled, 0.0}, {}, {}}, {1, RigidMotion{row.pulled, 0.0}, {}, {}}},
        tolerance_for(row), units);
}

void check_shear(const Row& row, const std::vector<Units>& units) {
  const Complex s12{0.0, row.shear_s12};
  const RigidMotion mirrored{-row.shear.velocity, row.shear.omega};
  check(pair(row, ShearFlow{1}), {{0, row.shear, {}, s12}, {1, mirrored, {}, s12}}, 1e-11, units);
}

void check_opposed_forces(const Row& row, const std::vector<Units>& units) {
  const RigidMotion mirrored{-row.opposed.velocity, row.opposed.omega};
  check(pair(row, {}, imaginary, -imaginary), {{0, row.opposed, {}, {}}, {1, mirrored, {}, {}}},
        tolerance_for(row), units);
}

void check_equal_forces(const Row& row, const std::vector<Units>& units) {
  const RigidMotion along{row.settling_x, 0.0};
  // The solver estimates rounding errors too, so its tolerance is not smaller than the checked one.
  const auto settling = [&](Complex force) {
    Scene both = pair(row, {}, force, force);
    both.solver.tolerance = std::max(1e-12, tolerance_for(row));
    return both;
  };
  check(settling(1.0), {{0, along, {}, {}}, {1, along, {}, {}}}, tolerance_for(row), units);
  RigidMotion left = row.settling_y, right = row.settling_y;
  left.omega = CirclePair{1, row.gap}.turn_of_settling(1, 1);
  right.omega = -left.omega;
  check(settling(imaginary), {{0, left, {}, {}}, {1, right, {}, {}}}, tolerance_for(row), units);
}

void check_row(const Row& row, const std::vector<Units>& units) {
  check_extension(row, units);
  check_relative_errors(row);
  check_pull(row, units);
  check_shear(row, units);
  check_opposed_forces(row, units);
  check_equal_forces(row, units);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(two_circles)

BOOST_AUTO_TEST_CASE(reference_numbers) {
  check_row(rows[0], two_units);
  check_row(rows[1], two_units);
  check_relative_errors(rows[2]);
  check_shear(rows[2], {{}});
}

BOOST_AUTO_TEST_CASE(reference_numbers_of_close_pairs, *boost::unit_test::label("full")) {
  check_row(rows[2], two_units);
  check_row(rows[3], {{}});
}

// The gap is .001, and the units of length are 1e-3 and 1e3.
BOOST_AUTO_TEST_CASE(closest_pair_in_other_units, *boost::unit_test::label("full")) {
  const Row& row = rows[3];
  check(pair(row, ShearFlow{1}), {{0, row.shear, {}, Complex{0.0, row.shear_s12}}}, 1e-11,
        {{1e-3, 1.3, 2.5}, {1e3, 1, 1}});
}

// The gap, the radii and the angle of the line of centres are random.
BOOST_AUTO_TEST_CASE(closed_forms_at_other_gaps) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 8; ++trial) {
    const CirclePair circles{0.5 + uniform(random), std::pow(10.0, -1.5 * uniform(random))};
    const Complex along = std::polar(1.0, 6 * uniform(random));
    const Complex right = (circles.a + circles.gap / 2) * along;
    const auto speeds = [&](const BackgroundFlow& flow, Complex left_force, Complex right_force) {
      Scene both = scene({body(Circle{circles.a}, 0, -right, 0.0, {left_force, 0.0}),
                          body(Circle{circles.a}, 0, right, 0.0, {right_force, 0.0})},
                         flow);
      return Solved(resolved(with_gauge(both, 1.0))).motion(1);
    };
    // The extension is along the line of centres: u = along^2 conj(x).
    Eigen::Matrix2d gradient;
    const Complex square = along * along;
    gradient << square.real(), square.imag(), square.imag(), -square.real();
    const Complex apart = speeds(LinearFlow{gradient}, 0.0, 0.0).velocity;
    BOOST_TEST(std::abs(apart - circles.speed_in_extension(1) * along) < 1e-11);
    const Complex pulled = speeds({}, -along, along).velocity;
    BOOST_TEST(std::abs(pulled - circles.speed_of_pull(1, 1) * along) < 1e-11);
    const double omega = speeds({}, perp(along), perp(along)).omega;
    BOOST_TEST(std::abs(omega + circles.turn_of_settling(1, 1)) < 1e-11);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
