// Checks data with a net flux Q (04.2), which have no solution. The system with N_0 is solvable all
// the same and gives the solution for g - n Q / |Gamma_0| on the wall (04.7). Therefore net_flux()
// must report Q, and the size of Q must not depend on the division of the boundary into curves.

#include <boost/test/unit_test.hpp>

#include "support/walls.hpp"

namespace stokesbook::test {
namespace {

// An inner wall blows fluid in, one body is free, and the outflow through the enclosing wall is too
// small.
StokesProblem leaking() {
  StokesProblem problem{{held_body(Circle{0.5}, 64, {{-1.2, 0.3}}, {}),
                         free_body(Ellipse{0.6, 0.4}, 96, {{0.8, -0.4}, 0.5}, {{0.3, 0.2}, 0.1}),
                         enclosing_wall(Ellipse{3, 2.2}, 128, {{0.1, 0.2}, 0.4})},
                        1.3,
                        {},
                        {}};
  problem.components[0].velocity = -0.8 * normals(problem.components[0].curve);
  const ComplexVector& x = problem.components[2].curve.x;
  problem.components[2].velocity = (0.1 * x.array() + imaginary * x.array().conjugate()).matrix();
  return problem;
}

StokesProblem repaired() {
  StokesProblem problem = leaking();
  Component& wall = problem.components[2];
  wall.velocity -= net_flux(problem) / perimeter(wall.curve) * normals(wall.curve);
  return problem;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(incompatible_data)

// The inner wall's source is -2 pi 0.5 0.8. On the enclosing ellipse of area 6.6 pi the velocity
// 0.1 x has the divergence 0.2, and i conj(x) = (y, x) has no divergence.
BOOST_AUTO_TEST_CASE(net_flux_is_reported) {
  using std::numbers::pi;
  const double exact = -2 * pi * 0.5 * 0.8 + 0.2 * pi * 3 * 2.2;
  BOOST_TEST(net_flux(leaking()) == exact, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(net_flux(repaired())) < 1e-13);
  BOOST_TEST(flux_scale(leaking()) > std::abs(exact));
}

BOOST_AUTO_TEST_CASE(rigid_motions_have_none) {
  for (const Shape& shape : {Shape{Circle{1}}, Shape{Ellipse{2, 1}}, Shape{lopsided_curve()}}) {
    const RigidMotion motion{{0.4, -2}, 1.7};
    const StokesProblem problem{{held_body(shape, 96, {{0.3, 0.1}, 0.7}, motion),
                                 enclosing_wall(Circle{5}, 96, {}, {{1, 2}, 3})},
                                1.0,
                                {},
                                {}};
    BOOST_TEST(std::abs(net_flux(problem)) < 1e-12 * flux_scale(problem));
  }
}

BOOST_AUTO_TEST_CASE(solution_is_that_of_the_repaired_data) {
  const StokesProblem problem = leaking();
  // Any multiple of N_0 gives this solution: the multiple changes the density, not the flow.
  for (const double scale : {1.0, -1.0, -perimeter(problem.components[2].curve)}) {
    const Completion wrong = solve_bounded(problem, ClosureForm::reduced, scale);
    const Completion right = solve_bounded(repaired(), ClosureForm::reduced, scale);
    BOOST_TEST(distance(wrong.motions[1], right.motions[1]) < 1e-13);
    BOOST_TEST(distance(wrong.loads[0], right.loads[0]) < 1e-12);
  }
}

// The density contains the flux: \int_0 n . eta ds = -Q (04.7).
BOOST_AUTO_TEST_CASE(density_carries_the_flux) {
  const auto wall_flux_of_density = [](const StokesProblem& problem) {
    const Eigen::VectorXd solution = solve(assemble_bounded(problem, ClosureForm::reduced));
    const Component& wall = problem.components[2];
    const ComplexVector density = deinterleaved(solution.tail(2 * wall.curve.size()));
    return (normals(wall.curve).conjugate().cwiseProduct(density)).real().dot(weights(wall.curve));
  };
  BOOST_TEST(wall_flux_of_density(leaking()) == -net_flux(leaking()),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(wall_flux_of_density(repaired())) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
