// Checks orders and leaf sizes for a tolerance, and the rejection of invalid plans and
// applications.
#include <limits>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "fmm/fmm.hpp"
#include "support/point_sets.hpp"

using namespace stokesbook;
using test::random_vector;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

BOOST_AUTO_TEST_CASE(a_finer_tolerance_takes_a_higher_order) {
  int order = 0;
  for (double tolerance = 0.1; tolerance > 1e-14; tolerance *= 0.1) {
    const FmmSettings settings = FmmSettings::for_tolerance(tolerance);
    BOOST_TEST(settings.order > order);
    BOOST_TEST(break_even(settings) > 0);
    order = settings.order;
  }
  BOOST_TEST(FmmSettings::for_tolerance(1e-300).order == FmmSettings::for_tolerance(1e-14).order);
  BOOST_TEST(FmmSettings::for_tolerance(10.0).order >= 1);
}

BOOST_AUTO_TEST_CASE(bad_settings_are_refused) {
  for (const double bad : {0.0, -1e-6, not_a_number}) {
    BOOST_CHECK_THROW(FmmSettings::for_tolerance(bad), std::invalid_argument);
  }
  const std::vector<Curve> curves = test::ellipses(1, 64);
  for (const FmmSettings& bad : {FmmSettings{0, 10}, FmmSettings{61, 10}, FmmSettings{10, 0}}) {
    BOOST_CHECK_THROW(Fmm(curves, {}, bad), std::invalid_argument);
  }
}

BOOST_AUTO_TEST_CASE(bad_places_are_refused) {
  const FmmSettings settings{10, 10};
  std::vector<Curve> curves = test::ellipses(1, 64);
  const ComplexVector bad{{Complex{0.0, not_a_number}}}, on_a_node{{curves[0].x[7]}};
  BOOST_CHECK_THROW(Fmm(curves, bad, settings), std::invalid_argument);
  BOOST_CHECK_THROW(Fmm(curves, {}, bad, settings), std::invalid_argument);
  BOOST_CHECK_THROW(Fmm(curves, on_a_node, settings), std::invalid_argument);
  BOOST_CHECK_THROW(Fmm({}, bad, bad, settings), std::invalid_argument);
  curves[0].x[3] = not_a_number;
  BOOST_CHECK_THROW(Fmm(curves, {}, settings), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(strengths_of_another_size_are_refused) {
  const std::vector<Curve> curves = test::ellipses(1, 64);
  const ComplexVector points = random_vector(3, 1), density = random_vector(64, 2);
  const Eigen::VectorXd torque = random_vector(3, 3).real();
  const Fmm fmm(curves, points, {10, 10}), other(test::ellipses(1, 32), points, {10, 10});
  FmmWorkspace work = fmm.workspace(), others = other.workspace(), two = fmm.workspace(2);
  BOOST_CHECK_NO_THROW(fmm.velocity({density, points, torque}, work));
  BOOST_CHECK_THROW(fmm.velocity(random_vector(63, 2), work), std::invalid_argument);
  BOOST_CHECK_THROW(fmm.velocity(density, two), std::invalid_argument);
  BOOST_CHECK_THROW(fmm.velocity(density, others), std::invalid_argument);
  BOOST_CHECK_THROW(fmm.velocity({density, random_vector(2, 1), torque}, work),
                    std::invalid_argument);
  BOOST_CHECK_THROW(fmm.velocity({density, points, Eigen::VectorXd()}, work),
                    std::invalid_argument);
  BOOST_CHECK_THROW(fmm.workspace(0), std::invalid_argument);
  // These plans have the same number of nodes, but other boxes or another order.
  const Fmm other_leaves(curves, points, {10, 5}), other_order(curves, points, {11, 10});
  for (const Fmm* plan : {&other_leaves, &other_order}) {
    BOOST_CHECK_THROW(plan->velocity(density, work), std::invalid_argument);
  }
}
