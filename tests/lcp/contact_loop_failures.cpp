// Checks that the contact loop ends on every input, and that the loop states the reason if it
// fails.
#include <limits>

#include <boost/test/unit_test.hpp>

#include "support/contact_scenes.hpp"

namespace stokesbook::test {

namespace {

// Returns whether every row has a multiplier, a gap, a response and a force gradient.
bool agrees(const ContactResult& result) {
  const auto m = static_cast<Index>(result.keys.size());
  return result.multipliers.size() == m && result.gaps.size() == m && result.response.size() == m &&
         result.force_gradient.rows() == m;
}

bool says(const ContactResult& result, const std::string& words) {
  return result.reason.find(words) != std::string::npos;
}

// A point on a line must not go below 0; the reported gradient is `factor` times too large.
ContactStep misled(double factor) {
  return step_of(VectorXd::Constant(1, -1.0), 1.0, MatrixXd::Identity(1, 1),
                 [factor](const VectorXd& velocity) {
                   RowBuilder builder(1);
                   builder.add({3, 4}, velocity[0], VectorXd::Constant(1, factor));
                   return builder.rows();
                 });
}

}  // namespace

BOOST_AUTO_TEST_CASE(points_that_take_turns_without_earlier_rows) {
  const ContactResult result =
      resolve_contact(rod(vector2(-1.0, 0.3)), {.restore_rows_after = 100});
  BOOST_TEST((result.status == ContactStatus::not_converged));
  BOOST_TEST(agrees(result));
  BOOST_TEST(result.iterations == 8);
  BOOST_TEST(says(result, "after 8 iterations"));
  BOOST_TEST(says(result, "contact 0, point"));
  BOOST_TEST(result.violations.back() > 0.1);
}

BOOST_AUTO_TEST_CASE(a_force_across_an_open_gap) {
  // With half the gradient, the correction of every iteration is twice the required correction.
  const ContactResult result = resolve_contact(misled(0.5), {.restore_rows_after = 100});
  BOOST_TEST((result.status == ContactStatus::open_gap));
  BOOST_TEST(agrees(result));
  BOOST_TEST(result.iterations == 7);
  BOOST_TEST(says(result, "contact 3, point 4"));
  BOOST_TEST(says(result, "acts across a gap of 1 "));
  ContactStep named = misled(0.5);
  named.name = [](const ContactKey& key) { return "bodies of " + std::to_string(key.contact); };
  BOOST_TEST(says(resolve_contact(named, {.restore_rows_after = 100}), "bodies of 3: the force"));
}

BOOST_AUTO_TEST_CASE(a_contact_that_is_gone_is_open) {
  // Every call gives the contact a new key, so the loop cannot find the gap of an earlier force.
  ContactStep step = misled(1.0);
  step.rows = [rows = step.rows, call = 0](const VectorXd& velocity) mutable {
    ContactRows result = rows(velocity);
    result.keys[0].contact = ++call;
    return result;
  };
  const ContactResult result = resolve_contact(step);
  BOOST_TEST((result.status == ContactStatus::open_gap));
  BOOST_TEST(agrees(result));
  BOOST_TEST(result.iterations == 6);
  BOOST_TEST(std::isinf(result.gaps.maxCoeff()));
  BOOST_TEST(says(result, "acts across a contact that has no row any more"));
}

BOOST_AUTO_TEST_CASE(a_slow_gradient_does_not_converge) {
  const ContactResult result = resolve_contact(misled(20.0));
  BOOST_TEST((result.status == ContactStatus::not_converged));
  BOOST_TEST(agrees(result));
  BOOST_TEST(result.iterations == 8);
  for (std::size_t k = 1; k < result.violations.size(); ++k) {
    BOOST_TEST(std::abs(result.violations[k] / result.violations[k - 1] - 0.95) < 1e-6);
  }
  BOOST_TEST(says(result, "contact 3, point 4 by "));
  BOOST_TEST(says(result, "a unit force opens it by "));
}

BOOST_AUTO_TEST_CASE(a_loop_without_iterations_tells_what_the_free_motion_violates) {
  ContactStep step = misled(1.0);
  step.guess = 2.0 * step.free_velocity;
  const ContactResult result = resolve_contact(step, {.max_iterations = 0});
  BOOST_TEST((result.status == ContactStatus::not_converged));
  BOOST_TEST(result.iterations == 0);
  BOOST_TEST((result.velocity == step.free_velocity));
  BOOST_TEST(says(result, "contact 3, point 4 by 1"));
}

BOOST_AUTO_TEST_CASE(a_response_that_the_quadrature_does_not_see) {
  ContactStep step = misled(1.0);
  for (const double response : {-22.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    step.respond = [=](const Eigen::SparseMatrix<double>& forces) -> MatrixXd {
      return response * MatrixXd(forces);
    };
    const ContactResult result = resolve_contact(step);
    BOOST_TEST((result.status == ContactStatus::response_not_seen));
    BOOST_TEST(agrees(result));
    BOOST_TEST(result.iterations == 1);
    BOOST_TEST(says(result, "contact 3, point 4"));
    BOOST_TEST(says(result, "quadrature"));
  }
}

BOOST_AUTO_TEST_CASE(forces_that_cannot_open_their_gaps_together) {
  // Each force opens its own gap and closes the other gap by the same amount.
  const MatrixXd gradient = MatrixXd::Identity(2, 2), forces = matrix2(1.0, -1.0, -1.0, 1.0);
  const ContactStep step =
      step_of(vector2(-1.0, -1.0), 1.0, MatrixXd::Identity(2, 2), [=](const VectorXd& velocity) {
        return ContactRows{velocity, gradient.sparseView(), forces.sparseView(), {{0, 0}, {1, 0}}};
      });
  const ContactResult result = resolve_contact(step);
  BOOST_TEST((result.status == ContactStatus::no_linear_solution));
  BOOST_TEST(agrees(result));
  BOOST_TEST(result.rays == 1);
  BOOST_TEST(says(result, "iteration 1 with 2 rows"));
}

BOOST_AUTO_TEST_CASE(a_solver_that_stalls_is_replaced) {
  const LcpSolver never = [](const LcpProblem& problem, const LcpOptions&) {
    return LcpResult{.z = VectorXd::Zero(problem.offset.size())};
  };
  const ContactResult result = resolve_contact(misled(1.0), {.solver = never});
  BOOST_TEST(resolved(result));
  BOOST_TEST(std::abs(result.velocity[0]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(bad_input_throws) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    ContactStep step = misled(1.0);
    step.dt = bad;
    BOOST_CHECK_THROW(resolve_contact(step), std::invalid_argument);
    step = misled(1.0);
    step.tolerance = bad;
    BOOST_CHECK_THROW(resolve_contact(step), std::invalid_argument);
  }
  ContactStep step = misled(1.0);
  step.rows = [](const VectorXd&) {
    RowBuilder builder(1);
    builder.add({0, 0}, std::numeric_limits<double>::quiet_NaN(), VectorXd::Ones(1));
    return builder.rows();
  };
  BOOST_CHECK_THROW(resolve_contact(step), std::domain_error);
  step.rows = [](const VectorXd&) {
    RowBuilder builder(1);
    builder.add({0, 0}, -1.0, VectorXd::Ones(1));
    builder.add({0, 0}, -2.0, VectorXd::Ones(1));
    return builder.rows();
  };
  BOOST_CHECK_THROW(resolve_contact(step), std::invalid_argument);
  step.rows = [](const VectorXd&) {
    RowBuilder builder(2);
    builder.add({0, 0}, -1.0, VectorXd::Ones(2));
    return builder.rows();
  };
  BOOST_CHECK_THROW(resolve_contact(step), std::invalid_argument);
  step.rows = [](const VectorXd&) {
    RowBuilder builder(1);
    builder.add({0, 0}, -1.0, VectorXd::Ones(1));
    ContactRows rows = builder.rows();
    rows.at_rest = VectorXd::Zero(2);
    return rows;
  };
  BOOST_CHECK_THROW(resolve_contact(step), std::invalid_argument);
  step = misled(1.0);
  step.respond = [](const Eigen::SparseMatrix<double>&) { return MatrixXd::Ones(2, 2).eval(); };
  BOOST_CHECK_THROW(resolve_contact(step), std::invalid_argument);
}

}  // namespace stokesbook::test
