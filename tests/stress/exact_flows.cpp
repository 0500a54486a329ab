// Checks a solved problem whose walls move as an exact flow does: velocity, stress and traction
// anywhere, at any distance from the boundary, and on the nodes.
#include "support/exact_flows.hpp"

#include <cmath>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "stress/stress.hpp"
#include "stress/traction.hpp"
#include "support/solved_flow.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::ExactFlow;

namespace {

// A star lies in an elliptic container, and both move with the flow. The poles lie in the star and
// beyond the wall.
const Pose star{{0.4, -0.3}, 0.6};
const ExactFlow known_flow{{{star.position + Complex{0.05, 0.1}, {0.3, -0.2}, 0.4},
                            {{3.5, 2.5}, {0.5, 0.8}, -0.6},
                            {{-2.0, 3.5}, {-1.0, 0.4}, 0.3}},
                           0.7};

StokesProblem exact_problem(double mu) {
  Component body = test::held_body(Star{0.8, 0.15, 3}, 256, star, {});
  Component wall = test::enclosing_wall(Ellipse{3.0, 2.0}, 256, {});
  body.velocity = known_flow.velocity(body.curve.x);
  wall.velocity = known_flow.velocity(wall.curve.x);
  return {{body, wall}, mu, {}, {}};
}

struct Errors {
  double velocity = 0.0, derivatives = 0.0;
};

// Returns the largest errors relative to the largest values on the boundary. The pressure has a
// free constant, so the function compares pressure differences.
Errors errors_at(const SolvedFlow& solved, const ComplexVector& targets) {
  const std::vector<FlowDerivatives> found = solved.derivatives(targets);
  const ComplexVector velocity = solved.velocity(targets);
  const Complex far{-1.5, 0.5};
  const FlowDerivatives reference = solved.derivatives(ComplexVector{{far}})[0];
  const double datum = reference.pressure - known_flow.pressure(far);
  Errors errors;
  for (Index i = 0; i < targets.size(); ++i) {
    const Complex z = targets[i];
    const FlowDerivatives& at = found[static_cast<std::size_t>(i)];
    errors.velocity = std::max(errors.velocity, std::abs(velocity[i] - known_flow.velocity(z)));
    errors.derivatives =
        std::max({errors.derivatives, std::abs(at.pressure - known_flow.pressure(z) - datum),
                  std::abs(at.vorticity - known_flow.vorticity(z)),
                  std::abs(at.strain - known_flow.strain(z))});
  }
  double speed = 0.0, strain = 0.0;
  for (const Complex z : solved.nodes()) {
    speed = std::max(speed, std::abs(known_flow.velocity(z)));
    strain = std::max(strain, std::abs(known_flow.strain(z)));
  }
  return {errors.velocity / speed, errors.derivatives / strain};
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_at_any_distance) {
  const SolvedFlow solved = test::solve_flow(exact_problem(1.0));
  for (const Component& component : solved.problem().components) {
    for (double distance : {0.3, 1e-1, 1e-2, 1e-4, 1e-7, 1e-10, 0.0}) {
      BOOST_TEST_CONTEXT("distance " << distance) {
        const ComplexVector targets = component.curve.x - distance * normals(component.curve);
        const Errors errors = errors_at(solved, targets);
        BOOST_TEST(errors.velocity < 1e-12);
        BOOST_TEST(errors.derivatives < 1e-10);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(traction_on_the_boundary) {
  for (double mu : {1.0, 1.3}) {
    const SolvedFlow solved = test::solve_flow(exact_problem(mu));
    const std::vector<FlowDerivatives> at_nodes = solved.derivatives(solved.nodes());
    const ComplexVector traction = boundary_traction(solved.problem(), at_nodes);
    ComplexVector exact(traction.size()), normal(traction.size());
    Index first = 0;
    for (const Component& component : solved.problem().components) {
      for (const Complex n : normals(component.curve)) {
        exact[first] = mu * known_flow.traction(solved.nodes()[first], n);
        normal[first] = n;
        ++first;
      }
    }
    // The free constant of the pressure is the same on all components.
    const Complex datum = (traction[0] - exact[0]) / normal[0];
    BOOST_TEST(std::abs(datum.imag()) < 1e-10 * test::largest(exact));
    BOOST_TEST(test::largest(traction - exact - datum.real() * normal) <
               1e-10 * test::largest(exact));
    // The flow has neither a force nor a torque.
    for (const Load& load : integrated_loads(solved.problem(), traction)) {
      BOOST_TEST(std::abs(load.force) < 1e-11 * mu);
      BOOST_TEST(std::abs(load.torque) < 1e-11 * mu);
    }
  }
}

BOOST_AUTO_TEST_CASE(wants_the_cauchy_scheme_and_all_nodes) {
  const StokesProblem problem = exact_problem(1.0);
  const Index n = node_offsets(problem).back();
  const SolvedFlow plain(problem, {}, ComplexVector::Zero(n));
  BOOST_CHECK_THROW(plain.derivatives(ComplexVector::Zero(1)), std::invalid_argument);
  BOOST_CHECK_THROW(boundary_traction(problem, std::vector<FlowDerivatives>(3)),
                    std::invalid_argument);
}
